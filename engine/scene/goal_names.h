// Which bodies a goal's names mean.
#pragma once

#include <optional>
#include <string_view>

namespace plumbline::scene {

/// Of "can.*", which means all names that begin so: "can."; of a name that means one body: nothing.
inline std::optional<std::string_view> stem_of(std::string_view wanted) {
    if (!wanted.ends_with(".*")) return {};
    return wanted.substr(0, wanted.size() - 1);
}

inline bool matches_pattern(std::string_view name, std::string_view wanted) {
    const std::optional<std::string_view> stem = stem_of(wanted);
    return stem ? name.starts_with(*stem) : name == wanted;
}

}  // namespace plumbline::scene
