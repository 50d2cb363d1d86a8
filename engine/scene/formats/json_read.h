// JSON from outside: recordings, kept studies, what worker processes say.
#pragma once

#include <cstddef>
#include <string_view>

namespace plumbline::scene {

/// Far more than anything that we write: a study's findings go six deep.
inline constexpr std::size_t kJsonDepth = 32;

/// Throws std::exception where the text nests deeper than kJsonDepth: reading, copying and dropping
/// a value go as deep as it does, and a file may not choose our stack.
void refuse_deep_json(std::string_view text);

/// As nlohmann::json (or ordered_json). Throws std::exception where the text is no JSON, or nests
/// too deep.
template <class Json>
Json read_json(std::string_view text) {
    refuse_deep_json(text);
    return Json::parse(text);
}

}  // namespace plumbline::scene
