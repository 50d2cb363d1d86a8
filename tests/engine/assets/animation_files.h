// glTF files that move: nodes, samplers and channels, and a triangle held by two bones.
#pragma once

#include "tests/engine/assets/fixture.h"

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace plumbline::assets::test {

/// The triangle in a node of its own ("arm") below another ("base", at x = 10).
inline TriangleFile two_nodes() {
    TriangleFile file;
    file.json["nodes"] = {{{"name", "base"}, {"translation", {10, 0, 0}}, {"children", {1}}},
                          {{"name", "arm"}, {"mesh", 0}}};
    return file;
}

/// A sampler of the numbers given; its number.
inline std::size_t add_sampler(TriangleFile& file,
                               std::initializer_list<float> times,
                               std::initializer_list<float> values,
                               const char* type,
                               const char* interpolation = "LINEAR") {
    std::string input;
    std::string output;
    append_bytes<float>(input, times);
    append_bytes<float>(output, values);
    const std::size_t width = type == std::string_view("VEC4") ? 4 : type[0] == 'V' ? 3 : 1;
    const std::size_t in = file.add_accessor(input, 5126, static_cast<int>(times.size()), "SCALAR");
    const std::size_t out =
        file.add_accessor(output, 5126, static_cast<int>(values.size() / width), type);
    Json& samplers = file.json["animations"][0]["samplers"];
    samplers.push_back({{"input", in}, {"output", out}, {"interpolation", interpolation}});
    return samplers.size() - 1;
}

inline void add_channel(TriangleFile& file, std::size_t sampler, int node, const char* path) {
    file.json["animations"][0]["channels"].push_back(
        {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}});
}

/// The triangle held by two bones at the origin: corner 0 by the first, 1 by the second, 2 by both.
inline TriangleFile skinned() {
    TriangleFile file;
    std::string joints;
    std::string weights;
    append_bytes<std::uint8_t>(joints, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    append_bytes<float>(weights, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
    file.attributes()["JOINTS_0"] = file.add_accessor(joints, 5121, 3, "VEC4");
    file.attributes()["WEIGHTS_0"] = file.add_accessor(weights, 5126, 3, "VEC4");
    file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {5, 5, 5}}},
                          {{"name", "still bone"}},
                          {{"name", "moving bone"}, {"translation", {0, 0, 2}}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    std::string matrices;
    append_bytes<float>(matrices, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    append_bytes<float>(matrices, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1});
    file.json["skins"] = {{{"joints", {1, 2}},
                           {"inverseBindMatrices", file.add_accessor(matrices, 5126, 2, "MAT4")}}};
    file.json["animations"] = Json::array({Json::object()});
    add_channel(file, add_sampler(file, {0, 1}, {0, 0, 2, 0, 4, 2}, "VEC3"), 2, "translation");
    return file;
}

inline void expect_near(const Vec3f& value, const Vec3f& expected) {
    EXPECT_NEAR(glm::length(value - expected), 0, 1e-5)
        << value.x << ' ' << value.y << ' ' << value.z;
}

}  // namespace plumbline::assets::test
