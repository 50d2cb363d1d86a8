// A linear look at TOML text before the parser sees it, for what would cost the parser its stack.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

/// What is wrong and where; line and column count from 1.
struct TextFault {
    std::string message;
    int line{0};
    int column{0};
};

/// Refuses text nested deeper, keys with more dotted parts or lines longer than limits.h allows, and
/// table headers that the parser would stumble over. All other syntax is the parser's.
std::optional<TextFault> prescan_toml(std::string_view text);

}  // namespace plumbline
