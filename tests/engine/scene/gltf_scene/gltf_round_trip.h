// Scenes written as glTF and read back.
#pragma once

#include "engine/scene/gltf_scene/gltf_export.h"
#include "tests/engine/scene/gltf_scene/gltf_fixture.h"

namespace plumbline::scene::gltf {

/// A scene and what becomes of it by way of a file.
struct RoundTrip {
    test::TemporaryFolder folder;
    test::Running before;
    GltfExport exported;
    Diagnostics faults;
    Result<SceneDescription> description{Error{}};
    std::unique_ptr<test::Running> after;

    explicit RoundTrip(const SceneDescription& scene, const std::string& surroundings = "{}")
        : before(scene), exported(gltf_of(*before, surroundings)) {
        description = read_description(folder.write("m.glb", exported.glb), {}, faults);
        EXPECT_TRUE(description.ok()) << (description.ok() ? "" : description.error().message);
        if (description) after = std::make_unique<test::Running>(*description);
    }

    /// The farthest that a body of this name is from where it would be, m.
    double apart_m(int steps) {
        before.step(steps);
        after->step(steps);
        double worst_m = 0;
        for (const MovingBody& moving : before->moving_bodies()) {
            const std::string& name = before->registry.get<Name>(moving.entity).text;
            const ecs::Entity entity = (*after)->find(name);
            const BodyRef* twin = entity ? (*after)->registry.find<BodyRef>(entity) : nullptr;
            EXPECT_NE(twin, nullptr) << name;
            if (twin == nullptr) continue;
            const Vec3 there = (*after)->physics.state(twin->body).world_from_body.position;
            const Vec3 here = before->physics.state(moving.body).world_from_body.position;
            worst_m = std::max(worst_m, static_cast<double>(glm::distance(here, there)));
        }
        return worst_m;
    }
};

}  // namespace plumbline::scene::gltf
