// glTF animations and skins: what is refused, what is left out alone.
#include "tests/engine/assets/animation_files.h"

#include <cmath>
#include <functional>

namespace plumbline::assets::test {
namespace {

TEST(GltfAnimations, that_is_no_good_is_left_out_alone) {
    TriangleFile file = two_nodes();
    file.json["animations"] = Json::array({Json::object()});
    add_channel(file, add_sampler(file, {1, 1}, {0, 0, 0, 1, 1, 1}, "VEC3"), 1, "translation");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_TRUE(import.model.value().animations.empty());
    EXPECT_TRUE(contains(import.log,
                         "animation \"animation 1\" is left out: animations[0].samplers[0].input: "
                         "times must rise from 0; number 1 is 1"))
        << import.log;
}

TEST(GltfSkins, that_names_a_node_which_is_not_there_is_refused) {
    TriangleFile file = skinned();
    file.json["skins"][0]["joints"] = {1, 7};
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(contains(import.error(), "skins[0].joints names node 7 of 3")) << import.error();
}

/// Gives the first sampler other times.
void sampler_of_times(TriangleFile& file, std::initializer_list<float> times) {
    std::string input;
    append_bytes<float>(input, times);
    file.json["animations"][0]["samplers"][0]["input"] =
        file.add_accessor(input, 5126, static_cast<int>(times.size()), "SCALAR");
}

/// Why an animation with one channel was left out.
std::string animation_fault(const std::function<void(TriangleFile&)>& spoil) {
    TriangleFile file = two_nodes();
    file.json["animations"] = {{{"name", "a"}}};
    add_channel(file, add_sampler(file, {0, 1}, {0, 0, 0, 1, 1, 1}, "VEC3"), 1, "translation");
    spoil(file);
    const Import import = import_bytes(file.gltf());
    EXPECT_TRUE(import.ok()) << import.error();
    const std::size_t why = import.log.find("\"a\" is left out: ");
    if (why == std::string::npos) return import.log;
    return import.log.substr(why + 17, import.log.find('\n', why) - why - 17);
}

TEST(GltfAnimations, say_what_is_wrong_with_them) {
    const auto sampler = [](TriangleFile& f) -> Json& {
        return f.json["animations"][0]["samplers"][0];
    };
    EXPECT_EQ(animation_fault([&](auto& f) { sampler(f)["interpolation"] = "BEZIER"; }),
              "animations[0].samplers[0].interpolation is \"BEZIER\"");
    EXPECT_EQ(animation_fault([&](auto& f) { sampler(f).erase("output"); }),
              "animations[0].samplers[0].output is missing");
    EXPECT_EQ(animation_fault([&](auto& f) { sampler(f)["input"] = sampler(f)["output"]; }),
              "animations[0].samplers[0].input: VEC3 of component type 5126 is not read");
    EXPECT_EQ(animation_fault([&](auto& f) { sampler(f)["interpolation"] = "CUBICSPLINE"; }),
              "animations[0].samplers[0] has 2 times, and 6 numbers where 18 belong");
    const auto channel = [](TriangleFile& f) -> Json& {
        return f.json["animations"][0]["channels"][0];
    };
    EXPECT_EQ(animation_fault([&](auto& f) { channel(f).erase("target"); }),
              "animations[0].channels[0].target is missing or not an object");
    EXPECT_EQ(animation_fault([&](auto& f) { channel(f)["target"]["path"] = "rotation"; }),
              "animations[0].samplers[0] has 2 times, and 6 numbers where 8 belong");
    EXPECT_EQ(animation_fault([](auto& f) {
                  sampler_of_times(f, {-1, 1});
              }),
              "animations[0].samplers[0].input: times must rise from 0; number 0 is -1");
    EXPECT_EQ(animation_fault([](auto& f) {
                  sampler_of_times(f, {0, INFINITY});
              }),
              "animations[0].samplers[0].input holds numbers that are not finite");
}

TEST(GltfAnimations, read_over_channels_of_others) {
    for (const char* target : {R"({"path": "pointer", "node": 1})",
                               R"({"path": "translation"})",
                               R"({"path": "weights", "node": 1})"}) {  // it has no targets
        TriangleFile file = two_nodes();
        file.json["animations"] = Json::array({Json::object()});
        const std::size_t sampler = add_sampler(file, {0, 2}, {0, 0, 0, 1, 1, 1}, "VEC3");
        add_channel(file, sampler, 1, "scale");
        file.json["animations"][0]["channels"].push_back(
            {{"sampler", sampler}, {"target", Json::parse(target)}});
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        ASSERT_EQ(import.model.value().animations.size(), 1U) << target;
        const ModelAnimation& animation = import.model.value().animations[0];
        ASSERT_EQ(animation.channels.size(), 1U) << target;
        EXPECT_EQ(animation.channels[0].path, ChannelPath::Scale);
        EXPECT_EQ(animation.duration_s, 2.0F);
        EXPECT_EQ(import.log, "");
    }
}

TEST(GltfSkins, need_a_matrix_for_each_joint_and_joints_of_the_scene) {
    TriangleFile few = skinned();
    few.json["accessors"][few.json["skins"][0]["inverseBindMatrices"].get<std::size_t>()]["count"] =
        1;
    expect_refused(few, "skins[0].inverseBindMatrices has 1 matrices for 2 joints");
    TriangleFile outside = skinned();
    outside.json["scenes"][0]["nodes"] = {0, 1};
    expect_refused(outside, "skins[0].joints names node 2, which the scene does not hold");
    TriangleFile plain = skinned();
    plain.json["skins"][0].erase("inverseBindMatrices");
    const Import import = import_bytes(plain.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.model.value().skins.size(), 1U);
    EXPECT_EQ(import.model.value().skins[0].joints, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(import.model.value().skins[0].joint_from_mesh,
              (std::vector<Mat4f>{Mat4f{1.0F}, Mat4f{1.0F}}));
}

}  // namespace
}  // namespace plumbline::assets::test
