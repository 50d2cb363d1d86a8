// Tables of a scene file as JSON beside glTF.
#include "engine/scene/gltf_scene/gltf_export.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

namespace plumbline::scene {
namespace {

TEST(GltfExtras, AreTheTablesThatGltfHasNoWordsFor) {
    const test::TemporaryFolder folder;
    folder.write("base.toml",
                 "[world]\ngravity_mps2 = [0, -2, 0]\n[player]\nposition_m = [1, 2, 3]\n");
    const auto file = folder.write("m.toml",
                                   "[scene]\nbase = \"base.toml\"\ntitle = \"T\"\n"
                                   "[accuracy]\nsubsteps = 4\n"
                                   "[[entity]]\nname = \"a\"\nprimitive = { box = [1, 1, 1] }\n");
    const Result<std::string> text = surroundings_of(file, {});
    ASSERT_TRUE(text.ok()) << text.error().message;
    const auto tables = nlohmann::json::parse(*text);
    EXPECT_EQ(tables["scene"], (nlohmann::json{{"title", "T"}}));
    EXPECT_EQ(tables["world"]["gravity_mps2"][1], -2) << "of the scene that it starts from";
    EXPECT_EQ(tables["accuracy"]["substeps"], 4);
    EXPECT_FALSE(tables.contains("entity"));
}

TEST(GltfExtras, FailWhereTheFileDoes) {
    const test::TemporaryFolder folder;
    EXPECT_FALSE(surroundings_of(folder.write("m.toml", "[world]\ngravty = 1\n"), {}).ok());
    EXPECT_FALSE(surroundings_of(folder.write("m.glb", "no glTF"), {}).ok());
    EXPECT_EQ(surroundings_of(folder.write("m.json", "{}"), {}).value(), "");
}

}  // namespace
}  // namespace plumbline::scene
