#include "engine/scene/surfaces.h"

#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

class Surfaces : public SceneFileTest {
protected:
    SurfaceTable load_text(std::string_view text, std::vector<std::string>& said) {
        write("surfaces.toml", text);
        Diagnostics faults;
        SurfaceTable table = load_surfaces(folder() / "surfaces.toml", assets(), faults);
        for (const Diagnostic& fault : faults.list()) {
            said.push_back(to_string(Diagnostic{fault.severity,
                                                fs::path(fault.file).filename().string(),
                                                fault.line,
                                                fault.column,
                                                fault.key,
                                                fault.message}));
        }
        return table;
    }
};

TEST_F(Surfaces, KeysAndVariations) {
    for (const char* name : {"hit_0.ogg", "hit_1.ogg", "hit_3.ogg", "step.ogg"})
        write(fmt::format("assets/sounds/{}", name), "x");
    std::vector<std::string> said;
    const SurfaceTable table = load_text(R"([wood]
friction = 0.6
restitution = 0.2
density_kgpm3 = 600
impact_sounds = "hit"
step_sounds = ["sounds/step.ogg"]
roll_sound = "sounds/step.ogg"
loudness = 0.5
[default]
friction = 0.9
)",
                                         said);
    EXPECT_TRUE(said.empty());
    EXPECT_EQ(table.find("default"), 0);
    EXPECT_EQ(table.get(0).friction, 0.9_r);
    const Surface& wood = table.get(table.find("wood"));
    EXPECT_EQ(wood.name, "wood");
    EXPECT_EQ(wood.friction, 0.6_r);
    EXPECT_EQ(wood.restitution, 0.2_r);
    EXPECT_EQ(wood.density_kgpm3, Real{600});
    EXPECT_FLOAT_EQ(wood.loudness, 0.5F);
    // Numbered without a gap: _3 does not count after _1.
    ASSERT_EQ(wood.impact_sounds.size(), 2U);
    EXPECT_EQ(wood.impact_sounds[1], assets() / "sounds/hit_1.ogg");
    ASSERT_EQ(wood.step_sounds.size(), 1U);
    EXPECT_EQ(wood.roll_sound, assets() / "sounds/step.ogg");
    EXPECT_TRUE(wood.scrape_sound.empty());
}

TEST_F(Surfaces, BadEntriesCostOnlyThemselves) {
    std::vector<std::string> said;
    const SurfaceTable table = load_text(
        "x = 3\n[ice]\nfriction = -1\nrestitution = 0.1\n[mud]\nfricton = 1\n"
        "impact_sounds = \"none\"\nstep_sounds = [\"../../etc/x.ogg\"]\n"
        "roll_sound = \"../x.ogg\"\nscrape_sound = \"sounds/none.ogg\"\n",
        said);
    ASSERT_EQ(said.size(), 7U);
    EXPECT_EQ(said[0],
              "surfaces.toml:1:1: error: x: 3; expected a table, [NAME], for each surface");
    EXPECT_EQ(said[1],
              "surfaces.toml:3:12: error: ice.friction: -1; expected a coefficient from 0 to 10");
    EXPECT_EQ(said[2],
              "surfaces.toml:6:1: error: mud.fricton: unknown key; did you mean \"friction\"?");
    EXPECT_EQ(
        said[3],
        "surfaces.toml:7:17: warning: mud.impact_sounds: no sounds/none_0.ogg; it stays silent");
    EXPECT_EQ(
        said[4],
        "surfaces.toml:8:15: error: mud.step_sounds: \"../../etc/x.ogg\" leads out of its folder");
    EXPECT_EQ(said[5],
              "surfaces.toml:9:14: error: mud.roll_sound: \"../x.ogg\" leads out of its folder");
    EXPECT_EQ(said[6],
              "surfaces.toml:10:16: warning: mud.scrape_sound: \"sounds/none.ogg\" does not exist; "
              "left out");
    EXPECT_EQ(table.get(table.find("ice")).friction, 0.5_r);
    EXPECT_EQ(table.get(table.find("ice")).restitution, 0.1_r);
    EXPECT_NE(table.find("mud"), 0);
    EXPECT_EQ(table.find("nothing"), 0);
}

TEST_F(Surfaces, WithoutAFileEverythingIsDefault) {
    Diagnostics faults;
    const SurfaceTable table = load_surfaces(folder() / "none.toml", assets(), faults);
    ASSERT_EQ(table.surfaces.size(), 1U);
    EXPECT_EQ(table.surfaces[0].name, "default");
    EXPECT_TRUE(faults.has_errors());
    std::vector<std::string> said;
    EXPECT_EQ(load_text("[wood\n", said).surfaces.size(), 1U);
    ASSERT_EQ(said.size(), 1U);
}

TEST_F(Surfaces, TheShippedTableIsCompleteAndSilentAboutItself) {
    Diagnostics faults;
    const fs::path root = PL_SOURCE_DIR;
    const SurfaceTable table =
        load_surfaces(root / "config/surfaces.toml", root / "assets", faults);
    for (const Diagnostic& fault : faults.list()) ADD_FAILURE() << to_string(fault);
    for (const char* name : {"wood",
                             "plank",
                             "stone",
                             "brick",
                             "metal",
                             "can",
                             "glass",
                             "rubber",
                             "ceramic",
                             "soft",
                             "grass",
                             "gravel",
                             "soil",
                             "plaster",
                             "water"}) {
        ASSERT_NE(table.find(name), 0) << name;
        EXPECT_GE(table.get(table.find(name)).impact_sounds.size(), 4U) << name;
        EXPECT_GE(table.get(table.find(name)).step_sounds.size(), 4U) << name;
    }
}

}  // namespace
}  // namespace plumbline::scene
