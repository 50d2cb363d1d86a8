#include "engine/scene/formats/json_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace plumbline::scene {
namespace {

/// Before anything is built. A text that is no JSON is the parser's to refuse.
std::size_t depth_of(std::string_view text) {
    std::size_t depth = 0;
    std::size_t deepest = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (in_text) {
            if (letter == '\\') ++i;
            if (letter == '"') in_text = false;
            continue;
        }
        if (letter == '"') in_text = true;
        if (letter == '[' || letter == '{') deepest = std::max(deepest, ++depth);
        if ((letter == ']' || letter == '}') && depth > 0) --depth;
    }
    return deepest;
}

}  // namespace

void refuse_deep_json(std::string_view text) {
    if (depth_of(text) > kJsonDepth)
        throw std::runtime_error(fmt::format("it nests deeper than {} levels", kJsonDepth));
}

}  // namespace plumbline::scene
