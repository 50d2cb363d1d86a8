// Bodies that break where loads pull their pieces apart.
#include "engine/physics/fracture.h"

#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/physics/medium.h"
#include "engine/scene/build/fragments.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline::effects {
namespace {

using physics::BodyLoad;
using physics::FractureNetwork;

/// By how much loads may change before stress is found anew: as a share of them, times the share of the strength that is left.
constexpr std::array kUnfelt{0.5, 0.1, 0.0};
/// Of what is above the strength, what breaks before stress is found anew; at least one bond.
constexpr std::array kAtOnce{1.0, 0.2, 0.0};
constexpr std::array kRounds{2, 10, 100};
/// Of the strength that is left, at least.
constexpr double kLeft = 0.02;

/// What is known of a body that can break, while it lives.
struct Watched {
    FractureNetwork network;
    std::vector<BodyLoad> loads{};  ///< body frame, as stress was found last
    Vec3d spin_radps{0, 0, 0};
    double used{0};  ///< of the strength
};

class Fracture final : public Effect {
public:
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        std::vector<ecs::Entity> breaking;
        simulation.registry.view<scene::Fragile, const scene::BodyRef>().each(
            [&](ecs::Entity entity, scene::Fragile& fragile, const scene::BodyRef& ref) {
                if (fragile.pieces.size() < 2 || !simulation.physics.contains(ref.body)) return;
                const physics::BodyState state = simulation.physics.state(ref.body);
                if (!state.awake || !state.pushable()) return;
                if (strain(simulation, entity, fragile, ref.body, state))
                    breaking.push_back(entity);
            });
        for (const ecs::Entity entity : breaking) {
            const FractureNetwork& network = watched_.at(entity).network;
            simulation.break_up(entity, network.parts(), network.cracked());
            watched_.erase(entity);
        }
        forget_gone(simulation);
    }

    std::uint64_t bytes_held() const override { return watched_.size() * sizeof(Watched); }

private:
    /// Whether it falls apart.
    bool strain(scene::Simulation& simulation,
                ecs::Entity entity,
                scene::Fragile& fragile,
                physics::BodyId body,
                const physics::BodyState& state) {
        const scene::FragileWhole& whole = *simulation.wholes()[fragile.whole];
        const scene::FractureDescription& says = *whole.description.body->fracture;
        const auto fidelity = simulation.description().forces.fidelity.fracture;
        Watched& watched = watch(whole, entity, fragile);
        const Quatd back = glm::conjugate(Quatd(state.world_from_body.orientation));
        const Vec3d spin_radps = back * Vec3d(state.angular_velocity_radps);
        std::vector<BodyLoad> loads =
            loads_in_body(simulation, whole, fragile, body, state.world_from_body);
        if (!differ(watched, loads, spin_radps, whole, by_fidelity(fidelity, kUnfelt)))
            return false;
        ++work_.calls;
        const auto strength_Pa = static_cast<double>(says.strength_Pa);
        const std::vector<double> stress = watched.network.stress_Pa(loads, spin_radps);
        watched.used = std::ranges::max(stress) / strength_Pa;
        watched.loads = std::move(loads);
        watched.spin_radps = spin_radps;
        if (watched.used <= 1) return false;
        watched.network.crack(watched.loads,
                              spin_radps,
                              strength_Pa,
                              by_fidelity(fidelity, kAtOnce),
                              by_fidelity(fidelity, kRounds));
        fragile.cracked = watched.network.cracked();
        watched.loads.clear();
        return watched.network.parts().size() > 1;
    }

    Watched& watch(const scene::FragileWhole& whole,
                   ecs::Entity entity,
                   const scene::Fragile& fragile) {
        const auto known = watched_.find(entity);
        if (known != watched_.end()) return known->second;
        return watched_
            .emplace(
                entity,
                Watched{.network = FractureNetwork(
                            whole.pattern, fragile.pieces, fragile.cracked, whole.density_kgpm3)})
            .first->second;
    }

    /// An impact lasts as long as sound takes from one end to the other and back.
    static double impact_s(const scene::FragileWhole& whole) {
        const auto stiffness_Pa =
            static_cast<double>(whole.description.body->fracture->stiffness_Pa);
        return 2 * whole.pattern.longest_m / std::sqrt(stiffness_Pa / whole.density_kgpm3);
    }

    static std::vector<BodyLoad> loads_in_body(const scene::Simulation& simulation,
                                               const scene::FragileWhole& whole,
                                               const scene::Fragile& fragile,
                                               physics::BodyId body,
                                               const Pose& at) {
        const double lasts_s = impact_s(whole);
        std::vector<BodyLoad> loads = physics::loads_on(simulation.physics, body, lasts_s);
        for (const scene::Blow& blow : simulation.blows) {
            if (blow.body == body)
                loads.push_back({.point_m = Vec3d(blow.point_world),
                                 .force_N = Vec3d(blow.impulse_Ns) / lasts_s});
        }
        const Quatd back = glm::conjugate(Quatd(at.orientation));
        const Vec3d origin_m = scene::origin_of(whole.pattern, fragile.pieces);
        for (BodyLoad& load : loads) {
            load.point_m = origin_m + back * (load.point_m - Vec3d(at.position));
            load.force_N = back * load.force_N;
            load.torque_Nm = back * load.torque_Nm;
        }
        return loads;
    }

    static bool differ(const Watched& watched,
                       const std::vector<BodyLoad>& loads,
                       const Vec3d& spin_radps,
                       const scene::FragileWhole& whole,
                       double unfelt) {
        if (loads.size() != watched.loads.size()) return true;
        const double size_m = whole.pattern.longest_m;
        const double mass_kg = whole.density_kgpm3 * whole.pattern.volume_m3;
        const auto spun_N = [&](const Vec3d& spin) {
            return mass_kg * size_m * glm::dot(spin, spin);
        };
        double change_N = std::abs(spun_N(spin_radps) - spun_N(watched.spin_radps));
        double sum_N = spun_N(watched.spin_radps);
        for (std::size_t i = 0; i < loads.size(); ++i) {
            const BodyLoad& now = loads[i];
            const BodyLoad& then = watched.loads[i];
            const double then_N = glm::length(then.force_N) + glm::length(then.torque_Nm) / size_m;
            sum_N += then_N;
            change_N += glm::distance(now.force_N, then.force_N) +
                        glm::distance(now.torque_Nm, then.torque_Nm) / size_m +
                        then_N * glm::distance(now.point_m, then.point_m) / size_m;
        }
        return change_N > unfelt * std::max(1 - watched.used, kLeft) * sum_N;
    }

    void forget_gone(const scene::Simulation& simulation) {
        std::erase_if(watched_,
                      [&](const auto& one) { return !simulation.registry.alive(one.first); });
    }

    std::map<ecs::Entity, Watched> watched_;
};

/// What is left in single pieces calls for nothing.
Callers callers_of_fracture(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("fracture", true)) return {};
    EntityCallers callers(simulation);
    for (auto [entity, fragile] : simulation.registry.view<const scene::Fragile>()) {
        if (fragile.pieces.size() > 1) callers.add(entity);
    }
    return callers.take();
}

}  // namespace

EffectRow fracture() {
    return with_effect<Fracture>({.called_for_by = &callers_of_fracture});
}

}  // namespace plumbline::effects
