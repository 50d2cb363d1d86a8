// JSON scenes of one object, and what is said first about wrong ones.
#pragma once

#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {

/// A scene of one object with these members.
inline std::string one_object(std::string_view members) {
    return fmt::format(R"({{"camera": {{"resolution": [4, 3]}}, "objects": [{{{}}}]}})", members);
}

inline const assets::MeshData& mesh_of(const SceneDescription& scene, std::size_t entity) {
    return *std::get<MeshVisual>(scene.entities.at(entity).visual).mesh;
}

class JsonFault : public SceneFileTest {
protected:
    /// What is said first about a scene of that text.
    std::string said_of(std::string_view text) const {
        write("a.json", text);
        const Outcome outcome = load_file("a.json");
        EXPECT_FALSE(outcome.scene.ok()) << text;
        if (outcome.scene.ok()) return {};
        EXPECT_EQ(outcome.scene.error().exit_code, ExitCode::Refused);
        return outcome.faults.at(0);
    }
    std::string said_of_object(std::string_view members) const {
        return said_of(fmt::format(
            R"({{"camera": {{"resolution": [4, 3]}}, "objects": [{{}}, {{{}}}]}})", members));
    }
    std::string said_of_camera(std::string_view members) const {
        return said_of(
            fmt::format(R"({{"camera": {{"resolution": [4, 3]{}}}, "objects": []}})", members));
    }
};

}  // namespace plumbline::scene
