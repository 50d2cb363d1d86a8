// Which parts of a shader's code a variant of it has.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace plumbline::render {

/// Bits of one shader; each shader has its own list of them.
using FeatureSet = std::uint64_t;

/// A bit, and the macro that is defined as 1 where a variant has it.
struct Feature {
    FeatureSet bit{0};
    std::string_view macro;
};

/// A vertex and a fragment shader by file name, e.g. {"mesh.vert", "mesh.frag"}, and their features.
struct ShaderPair {
    const char* vertex;
    const char* fragment;
    std::span<const Feature> features{};
};

}  // namespace plumbline::render
