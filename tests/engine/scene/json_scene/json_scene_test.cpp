// JSON scenes of the viewer: every number of their source's worked checks, and what they say wrongly.
#include "tests/engine/scene/json_scene/json_scene_fixture.h"

#include <algorithm>
#include <cmath>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

using JsonScene = SceneFileTest;

/// The two shapes of SOURCES (c4).
constexpr std::string_view kTwoShapes = R"({"camera": {"resolution": [640, 480], "s": 1,
  "z_near": 0.1, "z_far": 10,
  "transform": [{"lookat": {"position": [0, 1, 0], "target": [0, 0, -5], "up": [0, 1, 0]}}]},
 "background": [0.5, 0.5, 0.5],
 "objects": [{"vertices": [-1.7, 1, -5, 1, 1, -5, -0.5, -1, -5, -2.5, -1, -5,
                           -1, 1.5, -4, 0.2, 1.5, -4, 0.2, -1.5, -4],
   "faces": [0, 1, 2, 0, 2, 3, 4, 5, 6],
   "vertex_colors": [0.75, 0.35, 0.35, 0.35, 0.75, 0.35, 0.35, 0.35, 0.75, 0.75, 0.35, 0.75,
                     0.35, 0.75, 0.75, 0.75, 0.35, 0.75, 0.75, 0.75, 0.35],
   "transform": [{"rotate": [30, 1, 1, 1]}]}]})";

/// Where a vertex is seen, y down, as SOURCES (c4) has it.
Vec2 pixel_of(const SceneDescription& scene, const Vec3f& vertex, std::size_t entity = 0) {
    const CameraDescription& camera = scene.camera;
    const Vec3 world = Vec3{vertex} + scene.entities.at(entity).world_from_body.position;
    const Vec3 ahead = glm::normalize(camera.target_m - camera.position_m);
    const Vec3 offset = world - camera.position_m;
    const Real depth = glm::dot(offset, ahead);
    const Real s = std::tan(camera.fov_y_rad / 2);
    const auto width = static_cast<Real>(scene.viewer->width_px);
    const auto height = static_cast<Real>(scene.viewer->height_px);
    const Real x = glm::dot(offset, glm::cross(ahead, camera.up)) / depth;
    const Real y = glm::dot(offset, camera.up) / depth;
    return {width * (x + s * width / height) / (2 * s * width / height),
            height * (s - y) / (2 * s)};
}

// SOURCES C4 C5: seven vertices, by the source's own numbers.
TEST_F(JsonScene, VerticesFallOnTheirPixels) {
    write("a.json", kTwoShapes);
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.viewer->width_px, 640);
    EXPECT_EQ(scene.viewer->height_px, 480);
    EXPECT_EQ(scene.camera.clear_color, Vec3f{0.5F});
    EXPECT_NEAR(scene.camera.near_m, 0.1, 1e-7);
    EXPECT_NEAR(scene.camera.far_m, 10, 1e-6);
    const assets::MeshData& mesh = mesh_of(scene, 0);
    ASSERT_EQ(mesh.vertices.size(), 9U) << "without normals every triangle has its own corners";
    const std::vector<Vec2f> wanted{{90.73F, 153.87F},
                                    {261.32F, 104.39F},
                                    {226.88F, 235.35F},
                                    {90.73F, 153.87F},
                                    {226.88F, 235.35F},
                                    {122.37F, 275.02F},
                                    {83.14F, 98.64F},
                                    {192.38F, 71.16F},
                                    {276.88F, 266.12F}};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Vec2 pixel = pixel_of(scene, mesh.vertices[i].position_body);
        EXPECT_NEAR(pixel.x, wanted[i].x, 0.01F) << i;
        EXPECT_NEAR(pixel.y, wanted[i].y, 0.01F) << i;
    }
    EXPECT_EQ(mesh.vertices[8].color, Vec3f(0.75F, 0.75F, 0.35F)) << "linear, as it stands";
}

// SOURCES (c1, c2): what a file leaves out.
TEST_F(JsonScene, WhatIsLeftOutHasItsDefault) {
    write("a.json", R"({"camera": {"resolution": [4, 3], "more": 1}, "objects": [], "more": []})");
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.camera.clear_color, Vec3f{1.0F});
    EXPECT_NEAR(std::tan(scene.camera.fov_y_rad / 2), 1, 1e-6);
    EXPECT_NEAR(scene.camera.near_m, 1e-3, 1e-9);
    EXPECT_NEAR(scene.camera.far_m, 1e3, 1e-3);
    expect_near(scene.camera.position_m, {0, 0, 0});
    expect_near(scene.camera.target_m, {0, 0, -1});
    EXPECT_EQ(scene.controls, "viewer");
    // SOURCES C18: from (1, 1, 1), ambient 0.1; the unit of the sun is pi times that of lectures.
    expect_near(scene.sun->direction, -glm::normalize(Vec3{1, 1, 1}));
    EXPECT_EQ(scene.ambient.color, Vec3f{0.1F});
    EXPECT_FALSE(scene.post.has_value()) << "no tone curve, no exposure";
}

