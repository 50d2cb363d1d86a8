// Loaded once, kept in place.

#include "engine/assets/asset_library.h"

#include "engine/assets/primitives.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

TEST(AssetLibrary, loads_a_model_once) {
    const TempFolder folder;
    const fs::path file = folder.write("m.glb", TriangleFile{}.glb());
    AssetLibrary library;
    const Result<Model> first = library.model(file, folder.path());
    ASSERT_TRUE(first.ok()) << first.error().message;
    fs::remove(file);
    const Result<Model> second = library.model(folder.path() / "." / "m.glb", folder.path());
    ASSERT_TRUE(second.ok()) << second.error().message;
    EXPECT_EQ(first->mesh, second->mesh);
    EXPECT_EQ(first->materials, second->materials);
    EXPECT_EQ(library.mesh_count(), 1U);
    EXPECT_EQ(library.material_count(), 1U);
    EXPECT_EQ(library.material(first->materials[0]).name, "default");
}

// FAULTS 28: a reload said that it had read the file again and showed the old one.
TEST(AssetLibrary, reads_a_doubted_model_again_when_its_file_was_saved_since) {
    const TempFolder folder;
    TriangleFile content;
    const fs::path file = folder.write("m.glb", content.glb());
    AssetLibrary library;
    const Result<Model> first = library.model(file, folder.path());
    ASSERT_TRUE(first.ok());
    const std::uint32_t version = library.mesh(first->mesh).version;
    EXPECT_EQ(library.model_files(), (std::vector<fs::path>{file}));

    content.json["nodes"][0]["translation"] = {0, 0, 5};
    folder.write("m.glb", content.glb());
    ASSERT_TRUE(library.model(file, folder.path()).ok());
    EXPECT_EQ(library.mesh(first->mesh).bounds.max.z, 0.0F) << "nobody asked for it yet";
    library.doubt_models();
    const Result<Model> again = library.model(file, folder.path());
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->mesh, first->mesh);
    EXPECT_EQ(again->materials, first->materials);
    EXPECT_EQ(library.mesh(first->mesh).bounds.max.z, 5.0F);
    EXPECT_NE(library.mesh(first->mesh).version, version);
    EXPECT_EQ(library.mesh_count(), 1U);

    folder.write("m.glb", "garbage");
    library.doubt_models();
    const Result<Model> refused = library.model(file, folder.path());
    ASSERT_FALSE(refused.ok());
    EXPECT_TRUE(contains(refused.error().message, "its content is not glTF"));
    EXPECT_EQ(library.mesh(first->mesh).bounds.max.z, 5.0F) << "the old content stays";
    // The mended file is read although it was asked for in vain before.
    content.json["nodes"][0]["translation"] = {0, 0, 7};
    folder.write("m.glb", content.glb());
    ASSERT_TRUE(library.model(file, folder.path()).ok());
    EXPECT_EQ(library.mesh(first->mesh).bounds.max.z, 7.0F);
}

// FAULTS 18: each reload added the scene's materials again.
TEST(AssetLibrary, keeps_equal_materials_once) {
    AssetLibrary library;
    const MaterialId red = library.add_material({.name = "paint", .base_color = {1, 0, 0}});
    EXPECT_EQ(library.add_material({.name = "paint", .base_color = {1, 0, 0}}), red);
    EXPECT_NE(library.add_material({.name = "paint", .base_color = {0, 1, 0}}), red);
    EXPECT_EQ(library.material_count(), 2U);
}

TEST(AssetLibrary, hands_on_why_a_file_is_refused) {
    AssetLibrary library;
    EXPECT_FALSE(library.model("absent.glb", ".").ok());
    EXPECT_FALSE(library.sound("absent.ogg").ok());
    EXPECT_EQ(library.mesh_count(), 0U);
}

TEST(AssetLibrary, gives_one_mesh_to_one_name) {
    AssetLibrary library;
    const MeshId box = library.add_mesh("box 1 1 1", box_mesh({1, 1, 1}));
    EXPECT_EQ(library.add_mesh("box 1 1 1", box_mesh({1, 1, 1})), box);
    EXPECT_NE(library.add_mesh("box 2 1 1", box_mesh({2, 1, 1})), box);
    EXPECT_NE(box.value, 0U);
    EXPECT_EQ(library.mesh(box).indices.size(), 36U);
}

TEST(AssetLibrary, keeps_references_good_while_it_grows) {
    AssetLibrary library;
    const MeshData& mesh = library.mesh(library.add_mesh("0", box_mesh({1, 1, 1})));
    const MaterialData& material = library.material(library.add_material({.name = "first"}));
    for (int i = 1; i < 1'000; ++i) {
        library.add_mesh(std::to_string(i), {});
        library.add_material({.name = "more"});
    }
    EXPECT_EQ(mesh.vertices.size(), 24U);
    EXPECT_EQ(material.name, "first");
}

}  // namespace
}  // namespace plumbline::assets::test
