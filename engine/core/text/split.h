// Text in parts.
#pragma once

#include <algorithm>
#include <string_view>

namespace plumbline {

/// Cuts off what stands before the next separator, all of it where there is none, and the separator.
inline std::string_view cut_part(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

}  // namespace plumbline
