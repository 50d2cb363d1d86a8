// Text as TOML files have it.
#pragma once

#include <string>
#include <string_view>

namespace plumbline {

/// A basic string, with its quotation marks.
std::string toml_text(std::string_view text);

}  // namespace plumbline
