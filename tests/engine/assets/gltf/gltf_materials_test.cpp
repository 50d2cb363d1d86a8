// Materials, colours and images of glTF files.
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

TEST(GltfImport, gives_a_mesh_without_material_the_plain_one) {
    const Import import = import_bytes(TriangleFile{}.gltf());
    ASSERT_TRUE(import.ok());
    ASSERT_EQ(import.materials().size(), 1U);
    EXPECT_EQ(import.materials()[0].name, "default");
    ASSERT_EQ(import.mesh().sub_meshes.size(), 1U);
    EXPECT_EQ(import.mesh().sub_meshes[0].material, 0U);
}

TEST(GltfImport, keeps_materials_apart_that_differ_only_by_name) {
    TriangleFile file;
    file.json["materials"] = {{{"name", "brick"}}, {{"name", "plaster"}}, {{"name", "roof"}}};
    Json second = file.json["meshes"][0];
    file.primitive()["material"] = 2;
    second["primitives"][0]["material"] = 0;
    file.json["meshes"].push_back(second);
    file.json["nodes"].push_back({{"mesh", 1}});
    file.json["scenes"][0]["nodes"] = {0, 1};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    ASSERT_EQ(import.materials().size(), 3U);
    EXPECT_EQ(import.materials()[0].name, "brick");
    EXPECT_EQ(import.materials()[1].name, "plaster");
    EXPECT_EQ(import.materials()[2].name, "roof");
    ASSERT_EQ(import.mesh().sub_meshes.size(), 2U);
    EXPECT_EQ(import.mesh().sub_meshes[0].material, 0U);
    EXPECT_EQ(import.mesh().sub_meshes[1].material, 2U);
    EXPECT_EQ(import.mesh().sub_meshes[1].first_index, 3U);
}

TEST(GltfImport, numbers_materials_of_one_name) {
    TriangleFile file;
    file.json["materials"] = {{{"name", "a"}}, {{"name", "a"}}, Json::object(), {{"name", "a"}}};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok());
    ASSERT_EQ(import.materials().size(), 5U);  // and the plain one, which the mesh wears
    EXPECT_EQ(import.materials()[0].name, "a");
    EXPECT_EQ(import.materials()[1].name, "a.2");
    EXPECT_EQ(import.materials()[2].name, "material.2");
    EXPECT_EQ(import.materials()[3].name, "a.3");
}

TEST(GltfImport, reads_material_factors_modes_and_maps) {
    TriangleFile file;
    file.json["images"] = {{{"uri", "tex/My%20Base.png"}}, {{"uri", "n.png"}}, {{"uri", "o.png"}}};
    file.json["textures"] = {{{"source", 2}}, {{"source", 0}}, {{"source", 1}}};
    file.json["materials"] = {{{"name", "leaf"},
                               {"alphaMode", "MASK"},
                               {"alphaCutoff", 0.25},
                               {"doubleSided", true},
                               {"emissiveFactor", {0.5, 0.25, 0}},
                               {"normalTexture", {{"index", 2}}},
                               {"pbrMetallicRoughness",
                                {{"baseColorFactor", {0.5, 0.25, 0.125, 0.75}},
                                 {"baseColorTexture", {{"index", 1}}},
                                 {"metallicRoughnessTexture", {{"index", 0}}},
                                 {"roughnessFactor", 0.5},
                                 {"metallicFactor", 0.25}}}},
                              {{"name", "bare"}, {"alphaMode", "BLEND"}}};
    file.primitive()["material"] = 0;
    const TempFolder folder;
    const Import import(folder.write("m.gltf", file.gltf()));
    ASSERT_TRUE(import.ok()) << import.error();
    const MaterialData& leaf = import.materials()[0];
    EXPECT_EQ(leaf.alpha_mode, AlphaMode::Mask);
    EXPECT_EQ(leaf.alpha_cutoff, 0.25F);
    EXPECT_TRUE(leaf.two_sided);
    EXPECT_EQ(leaf.emissive, Vec3f(0.5F, 0.25F, 0));
    EXPECT_EQ(leaf.base_color, Vec3f(0.5F, 0.25F, 0.125F));
    EXPECT_EQ(leaf.alpha, 0.75F);
    EXPECT_EQ(leaf.roughness, 0.5F);
    EXPECT_EQ(leaf.metallic, 0.25F);
    EXPECT_EQ(leaf.base_color_map, folder.path() / "tex/My Base.png");
    EXPECT_EQ(leaf.normal_map, folder.path() / "n.png");
    EXPECT_EQ(leaf.orm_map, folder.path() / "o.png");
    const MaterialData& bare = import.materials()[1];
    EXPECT_EQ(bare.alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(bare.roughness, 1.0F);  // glTF's defaults
    EXPECT_EQ(bare.metallic, 1.0F);
    EXPECT_FALSE(bare.two_sided);
}

TEST(GltfImport, gives_embedded_images_names_below_the_file_and_their_bytes) {
    TriangleFile file;
    const std::size_t view = file.add_view("PNG bytes");
    file.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}},
                           {{"uri", "data:image/png;base64," + base64("other bytes")}}};
    file.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                               {"emissiveTexture", {{"index", 1}}},
                               {"emissiveFactor", {1, 1, 1}}}};
    file.primitive()["material"] = 0;
    const Import import = import_bytes(file.glb(), "m.glb");
    ASSERT_TRUE(import.ok()) << import.error();
    const ModelData& model = import.model.value();
    ASSERT_EQ(model.images.size(), 2U);
    EXPECT_EQ(model.images[0].bytes, "PNG bytes");
    EXPECT_EQ(model.images[1].bytes, "other bytes");
    EXPECT_EQ(import.materials()[0].base_color_map, model.images[0].name);
    EXPECT_EQ(import.materials()[0].emissive_map, model.images[1].name);
    EXPECT_EQ(model.images[0].name.filename(), "image 0");
    EXPECT_EQ(model.images[0].name.parent_path().filename(), "m.glb");
    EXPECT_EQ(import.log, "");
}

TEST(GltfImport, believes_red_to_be_occlusion_only_where_the_file_says_so) {
    for (const bool said : {true, false}) {
        TriangleFile file;
        file.json["images"] = {{{"uri", "orm.png"}}};
        file.json["textures"] = {{{"source", 0}}};
        Json material = {{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}}}}}};
        if (said) material["occlusionTexture"] = {{"index", 0}};
        file.json["materials"] = Json::array({material});
        file.primitive()["material"] = 0;
        const Import import = import_bytes(file.gltf());
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.materials()[0].occlusion, said ? 1.0F : 0.0F);
    }
}

}  // namespace
}  // namespace plumbline::assets::test
