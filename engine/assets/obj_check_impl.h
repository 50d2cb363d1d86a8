// What the OBJ and the MTL reader share: lines, words, numbers. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

/// The next line without its end, joined where a backslash ends it; nothing at the end of text.
std::optional<std::string> next_line(std::string_view& text);
/// Cuts the first word off the line, with the blanks around it.
std::string_view next_word(std::string_view& line);
/// The text without blanks at either end.
std::string_view trimmed(std::string_view text);
/// The whole word as a number that a float can hold, not NaN and not infinite.
std::optional<float> finite_number(std::string_view word);

/// Reads one .mtl. The error is for files outside the root; what is merely odd is logged.
Result<std::vector<MaterialData>> read_mtl(const std::filesystem::path& file,
                                           const std::string& name,
                                           ModelReferences& references);

}  // namespace plumbline::assets
