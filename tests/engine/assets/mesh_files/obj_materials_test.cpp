// Materials of OBJ files: maps, colours, and where files may lie.
#include "engine/assets/model/model_readers_impl.h"
#include "tests/engine/assets/fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::assets::test {
namespace {

TEST(ObjMaterials, refuses_libraries_and_textures_outside_its_folder) {
    const TempFolder folder;
    folder.write("x.mtl", "newmtl a\n");
    for (const char* library : {"../x.mtl", "..\\x.mtl", "/etc/passwd", "C:\\x.mtl"}) {
        const Import import(folder.write("models/a.obj", fmt::format("mtllib {}\n", library)),
                            folder.path());
        ASSERT_FALSE(import.ok()) << library;
        EXPECT_TRUE(contains(import.error(), "is refused: mtllib: \"")) << import.error();
        EXPECT_EQ(import.model.error().exit_code, ExitCode::Refused);
    }
    for (const char* key : {"map_Kd", "map_Bump", "norm", "map_d", "map_Ks", "map_Pr", "disp"}) {
        folder.write("models/a.mtl", fmt::format("newmtl a\n{} ..\\..\\secret.png\n", key));
        const Import import(folder.write("models/a.obj", "mtllib a.mtl\n"), folder.path());
        ASSERT_FALSE(import.ok()) << key;
        EXPECT_TRUE(contains(import.error(), "\"../../secret.png\" leads out of its folder"))
            << import.error();
    }
}

/// The materials of an .mtl below a model's folder.
std::vector<MaterialData> materials_of_text(const TempFolder& folder, std::string_view text) {
    const fs::path file = folder.write("models/sub/a.mtl", text);
    ModelReferences references(folder.path() / "models/a.obj", folder.path());
    Result<std::vector<MaterialData>> read = read_mtl(file, "a.obj", references);
    EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().message);
    return read.ok() ? std::move(*read) : std::vector<MaterialData>{};
}

TEST(ObjMaterials, clamp_numbers_and_keep_what_is_no_number) {
    const TempFolder folder;
    const std::vector<MaterialData> read =
        materials_of_text(folder,
                          "Kd 1 0 0\nnewmtl a b \nKd 0.5\nKe 1 2\nPr 7\nPm -1\nTr 0.25\n"
                          "newmtl dull\nKd red\nNs -5\nd 2\n");
    ASSERT_EQ(read.size(), 2U) << "what stands before any newmtl is nobody's";
    EXPECT_EQ(read[0].name, "a b");
    EXPECT_EQ(read[0].base_color, Vec3f(0.5F)) << "one number is grey";
    EXPECT_EQ(read[0].emissive, Vec3f(1, 2, 1));
    EXPECT_EQ(read[0].roughness, 1.0F);
    EXPECT_EQ(read[0].metallic, 0.0F);
    EXPECT_EQ(read[0].alpha, 0.75F);
    EXPECT_EQ(read[0].alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(read[1].base_color, Vec3f(1.0F));
    EXPECT_EQ(read[1].roughness, 1.0F) << "an exponent of 0";
    EXPECT_EQ(read[1].alpha, 1.0F);
    EXPECT_EQ(read[1].alpha_mode, AlphaMode::Opaque);
}

TEST(ObjMaterials, read_options_before_names_and_look_beside_the_library_first) {
    const TempFolder folder;
    folder.write("models/sub/near.png", "");
    folder.write("models/far.png", "");
    const std::vector<MaterialData> read =
        materials_of_text(folder,
                          "newmtl a\nKd 0 0 0\nmap_Kd -o 1 2 -s 3 -mm 0 1 near.png\n"
                          "norm -clamp on far.png\ndisp -odd name.png\n"
                          "newmtl b\nKd 0 0 0\nmap_Kd -t 1 2 3 4 5.png\n");
    ASSERT_EQ(read.size(), 2U);
    const fs::path sub = folder.path() / "models/sub";
    EXPECT_EQ(read[0].base_color_map, sub / "near.png");
    EXPECT_EQ(read[0].base_color, Vec3f(1.0F)) << "black below a map is meant as white";
    EXPECT_EQ(read[0].normal_map, folder.path() / "models/far.png") << "beside the model";
    EXPECT_EQ(read[0].height_map, sub / "-odd name.png") << "no option that is known";
    EXPECT_EQ(read[1].base_color_map, sub / "4 5.png");
}

}  // namespace
}  // namespace plumbline::assets::test
