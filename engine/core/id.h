// Names for things that another module owns.
#pragma once

#include <compare>
#include <cstdint>

namespace plumbline {

/// Index and generation of an object; a default-made id names none. Copy freely: it owns nothing.
/// `Tag` only keeps kinds of ids apart.
template <class Tag>
struct Id {
    std::uint32_t index{0};
    std::uint32_t generation{0};  ///< 0 is never alive

    explicit operator bool() const { return generation != 0; }
    friend auto operator<=>(const Id&, const Id&) = default;
};

}  // namespace plumbline
