// Models that move, made in code.
#pragma once

#include "tests/engine/assets/fixture.h"
#include "tests/support/scene_in_code.h"

namespace plumbline::scene {

using assets::test::TempFolder;
using assets::test::TriangleFile;

/// A triangle from (0, 0) to (1, 0) and (0, 1) that slides by 2 m along x in one second.
inline std::string sled() {
    TriangleFile file;
    file.json["nodes"] = {{{"mesh", 0}, {"name", "plate"}}};
    file.slide(0);
    return file.glb();
}

inline std::string flag() {
    TriangleFile file;
    file.hang_on_turning_bone();
    return file.glb();
}

inline EntityDescription moving_model(const TempFolder& folder, const std::string& bytes) {
    EntityDescription model;
    model.name = "model";
    const std::filesystem::path file = folder.write("m.glb", bytes);
    model.visual = ModelVisual{.file = file, .root = file.parent_path()};
    model.body = BodyDescription{.kind = physics::BodyKind::Kinematic};
    return model;
}

}  // namespace plumbline::scene
