// Ropes. Their pieces are bodies that the physics solves; this row switches them.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/parts.h"
#include "engine/scene/simulation/entity_lookup.h"

namespace plumbline::effects {
namespace {

/// While it does not live, ropes stand still as they are.
class RopeEffect final : public Effect {
public:
    explicit RopeEffect(scene::Simulation& simulation) : simulation_(simulation) { stop(false); }
    ~RopeEffect() override { stop(true); }
    RopeEffect(const RopeEffect&) = delete;
    RopeEffect& operator=(const RopeEffect&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        awake_.assign(simulation.ropes().size(), false);
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            if (!moving.awake) continue;
            const auto* piece = simulation.registry.find<scene::PartOf>(moving.entity);
            if (piece == nullptr || piece->whole != scene::PartOf::Whole::Rope) continue;
            awake_[piece->index] = true;
            ++work_.calls;
        }
        const auto& described = simulation.description().forces.ropes;
        for (std::size_t i = 0; i < awake_.size(); ++i) {
            if (awake_[i] && described[i].stiffness_N > 0) show_stretch(simulation.ropes()[i]);
        }
    }

private:
    /// Pieces are drawn as long as their share of the rope is now.
    void show_stretch(const scene::Rope& rope) {
        const std::vector<Vec3d> points = simulation_.points_of(rope);
        if (points.size() != rope.pieces.size() + 1) return;
        for (std::size_t i = 0; i < rope.pieces.size(); ++i) {
            const ecs::Entity entity = scene::entity_of(simulation_, rope.pieces[i]);
            const double length_m = glm::distance(points[i], points[i + 1]);
            simulation_.registry.get<scene::Transform>(entity).scale.y =
                static_cast<Real>(length_m / rope.piece_m);
        }
    }

    void stop(bool stopped) { stop_parts(simulation_, scene::PartOf::Whole::Rope, stopped); }

    scene::Simulation& simulation_;
    std::vector<bool> awake_;  // by rope
};

Callers callers_of_ropes(const scene::Simulation& simulation) {
    return tables_of(simulation, "rope", "rope", simulation.description().forces.ropes);
}

}  // namespace

EffectRow rope() {
    return with_effect<RopeEffect>({.called_for_by = &callers_of_ropes});
}

}  // namespace plumbline::effects
