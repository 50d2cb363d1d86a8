// glTF files as scenes: what they stand on, what is refused, what our exporter put beside.
#include "engine/scene/gltf_scene/gltf_export.h"
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

namespace plumbline::scene::gltf {
namespace {

bool has(const SceneDescription& scene, std::string_view name) {
    return std::ranges::find(scene.entities, name, &EntityDescription::name) !=
           scene.entities.end();
}

TEST(GltfScene, StandsOnItsOwnGroundOrOnTheStage) {
    PhysicsFile file;
    file.add_ball("ball", {0, 5, 0}, {{"mass", 1}});
    const ReadGltf alone = file.read();
    ASSERT_TRUE(alone.scene.ok()) << alone.said();
    EXPECT_TRUE(has(*alone, "ground"));
    EXPECT_FALSE(alone->shows_model) << "things in it move";
    PhysicsFile weightless;
    weightless.add_ball("ball", {0, 5, 0}, {{"gravityFactor", 0}});
    EXPECT_FALSE(has(*weightless.read(), "ground")) << "nothing falls";
    file.add_body("floor", {0, 0, 0}, {{"collider", PhysicsFile::collider(file.add_box(9, 1, 9))}});
    const ReadGltf floored = file.read();
    EXPECT_FALSE(has(*floored, "ground"));
    EXPECT_TRUE(has(*floored, "floor"));
    EXPECT_TRUE(floored->has_camera);
}

TEST(GltfScene, WithoutPhysicsIsAModel) {
    PhysicsFile file;
    const std::size_t mesh = file.add_cube_mesh();
    file.add_node({{"mesh", mesh}});
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_TRUE(read->shows_model);
}

// The drafts of 2024: other names of the extensions, shapes and limits named otherwise.
TEST(GltfScene, ReadsTheDraftsOf2024) {
    const ReadGltf read = PhysicsFile().read_text(R"({
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_rigid_bodies", "KHR_collision_shapes"],
        "extensions": {
            "KHR_collision_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 2, 1]}}]},
            "KHR_rigid_bodies": {"physicsJointLimits": [{"limits": [{"linearAxes": [0, 1, 2], "min": 0, "max": 0}]}]}},
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": "box", "extensions": {"KHR_rigid_bodies": {"motion": {"mass": 2}, "collider": {"shape": 0},
                "joint": {"connectedNode": 1, "jointLimits": 0, "enableCollision": true}}}},
            {"name": "hook"}]})");
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read.shape<physics::BoxShape>("box").size_m, Vec3(1, 2, 1));
    ASSERT_EQ(read->joints.size(), 1U);
    EXPECT_EQ(read->joints[0].b, "world");
}

TEST(GltfScene, RefusesWhatIsBad) {
    const auto why = [](const auto& spoil) {
        PhysicsFile file;
        file.add_ball("ball", {0, 5, 0}, {{"mass", 1}});
        spoil(file.json);
        const ReadGltf read = file.read();
        EXPECT_FALSE(read.scene.ok());
        return read.said();
    };
    const auto ext = [](Json& root) -> Json& {
        return root["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"];
    };
    const auto said = [](const std::string& text, std::string_view part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    said(why([&](Json& root) { ext(root)["motion"]["mass"] = -1; }), "motion.mass is below 0");
    said(why([&](Json& root) { ext(root)["motion"]["mass"] = nullptr; }), "mass is not a number");
    said(why([&](Json& root) {
             ext(root)["motion"]["linearVelocity"] = {0, nullptr, 0};
         }),
         "linearVelocity must be 3 numbers");
    said(why([&](Json& root) { ext(root)["collider"]["geometry"]["shape"] = 7; }),
         "names number 7 of 1");
    said(why([&](Json& root) { ext(root)["collider"]["geometry"] = Json::object(); }),
         "names no shape and no node");
    said(why([&](Json& root) {
             root["extensions"]["KHR_implicit_shapes"]["shapes"][0]["sphere"]["radius"] = 0;
         }),
         "radius must be a length above 0");
    said(why([&](Json& root) {
             root["extensions"]["KHR_implicit_shapes"]["shapes"][0]["type"] = "torus";
         }),
         "has the type \"torus\"");
    said(why([&](Json& root) {
             ext(root)["joint"] = {{"connectedNode", 0}, {"joint", 0}};
         }),
         "names number 0 of 0");
    said(why([&](Json& root) { root["nodes"][0]["children"] = {0}; }), "cycle");
}

// Not JSON at all: what a careless exporter writes for what is not a number.
TEST(GltfScene, RefusesNaN) {
    PhysicsFile file;
    file.add_ball("ball", {0, 5, 0}, {{"mass", 12345}});
    std::string text = file.text();
    text.replace(text.find("12345"), 5, "  NaN");
    const ReadGltf read = file.read_text(text);
    EXPECT_FALSE(read.scene.ok());
    EXPECT_NE(read.said().find("its JSON is bad"), std::string::npos) << read.said();
}

TEST(GltfScene, TakesItsSurroundingsFromWhatOurExporterWrote) {
    PhysicsFile file;
    file.add_ball("ball", {0, 5, 0}, {{"mass", 1}});
    file.json["extras"]["plumbline"] = {
        {"scene", {{"title", "Moon"}}},
        {"world", {{"gravity_mps2", {0, -1.62, 0}}}},
        {"camera", {{"position_m", {0, 2, 9}}, {"target_m", {0, 1, 0}}}}};
    file.json["nodes"][0]["extras"]["plumbline"] = {
        {"body", {{"can_sleep", false}, {"linear_damping_per_s", 0.5}}}};
    const ReadGltf read = file.read();
    ASSERT_TRUE(read.scene.ok()) << read.said();
    EXPECT_EQ(read->title, "Moon");
    EXPECT_EQ(read->gravity_mps2, Vec3(0, -1.62_r, 0));
    EXPECT_FALSE(read->sun) << "as the file says";
    EXPECT_FALSE(read.body("ball").can_sleep);
    EXPECT_EQ(read.body("ball").linear_damping_per_s, 0.5_r);
    file.json["extras"]["plumbline"]["world"]["gravty_mps2"] = 1;
    const ReadGltf wrong = file.read();
    EXPECT_FALSE(wrong.scene.ok());
    EXPECT_NE(wrong.said().find("gravty_mps2"), std::string::npos) << wrong.said();
}

}  // namespace
}  // namespace plumbline::scene::gltf
