// [[material]], and files that are named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, Materials) {
    for (const char* map : {"b.jpg", "n.png", "o.jpg", "h.jpg"})
        write(fmt::format("assets/textures/{}", map), "x");
    const Outcome outcome = load(R"([[material]]
name = "leaf"
shading = "blinn_phong"
base_color = [0.1, 0.2, 0.3]
alpha = 0.5
emissive = [0, 2, 0]
base_color_map = "textures/b.jpg"
normal_map = "textures/n.png"
orm_map = "textures/o.jpg"
height_map = "textures/h.jpg"
roughness = 0.3
metallic = 0.7
alpha_mode = "mask"
alpha_cutoff = 0.4
two_sided = true
surface = "soft"
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const assets::MaterialData& leaf = outcome.scene->materials.at("leaf");
    EXPECT_EQ(leaf.name, "leaf");
    EXPECT_EQ(leaf.shading, assets::Shading::BlinnPhong);
    expect_near_f(leaf.base_color, {0.1F, 0.2F, 0.3F});
    EXPECT_FLOAT_EQ(leaf.alpha, 0.5F);
    expect_near_f(leaf.emissive, {0.0F, 2.0F, 0.0F});
    EXPECT_EQ(leaf.base_color_map, assets() / "textures/b.jpg");
    EXPECT_EQ(leaf.normal_map, assets() / "textures/n.png");
    EXPECT_EQ(leaf.orm_map, assets() / "textures/o.jpg");
    EXPECT_EQ(leaf.height_map, assets() / "textures/h.jpg");
    EXPECT_FLOAT_EQ(leaf.roughness, 0.3F);
    EXPECT_FLOAT_EQ(leaf.metallic, 0.7F);
    EXPECT_EQ(leaf.alpha_mode, assets::AlphaMode::Mask);
    EXPECT_FLOAT_EQ(leaf.alpha_cutoff, 0.4F);
    EXPECT_TRUE(leaf.two_sided);
    EXPECT_EQ(leaf.surface, "soft");
}

// SOURCES A15, A17, A20.
TEST_F(SceneFileTest, TheTextbooksLightIsTakenApart) {
    const SceneDescription scene = good(
        "[[material]]\nname = \"m\"\nshading = \"blinn_phong\"\nshininess = 15\nspecular = 1\n"
        "diffuse = 0.25\nwhite_highlight = true\nflat = true\n");
    const assets::MaterialData& material = scene.materials.at("m");
    EXPECT_EQ(material.shininess, 15.0F);
    EXPECT_EQ(material.diffuse, 0.25F);
    EXPECT_TRUE(material.white_highlight);
    EXPECT_TRUE(material.flat);
    expect_only(
        "[[material]]\nname = \"m\"\ndiffuse = 0.5\n",
        "3:11: warning: material[0].diffuse: needs shading = \"blinn_phong\" and a shininess "
        "above 0; ignored");
}

TEST_F(SceneFileTest, NumbersThatNeedOthersAreNamed) {
    const std::string material = "[[material]]\nname = \"m\"\n";
    const auto said = [&](const std::string& key, const std::string& what) {
        expect_only(material + key,
                    fmt::format("3:{}: warning: material[0].{}",
                                key.find('=') + 3,
                                key.substr(0, key.find(' ')) + ": " + what));
    };
    said("attenuation_m = 1\n", "needs a ripple_slope above 0; ignored");
    said("caustics = 1\n", "needs an attenuation_m above 0; ignored");
    said("ior = 1.5\n", "needs alpha_mode = \"blend\"; ignored");
    said("white_highlight = true\nshininess = 9\n",
         "needs shading = \"blinn_phong\" and a shininess above 0; ignored");
    EXPECT_TRUE(load(material + "ripple_slope = 0.1\nattenuation_m = 1\ncaustics = 1\n"
                                "alpha_mode = \"blend\"\nior = 1.5\n")
                    .faults.empty());
}

TEST_F(SceneFileTest, MapsThatAreNotThere) {
    const std::string material = "[[material]]\nname = \"m\"\n";
    const Outcome color = load(material + "base_color_map = \"b.png\"\n");
    EXPECT_EQ(color.faults,
              std::vector<std::string>{"scene.toml:3:18: warning: material[0].base_color_map: "
                                       "\"b.png\" does not exist; a chequered image stands in"});
    EXPECT_EQ(color.scene->materials.at("m").base_color_map.filename(), "b.png");
    const Outcome rough = load(material + "orm_map = \"o.png\"\n");
    EXPECT_EQ(rough.faults,
              std::vector<std::string>{"scene.toml:3:11: warning: material[0].orm_map: \"o.png\" "
                                       "does not exist; the map is left out"});
    EXPECT_TRUE(rough.scene->materials.at("m").orm_map.empty());
    write("assets/h.PNG", "x");
    expect_only(material + "height_map = \"h.PNG\"\n",
                "3:14: warning: material[0].height_map: needs a normal_map; the map is left out");
    expect_only(material + "orm_map = \"o.gif\"\n",
                "3:11: error: material[0].orm_map: \"o.gif\" is of a kind that is not read here; "
                "expected .jpg .jpeg .png .exr");
}

}  // namespace
}  // namespace plumbline::scene
