#include "engine/core/text/toml_text.h"

#include <fmt/format.h>

namespace plumbline {

std::string toml_text(std::string_view text) {
    std::string written;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            written += fmt::format("\\{}", letter);
        else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F)
            written += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
        else
            written += letter;
    }
    return fmt::format("\"{}\"", written);
}

}  // namespace plumbline