// The view is inverse(camera-to-world) whatever that does: here it doubles and turns.
TEST_F(JsonScene, ACameraMayScale) {
    std::string text(kTwoShapes);
    const std::string_view look = R"("up": [0, 1, 0]}})";
    text.insert(text.find(look) + look.size(), R"(, {"scale": [1, 1, 1]})");
    write("a.json", text);
    write("b.json", text.replace(text.find("[{\"lookat\""), 1, R"([{"scale": [2, 2, 2]}, )"));
    const Outcome plain = load_file("a.json");
    const Outcome scaled = load_file("b.json");
    ASSERT_TRUE(plain.scene.ok() && scaled.scene.ok());
    // Twice as large a camera sees everything half as far: at the same pixels.
    const auto& far = mesh_of(*plain.scene, 0).vertices[1].position_body;
    const auto& near = mesh_of(*scaled.scene, 0).vertices[1].position_body;
    const Vec2 a = pixel_of(*plain.scene, far);
    const Vec2 b = pixel_of(*scaled.scene, near);
    EXPECT_NEAR(a.x, b.x, 1e-3F);
    EXPECT_NEAR(a.y, b.y, 1e-3F);
    const Vec3 eye = scaled.scene->camera.position_m;
    const Vec3 place = scaled.scene->entities[0].world_from_body.position;
    EXPECT_NEAR(glm::distance(Vec3{near} + place, eye),
                glm::distance(Vec3{far}, plain.scene->camera.position_m) / 2,
                1e-4);
}

constexpr std::string_view kHead =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n";
constexpr std::string_view kFaces =
    "element face 1\nproperty list uchar uint vertex_indices\nend_header\n";

// SOURCES (c5): bytes are powers of 2.2, floats are light; above 1 too.
TEST_F(JsonScene, ColoursOfBytesAndOfFloatsAreWhatTheSourceSays) {
    const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string floats = "property double red\nproperty double green\nproperty double blue\n";
    write("b.ply",
          fmt::format("{}{}{}0 0 0 255 68 0\n1 0 0 255 68 0\n0 1 0 255 68 0\n3 0 1 2\n",
                      kHead,
                      bytes,
                      kFaces));
    write("f.ply",
          fmt::format(
              "{}{}{}0 0 0 0.5 2.0 0\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n", kHead, floats, kFaces));
    write("a.json",
          R"({"camera": {"resolution": [4, 3]},
             "objects": [{"filename": "b.ply"}, {"filename": "f.ply"}]})");
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    expect_near_f(mesh_of(*outcome.scene, 0).vertices[0].color,
                  {1, static_cast<float>(std::pow(68 / 255.0, 2.2)), 0});
    // Divided by the brightest, which the material multiplies in again.
    expect_near_f(mesh_of(*outcome.scene, 1).vertices[0].color, {0.25F, 1, 0});
    const auto& material = outcome.scene->materials.at(outcome.scene->entities[1].material);
    EXPECT_EQ(material.base_color, Vec3f{2.0F});
    EXPECT_EQ(material.shading, assets::Shading::Unlit);
    EXPECT_EQ(material.shininess, 32.0F);
    EXPECT_EQ(material.specular, 0.5F);
}

// SOURCES C8 C17: one mesh for all places; the image whose name begins as the mesh's does.
TEST_F(JsonScene, MeshesAreSharedAndImagesFoundByName) {
    const std::string uv = "property float s\nproperty float t\n";
    const std::string body = "0 0 0 0.25 0.75\n1 0 0 1 1\n0 1 0 0 0\n3 0 1 2\n";
    write("pot.ply", fmt::format("{}{}{}{}", kHead, uv, kFaces, body));
    write("potato.ply", fmt::format("{}{}{}{}", kHead, uv, kFaces, body));
    write("potato.jpg", "x");
    write("pot-atlas.png", "x");
    write("a.json",
          R"({"camera": {"resolution": [4, 3]}, "objects": [{"filename": "pot.ply"},
             {"filename": "pot.ply", "transform": [{"translate": [3, 0, 0]}]},
             {"filename": "potato.ply"}]})");
    const Outcome outcome = load_file("a.json");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(&mesh_of(scene, 0), &mesh_of(scene, 1));
    const auto image = [&](std::size_t i) {
        return scene.materials.at(scene.entities[i].material).base_color_map.filename();
    };
    EXPECT_EQ(image(0), "pot-atlas.png");
    EXPECT_EQ(image(2), "potato.jpg");
    // v points up in the file, down in ours.
    EXPECT_EQ(mesh_of(scene, 0).vertices[0].uv, Vec2f(0.25F, 0.25F));
    EXPECT_EQ(scene.source_files.size(), 3U) << "the scene and two meshes";
}

}  // namespace
}  // namespace plumbline::scene
