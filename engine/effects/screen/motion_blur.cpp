// A shutter that stays open while the camera and things move. World time counts: in slow motion streaks
// are no shorter, and a world that stands still is sharp.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/extract.h"

#include <utility>
#include <vector>

namespace plumbline::effects {
namespace {

constexpr std::array<std::uint32_t, 3> kStreakSamples{6, 16, 48};  // by fidelity
// A longer gap between two frames, or a faster way, is a cut to another view.
constexpr double kLongestGap_s = 0.1;
constexpr Real kFastest_mps = 100;

/// `now`, moved on by that share of the way back to `before`.
Pose back_along(const Pose& before, const Pose& now, Real share) {
    const Quat turn =
        glm::slerp(Quat{1, 0, 0, 0}, before.orientation * glm::conjugate(now.orientation), share);
    return {.position = now.position + (before.position - now.position) * share,
            .orientation = turn * now.orientation};
}

/// What moved in the latest step goes on as it did while the shutter is open.
std::vector<render::MovedMesh> moved_meshes(const scene::Simulation& simulation,
                                            Real blend,
                                            Real open_s) {
    std::vector<render::MovedMesh> moved;
    const auto steps = open_s / static_cast<Real>(simulation.step_s());
    for (auto [entity, visual, transform, previous] :
         simulation.registry
             .view<const scene::Visual, const scene::Transform, const scene::PreviousTransform>()) {
        const Pose& to = transform.world_from_body;
        const Pose& from = previous.world_from_body;
        if (from.position == to.position && from.orientation == to.orientation) continue;
        if (simulation.registry.has<scene::PlayingModel>(entity)) continue;
        const Pose now = scene::drawn_pose(simulation, entity, transform, blend);
        const Pose opened = back_along(from, to, Real{1} - blend + steps);
        moved.push_back({.mesh = visual.mesh,
                         .world_from_body = matrix_of(now, transform.scale),
                         .world_from_body_before = matrix_of(opened, transform.scale)});
    }
    return moved;
}

class MotionBlur final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        const double step_s = simulation.step_s();
        const double now_s = simulation.time_s() + (static_cast<double>(view.blend) - 1.0) * step_s;
        const double gap_s = now_s - before_s_;
        const Pose now = view.world_from_camera;
        if (gap_s > 0.0 && gap_s <= kLongestGap_s && !is_cut(now, static_cast<Real>(gap_s)))
            add(simulation, view, static_cast<Real>(gap_s), frame);
        before_ = now;
        before_s_ = now_s;
    }

private:
    bool is_cut(const Pose& now, Real gap_s) const {
        return glm::distance(now.position, before_.position) > kFastest_mps * gap_s;
    }
    void add(const scene::Simulation& simulation,
             const scene::ViewPoint& view,
             Real gap_s,
             render::RenderFrame& frame) {
        const scene::SceneDescription& scene = simulation.description();
        const auto open_s = static_cast<Real>(scene.post->shutter->open_s);
        // Where it was when the shutter opened, as it moved between the two frames.
        const Pose& now = view.world_from_camera;
        const Pose opened = back_along(before_, now, open_s / gap_s);
        std::vector<render::MovedMesh> moved = moved_meshes(simulation, view.blend, open_s);
        if (moved.empty() && now.position == before_.position &&
            now.orientation == before_.orientation)
            return;
        frame.motion_blur = render::MotionBlur{
            .position_before_world = Vec3f(opened.position),
            .orientation_before = Quatf(opened.orientation),
            .samples = by_fidelity(scene.screen_fidelity.shutter, kStreakSamples),
            .moved = std::move(moved)};
        ++work_.calls;
    }

    Pose before_{};
    double before_s_{-1e9};
};

Callers callers_of_motion_blur(const scene::Simulation& simulation) {
    const auto& post = simulation.description().post;
    if (!post || !post->shutter || !simulation.switches.is_on("motion_blur", true)) return {};
    return {setting("[post] shutter_s", post->shutter->location)};
}

}  // namespace

EffectRow motion_blur() {
    return with_effect<MotionBlur>({.called_for_by = &callers_of_motion_blur,
                                    .gpu_owner = "motion_blur",
                                    .passes = "motion_blur"});
}

}  // namespace plumbline::effects
