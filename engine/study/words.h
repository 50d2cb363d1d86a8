// Words for the values of enums, as JSON and tables for people show them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace plumbline::study {

/// Of every value of an enum, in order.
template <class Enum>
inline constexpr std::array<std::string_view, 0> kWords{};

template <class Enum>
constexpr std::string_view word_of(Enum value) {
    return kWords<Enum>.at(static_cast<std::size_t>(value));
}

}  // namespace plumbline::study
