// Models by themselves, as scenes.
#pragma once

#include "engine/scene/scene_file.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/effects/drawn.h"

#include <string>

namespace plumbline::effects {

using assets::test::TempFolder;
using assets::test::TriangleFile;

/// A triangle that slides from x = 0 to 2 m in one second, beside one that stands at x = 5.
inline std::string sliding_model() {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}, {"name", "sled"}},
                          {{"mesh", 0}, {"translation", {5, 0, 0}}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    file.slide(0);
    file.json["animations"][0]["name"] = "slide";
    return file.glb();
}

inline scene::SceneDescription model_scene(const TempFolder& folder, const std::string& bytes) {
    Diagnostics faults;
    auto scene = scene::read_description(folder.write("m.glb", bytes), {}, faults);
    EXPECT_TRUE(scene.ok());
    scene->sun.reset();
    return *scene;
}

inline std::string turning_model() {
    TriangleFile file;
    file.hang_on_turning_bone();
    return file.glb();
}

}  // namespace plumbline::effects
