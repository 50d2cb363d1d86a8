// [[view]].
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, ViewsNameFiles) {
    const std::string place = "position_m = [0, 0, 1]\ntarget_m = [0, 0, 0]\n";
    const SceneDescription scene =
        good("[[view]]\n" + place + "[[view]]\nname = \"A-b_9\"\n" + place);
    EXPECT_EQ(scene.views.at(0).name, "view_1");
    EXPECT_EQ(scene.views.at(1).name, "A-b_9");
    for (const char* name : {"a b", "a/b", "ä", ".."}) {
        expect_only(fmt::format("[[view]]\nname = \"{}\"\n{}", name, place),
                    fmt::format("2:8: error: view[0].name: \"{}\"; expected letters, digits, _ and "
                                "- only, for it names a file",
                                name));
    }
}

TEST_F(SceneFileTest, ViewsLookFromOneplaceToAnother) {
    expect_first("[[view]]\ntarget_m = [0, 0, 1]\n",
                 "scene.toml:1:1: error: view[0].position_m: missing; expected [x, y, z] in m");
    expect_only("[[view]]\nposition_m = [1, 2, 3]\ntarget_m = [1, 2, 3]\n",
                "3:12: error: view[0].target_m: is where the view is taken from; expected another "
                "point");
    std::string many;
    for (int i = 0; i < 200; ++i)
        many += "[[view]]\nposition_m = [0, 0, 1]\ntarget_m = [0, 0, 0]\n";
    EXPECT_EQ(good(many).views.size(), 200U);
    const Outcome more = load(many + "[[view]]\n");
    ASSERT_EQ(more.faults.size(), 1U);
    EXPECT_NE(more.faults[0].find("error: view: 201 views; at most 200 are kept"),
              std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
