// What is written as glTF is read back as it was.
#include "engine/assets/primitives.h"
#include "engine/scene/gltf_scene/gltf_writer_impl.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

namespace plumbline::scene::gltf {
namespace {

using namespace assets;
using assets::test::Import;
using assets::test::TempFolder;
namespace fs = std::filesystem;

/// 1 x 1 pixel.
const std::string kPng = [] {
    const std::vector<unsigned char> bytes{
        0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0,    0,    0,   0x0D, 'I',  'H',
        'D',  'R',  0,    0,    0,    1,    0,    0,    0,    1,    8,   2,    0,    0,
        0,    0x90, 'w',  'S',  0xDE, 0,    0,    0,    0x0C, 'I',  'D', 'A',  'T',  8,
        0xD7, 'c',  0xF8, 0xCF, 0xC0, 0,    0,    3,    1,    1,    0,   0x18, 0xDD, 0x8D,
        0xB0, 0,    0,    0,    0,    'I',  'E',  'N',  'D',  0xAE, 'B', '`',  0x82};
    return std::string(bytes.begin(), bytes.end());
}();

GltfWriter writer() {
    return GltfWriter(
        [](const fs::path& file) { return file == "a.png" ? kPng : std::string("EXR"); });
}

TEST(GltfWriter, keeps_meshes_with_their_materials) {
    GltfWriter out = writer();
    const MaterialData material{.name = "glass",
                                .base_color = {0.5F, 0.25F, 1.0F},
                                .alpha = 0.5F,
                                .emissive = {0, 4, 0},
                                .base_color_map = "a.png",
                                .roughness = 0.25F,
                                .metallic = 1.0F,
                                .alpha_mode = AlphaMode::Blend,
                                .two_sided = true};
    const std::size_t number = out.add_material(material);
    EXPECT_EQ(out.add_material(material), number) << "equal ones are one";
    const MeshData box = box_mesh({1, 2, 3});
    out.add_node({{"name", "box"}, {"mesh", out.add_mesh(box, std::array{number})}});
    const TempFolder folder;
    const Import import(folder.write("m.glb", out.glb()));
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.mesh().vertices.size(), box.vertices.size());
    for (std::size_t i = 0; i < box.vertices.size(); ++i) {
        EXPECT_EQ(import.mesh().vertices[i].position_body, box.vertices[i].position_body);
        EXPECT_EQ(import.mesh().vertices[i].uv, box.vertices[i].uv);
    }
    EXPECT_EQ(import.mesh().indices, box.indices);
    const MaterialData& read = import.materials().front();
    EXPECT_EQ(read.name, "glass");
    EXPECT_EQ(read.base_color, material.base_color);
    EXPECT_EQ(read.alpha, 0.5F);
    EXPECT_EQ(read.emissive, Vec3f(0, 4, 0));
    EXPECT_EQ(read.roughness, 0.25F);
    EXPECT_EQ(read.alpha_mode, AlphaMode::Blend);
    EXPECT_TRUE(read.two_sided);
    ASSERT_EQ(import.model->images.size(), 1U);
    EXPECT_EQ(import.model->images[0].bytes, kPng);
    EXPECT_EQ(import.model->images[0].name, read.base_color_map);
}

TEST(GltfWriter, says_which_images_it_leaves_out) {
    GltfWriter out = writer();
    out.add_material({.name = "m", .base_color_map = "b.exr"});
    ASSERT_EQ(out.notes().size(), 1U);
    EXPECT_EQ(out.notes()[0], "the image b.exr is left out: glTF takes PNG and JPEG");
}

TEST(GltfWriter, draws_what_is_in_its_scene) {
    GltfWriter out = writer();
    const std::size_t mesh = out.add_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const std::size_t child = out.add_node({{"mesh", mesh}});
    out.add_node({{"children", {child}}});
    out.add_node({{"mesh", mesh}}, false);
    const TempFolder folder;
    const Import import(folder.write("m.glb", out.glb()));
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.model->nodes.size(), 2U);
    EXPECT_EQ(import.mesh().indices.size(), 3U);
}

TEST(GltfWriter, writes_a_file_without_meshes) {
    GltfWriter out = writer();
    out.json["extensions"]["KHR_implicit_shapes"]["shapes"] = {{{"type", "sphere"}}};
    out.use("KHR_physics_rigid_bodies");
    out.use("KHR_physics_rigid_bodies");
    EXPECT_EQ(out.json["extensionsUsed"].size(), 1U) << "each once";
    const Json collider{{"collider", {{"geometry", {{"shape", 0}}}}}};
    out.add_node({{"extensions", {{"KHR_physics_rigid_bodies", collider}}}});
    const TempFolder folder;
    const Import import(folder.write("m.glb", out.glb()));
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.model->physics.colliders.size(), 1U);
}

}  // namespace
}  // namespace plumbline::scene::gltf
