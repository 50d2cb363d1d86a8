#include "engine/core/text/json_depth.h"

#include <algorithm>

namespace plumbline {

std::size_t json_depth(std::string_view text) {
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

}  // namespace plumbline
