// Which parts of a shader's code a variant of it has.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace plumbline::render {

/// Bits of one shader; each shader has its own list of them.
using FeatureSet = std::uint64_t;

/// A bit by its number, and the macro that is defined as 1 where a variant has it.
struct Feature {
    unsigned int bit{0};
    std::string_view macro;

    constexpr operator FeatureSet() const { return FeatureSet{1} << bit; }
    constexpr FeatureSet when(bool has) const { return has ? *this : FeatureSet{0}; }
};

/// A vertex and a fragment shader by file name, e.g. {"mesh.vert", "mesh.frag"}, and their features.
struct ShaderPair {
    const char* vertex;
    const char* fragment;
    std::span<const Feature> features{};
};

}  // namespace plumbline::render
