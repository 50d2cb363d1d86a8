// Joints that creak as they turn, by how fast and under what load.
#include "engine/core/hash.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/sound/sound_bank.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {

namespace {

constexpr float kFullCreak_W = 6.0F;       ///< load times speed at the pin: 30 kg, a turn in 6 s
constexpr float kPin_m = 0.02F;            ///< radius at which the parts rub
constexpr float kLeastTurn_radps = 0.03F;  ///< slower is rest that has not quite ended
constexpr float kLeastCreak = 0.02F;
constexpr double kCreakSwell_s = 0.06;
constexpr std::size_t kCreaksHeard = 6;

struct CreakingJoint {
    std::size_t joint{0};  ///< of the simulation's
    audio::LoopCue cue{};  ///< without its gain
    float level{0.0F};
};

const std::filesystem::path& creak_file(const scene::Simulation& simulation, physics::BodyId body) {
    static const std::filesystem::path kNone;
    if (!body || !simulation.physics.contains(body)) return kNone;
    const ecs::Entity entity = entity_of(simulation, body);
    const auto* surface = simulation.registry.alive(entity)
                              ? simulation.registry.find<scene::SurfaceRef>(entity)
                              : nullptr;
    return surface == nullptr ? kNone : simulation.surfaces().get(surface->surface).creak_sound;
}

/// "garden gate: creaking"
std::string creak_caption(const scene::Simulation& simulation, physics::BodyId body) {
    const ecs::Entity entity = entity_of(simulation, body);
    const auto* name =
        simulation.registry.alive(entity) ? simulation.registry.find<scene::Name>(entity) : nullptr;
    return name == nullptr || name->label.empty() ? "creaking" : name->label + ": creaking";
}

std::uint64_t mark_of_body(const scene::Simulation& simulation, physics::BodyId body) {
    return body && simulation.physics.contains(body) ? simulation.physics.state(body).user : 0;
}

class CreakSounds final : public Effect {
public:
    explicit CreakSounds(scene::Simulation& simulation) {
        const scene::Surface& plain = simulation.surfaces().get(0);
        for (std::size_t i = 0; i < simulation.joints().size(); ++i) {
            const scene::SceneJoint& joint = simulation.joints()[i];
            if (joint.creak <= 0.0F || !simulation.physics.contains(joint.joint)) continue;
            const physics::JointDef& def = simulation.physics.joint(joint.joint).def;
            const std::filesystem::path& of_a = creak_file(simulation, def.a);
            const std::filesystem::path& of_b = creak_file(simulation, def.b);
            const std::filesystem::path& file =
                !of_a.empty() ? of_a : (!of_b.empty() ? of_b : plain.creak_sound);
            if (file.empty()) continue;
            CreakingJoint creaking{.joint = i};
            Hasher hasher;
            hasher.add(joint.name.data(), joint.name.size());
            creaking.cue.key = hasher.digest() | (std::uint64_t{1} << 63U);
            creaking.cue.sound = bank_.get(simulation, file);
            creaking.cue.made_by = {mark_of_body(simulation, def.a),
                                    mark_of_body(simulation, def.b)};
            creaking.cue.caption = creak_caption(simulation, def.a);
            joints_.push_back(creaking);
        }
    }

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        const physics::PhysicsWorld& world = simulation.physics;
        const auto share = static_cast<float>(1.0 - std::exp(-world.def().step_s / kCreakSwell_s));
        for (CreakingJoint& creaking : joints_) {
            const float wanted = level_of(world, simulation.joints()[creaking.joint], creaking);
            creaking.level += share * (wanted - creaking.level);
        }
    }

    void sound(const scene::Simulation&, const scene::ViewPoint&, SoundFrame& frame) override {
        std::vector<audio::LoopCue> loops;
        for (const CreakingJoint& creaking : joints_) {
            if (creaking.level < kLeastCreak) continue;
            loops.push_back(creaking.cue);
            loops.back().gain = std::min(creaking.level, 1.0F);
            loops.back().radius_m = 8.0F + 12.0F * loops.back().gain;
        }
        std::ranges::sort(loops, std::greater{}, &audio::LoopCue::gain);
        loops.resize(std::min(loops.size(), kCreaksHeard));
        work_.calls += loops.size();
        frame.loops.insert(frame.loops.end(), loops.begin(), loops.end());
    }

    std::uint64_t bytes_held() const override {
        return bank_.bytes() + joints_.capacity() * sizeof(CreakingJoint);
    }

private:
    static float level_of(const physics::PhysicsWorld& world,
                          const scene::SceneJoint& joint,
                          CreakingJoint& creaking) {
        if (!world.contains(joint.joint) || world.joint(joint.joint).state.broken) return 0.0F;
        const physics::JointDef& def = world.joint(joint.joint).def;
        const physics::BodyState a = world.state(def.a);
        if (!a.awake) return 0.0F;
        Vec3 turning = a.angular_velocity_radps;
        if (def.b) turning -= world.state(def.b).angular_velocity_radps;
        const Real turn = glm::length(turning);
        const auto turn_radps = static_cast<float>(turn);
        if (!(turn_radps > kLeastTurn_radps)) return 0.0F;
        const Vec3 at = transform_point(a.world_from_body, joint.anchor_a_body);
        creaking.cue.position_world = Vec3f(at);
        const Vec3 velocity_mps =
            a.velocity_mps + glm::cross(a.angular_velocity_radps, at - a.world_from_body.position);
        creaking.cue.velocity_mps = Vec3f(velocity_mps);
        creaking.cue.pitch = std::clamp(0.75F + 0.3F * turn_radps, 0.75F, 1.6F);
        const auto load_N = static_cast<float>(world.joint(joint.joint).state.force_N);
        const float power_W = load_N * kPin_m * turn_radps;
        return joint.creak * std::sqrt(std::min(power_W / kFullCreak_W, 1.0F));
    }

    SoundBank bank_;
    std::vector<CreakingJoint> joints_;
};

Callers callers_of_creak_sounds(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("creak_sounds", true)) return {};
    Callers callers;
    for (const scene::SceneJoint& joint : simulation.joints()) {
        if (joint.creak > 0.0F && simulation.physics.contains(joint.joint))
            callers.push_back(setting("joint " + joint.name, joint.location));
    }
    return callers;
}

}  // namespace

EffectRow creak_sounds() {
    return with_effect<CreakSounds>({.called_for_by = &callers_of_creak_sounds});
}

}  // namespace plumbline::effects
