// Loaded once, kept in place, images decoded ahead.

#include "engine/assets/asset_library.h"

#include "engine/assets/image/image_import.h"
#include "engine/assets/primitives.h"
#include "tests/engine/assets/fixture.h"

#include <pthread.h>

namespace plumbline::assets::test {
namespace {

fs::path write_image(const TempFolder& folder, const std::string& name, std::uint8_t value) {
    const fs::path file = folder.path() / name;
    const ImageData image{.width = 1, .height = 1, .format = PixelFormat::R8, .bytes = {value}};
    EXPECT_TRUE(write_png(file, image).ok());
    return file;
}

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

TEST(AssetLibrary, decodes_images_that_a_model_holds) {
    const TempFolder folder;
    const fs::path image = write_image(folder, "a.png", 77);
    std::ifstream stream(image, std::ios::binary);
    const std::string png{std::istreambuf_iterator<char>(stream), {}};
    TriangleFile content;
    content.json["images"] = {{{"bufferView", content.add_view(png)}}};
    content.json["textures"] = {{{"source", 0}}};
    content.json["materials"] = {
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    content.primitive()["material"] = 0;
    const fs::path file = folder.write("m.glb", content.glb());
    AssetLibrary library;
    const Result<Model> model = library.model(file, folder.path());
    ASSERT_TRUE(model.ok()) << model.error().message;
    const fs::path map = library.material(model->materials[0]).base_color_map;
    EXPECT_EQ(library.take_image(map)->bytes, (std::vector<std::uint8_t>{77}));
    library.prefetch_images();
    EXPECT_EQ(library.take_image(map)->bytes, (std::vector<std::uint8_t>{77}));
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

TEST(AssetLibrary, hands_over_images_prefetched_or_not) {
    const TempFolder folder;
    AssetLibrary library;
    std::vector<fs::path> files;
    for (int i = 0; i < 50; ++i) {
        files.push_back(
            write_image(folder, fmt::format("{}.png", i), static_cast<std::uint8_t>(i)));
        MaterialData material;
        if (i % 3 == 0) material.base_color_map = files.back();
        if (i % 3 == 1) material.normal_map = files.back();
        if (i % 3 == 2) material.orm_map = files.back();
        library.add_material(material);
    }
    library.prefetch_images();
    library.prefetch_images();
    for (std::size_t i = files.size(); i-- > 0;) {
        const auto image = library.take_image(files[i]);
        ASSERT_EQ(image->bytes, (std::vector<std::uint8_t>{static_cast<std::uint8_t>(i)}));
    }
    // Forgotten once taken: the file is read again.
    write_image(folder, "7.png", 99);
    EXPECT_EQ(library.take_image(files[7])->bytes[0], 99);
}

TEST(AssetLibrary, gives_a_checkerboard_and_one_warning_for_a_broken_image) {
    const TempFolder folder;
    const fs::path broken = folder.write("broken.png", "not an image");
    AssetLibrary library;
    library.add_material({.base_color_map = broken});
    library.prefetch_images();
    ::testing::internal::CaptureStderr();
    const auto image = library.take_image(broken);
    const auto again = library.take_image(broken);
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(image->width, 64U);
    EXPECT_EQ(image->bytes, again->bytes);
    EXPECT_NE(image->bytes[0], image->bytes[8 * 3]);
    const std::size_t warning = log.find("a checkerboard is shown instead");
    ASSERT_NE(warning, std::string::npos) << log;
    EXPECT_EQ(log.find("a checkerboard is shown instead", warning + 1), std::string::npos) << log;
}

// EXPERIENCE I14
TEST(AssetLibrary, decodes_without_threads_where_none_can_be_made) {
    const TempFolder folder;
    const fs::path file = write_image(folder, "a.png", 7);
    pthread_attr_t attributes;
    ASSERT_EQ(::pthread_attr_init(&attributes), 0);
    std::size_t usual_bytes = 0;
    ASSERT_EQ(::pthread_attr_getstacksize(&attributes, &usual_bytes), 0);
    // More than there are addresses: no thread can have it.
    ASSERT_EQ(::pthread_attr_setstacksize(&attributes, std::size_t{1} << 48), 0);
    ASSERT_EQ(::pthread_setattr_default_np(&attributes), 0);
    {
        AssetLibrary library;
        library.add_material({.base_color_map = file});
        library.prefetch_images();
        EXPECT_EQ(library.take_image(file)->bytes, (std::vector<std::uint8_t>{7}));
    }
    ASSERT_EQ(::pthread_attr_setstacksize(&attributes, usual_bytes), 0);
    ASSERT_EQ(::pthread_setattr_default_np(&attributes), 0);
    ::pthread_attr_destroy(&attributes);
}

TEST(AssetLibrary, ends_while_images_are_still_waiting) {
    const TempFolder folder;
    const fs::path file = write_image(folder, "a.png", 1);
    for (int round = 0; round < 20; ++round) {
        AssetLibrary library;
        for (int i = 0; i < 20; ++i) {
            library.add_material({.base_color_map = folder.path() / fmt::format("{}.png", i)});
        }
        library.prefetch_images();
    }
    EXPECT_TRUE(fs::exists(file));
}

}  // namespace
}  // namespace plumbline::assets::test
