// The bars and wires that joints stand for: seen, and nothing else.
#include "engine/assets/primitives.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/extract.h"
#include "engine/scene/simulation/entity_lookup.h"

namespace plumbline::effects {
namespace {

constexpr Real kShortest_m = 1e-4_r;

class JointBars final : public Effect {
public:
    explicit JointBars(scene::Simulation& simulation)
        : mesh_(simulation.library().add_mesh("joint bar", assets::cylinder_mesh(1.0F, 1.0F))),
          material_(simulation.library().add_material({.name = "joint bar",
                                                       .base_color = Vec3f{0.12F},
                                                       .roughness = 0.5F,
                                                       .metallic = 0.6F})) {}

    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        for (const scene::SceneJoint& joint : simulation.joints()) {
            if (joint.bar_m <= 0 || !simulation.physics.contains(joint.joint)) continue;
            const physics::JointView held = simulation.physics.joint(joint.joint);
            if (held.state.broken) continue;
            // Of a joint that turns about one point, the bar goes to there from the middle of a.
            const bool is_between = held.def.kind == physics::JointKind::Distance ||
                                    held.def.kind == physics::JointKind::Spring;
            const Vec3 start = is_between ? joint.anchor_a_body : Vec3{0, 0, 0};
            const Vec3 from = drawn(simulation, held.def.a, start, view.blend);
            const Vec3 to = drawn(simulation, held.def.b, joint.anchor_b_body, view.blend);
            add(from, to, joint.bar_m, frame);
        }
        ++work_.calls;
    }

private:
    static Vec3 drawn(const scene::Simulation& simulation,
                      physics::BodyId body,
                      const Vec3& anchor_body,
                      Real blend) {
        if (!body) return anchor_body;  // of the world
        const ecs::Entity entity = scene::entity_of(simulation, body);
        const auto& transform = simulation.registry.get<scene::Transform>(entity);
        return transform_point(scene::drawn_pose(simulation, entity, transform, blend),
                               anchor_body);
    }

    void add(const Vec3& from, const Vec3& to, Real radius_m, render::RenderFrame& frame) const {
        const Real length_m = glm::distance(from, to);
        if (length_m < kShortest_m) return;
        const Vec3 along = (to - from) / length_m;
        const Vec3 aside = std::abs(along.x) < 0.5_r ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
        const Vec3 across = glm::normalize(glm::cross(aside, along));
        const Pose pose{
            .position = (from + to) * 0.5_r,
            .orientation = glm::quat_cast(Mat3(across, along, glm::cross(across, along)))};
        render::add_item(
            frame,
            {.mesh = mesh_, .world_from_body = matrix_of(pose, {radius_m, length_m, radius_m})},
            {&material_, 1});
    }

    assets::MeshId mesh_;
    assets::MaterialId material_;
};

Callers callers_of_joint_bars(const scene::Simulation& simulation) {
    Callers callers;
    for (const scene::SceneJoint& joint : simulation.joints()) {
        if (joint.bar_m > 0) callers.push_back(setting("[[joint]] " + joint.name, joint.location));
    }
    return callers;
}

}  // namespace

EffectRow joint_bars() {
    return with_effect<JointBars>({.called_for_by = &callers_of_joint_bars});
}

}  // namespace plumbline::effects
