// Air that bodies feel: drag in still air, wind and wind zones, the lift of what spins and of what is lighter than air.
#include "engine/core/io/archive.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/fields/air.h"
#include "engine/effects/fields/field_effect.h"
#include "engine/effects/fields/silhouette_map.h"
#include "engine/physics/medium.h"
#include "engine/physics/query.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyInField;

/// How far a static thing upwind shelters what stands in its lee.
constexpr double kLee_m = 12;
/// Of the weight: what the wind's push must have changed by for a body at rest to wake.
constexpr double kWakingShare = 0.05;

struct InAir {
    scene::Drag drag;
    double mass_kg{1};
    double in_wind{
        1};  ///< share of the wind that reaches it; the rest is kept off by things upwind
    Vec3d resting_N{0, 0, 0};  ///< of the air when it came to rest
    bool rested{false};
    bool has_parts{false};   ///< its silhouette is worth keeping
    double displaced_kg{0};  ///< of air, where that carries it
    SilhouetteMap silhouettes{};
};

class AirDrag final : public FieldEffect<InAir> {
public:
    explicit AirDrag(scene::Simulation& simulation)
        : FieldEffect(simulation, "drag"),
          fidelity_(simulation.description().forces.fidelity.drag) {
        list_now();
    }

    int substeps() const override { return field_substeps(fidelity_); }
    double added_mass_kg(physics::BodyId body) const override {
        const auto* entry = receivers_.find(body);
        return entry != nullptr ? physics::kAddedShare * entry->own.displaced_kg : 0;
    }
    /// What is lighter than air falls upwards.
    double energy_J() const override {
        double sum = 0;
        for (const auto& [body, own] : receivers_.all()) {
            if (own.displaced_kg == 0) continue;
            const Vec3d center(simulation_.physics.state(body).center_of_mass_world());
            sum += own.displaced_kg * glm::dot(gravity_mps2(), center);
        }
        return sum;
    }
    void serialize(Archive& archive) override {
        for (auto& [body, own] : receivers_.all()) archive(own.resting_N, own.rested);
    }

private:
    void list_receivers() override {
        receivers_.clear();
        each_dynamic_body<scene::Drag>(
            simulation_, [this](physics::BodyId body, const scene::Drag& drag) {
                const auto mass_kg =
                    static_cast<double>(simulation_.physics.state(body).mass.mass_kg);
                receivers_.add(body,
                               {.drag = drag,
                                .mass_kg = mass_kg,
                                .has_parts = physics::part_count(simulation_.physics, body) > 1,
                                .displaced_kg = drag.buoyant ? displaced_kg(body) : 0});
            });
    }

    Vec3d gravity_mps2() const { return Vec3d(simulation_.physics.def().gravity_mps2); }

    /// Its whole volume in air.
    double displaced_kg(physics::BodyId body) const {
        const double volume_m3 =
            physics::submersion(simulation_.physics, body, {}, 0, {0, 1, 0}).whole_m3;
        return volume_m3 * static_cast<double>(simulation_.description().forces.air_density_kgpm3);
    }

    void prepare() override {
        time_s_ = simulation_.time_s();
        const scene::SceneDescription& scene = simulation_.description();
        air_ = Air(simulation_);
        if (!air_.blows()) return;
        for (auto& [body, own] : receivers_.all()) {
            const physics::BodyState state = simulation_.physics.state(body);
            const Vec3 center = state.center_of_mass_world();
            if (scene.wind && scene.wind->shelter) own.in_wind = share_of_wind(body, center);
            if (state.awake || state.frozen) {
                own.rested = false;
                continue;
            }
            const Vec3d now_N =
                push_at_rest_N(body, own, Vec3d(center), Quatd(state.world_from_body.orientation));
            if (!own.rested) own.resting_N = now_N;
            own.rested = true;
            const double change_N = glm::length(now_N - own.resting_N);
            if (change_N > kWakingShare * own.mass_kg * physics::kStandardGravity_mps2)
                simulation_.physics.wake(body);
        }
    }

    void push(std::span<BodyInField* const> bodies, const physics::FieldTime& time) override {
        for (BodyInField* body : bodies) push_one(*body, receivers_.find(body->id)->own, time);
    }

    /// The velocity against the air, after h, is shortened by 1 / (1 + k v h): the exact solution of v' = -k v2. Lift turns it
    /// about the spin by an angle. Both commute.
    void push_one(BodyInField& body, InAir& own, const physics::FieldTime& time) const {
        const Vec3d lift_Ns = gravity_mps2() * (-own.displaced_kg * time.h_s);
        body.impulse_Ns += lift_Ns;
        const Vec3d air_mps = air_.at(body.center_m, time_s_ + time.at_s, own.in_wind);
        const Vec3d before = body.velocity_mps + lift_Ns / (2 * body.mass_kg) - air_mps;
        const double speed = glm::length(before);
        if (!(speed > 0) || !std::isfinite(speed)) return;
        const Vec3d direction_mass = glm::conjugate(body.world_from_mass) * (before / speed);
        const double area_m2 = area_of(body.id, own, direction_mass);
        const double half_rho =
            0.5 * static_cast<double>(simulation_.description().forces.air_density_kgpm3);
        const double k =
            half_rho * static_cast<double>(own.drag.coefficient) * area_m2 / body.mass_kg;
        Vec3d after = before / (1 + k * speed * time.h_s);
        const double spin = glm::length(body.spin_radps);
        if (own.drag.spin_lift != 0 && spin > 0) {
            const double radius_m = std::sqrt(area_m2 / static_cast<double>(kPi));
            const double turn_rad = half_rho * static_cast<double>(own.drag.spin_lift) * area_m2 *
                                    radius_m * spin / body.mass_kg * time.h_s;
            after = portable_angle_axis(turn_rad, body.spin_radps / spin) * after;
        }
        body.impulse_Ns += (after - before) * body.mass_kg;
    }

    double area_of(physics::BodyId body, InAir& own, const Vec3d& direction_mass) const {
        if (own.drag.area_m2 > 0) return static_cast<double>(own.drag.area_m2);
        const auto exact = [&](const Vec3d& direction) {
            return physics::silhouette_m2(simulation_.physics, body, direction);
        };
        return own.has_parts ? own.silhouettes.at(direction_mass, exact) : exact(direction_mass);
    }

    Vec3d push_at_rest_N(physics::BodyId body,
                         InAir& own,
                         const Vec3d& center,
                         const Quatd& orientation) const {
        const Vec3d air_mps = air_.at(center, time_s_, own.in_wind);
        const double speed = glm::length(air_mps);
        if (!(speed > 0)) return {0, 0, 0};
        const double area_m2 = area_of(body, own, glm::conjugate(orientation) * (air_mps / speed));
        return air_mps *
               (0.5 * static_cast<double>(simulation_.description().forces.air_density_kgpm3) *
                static_cast<double>(own.drag.coefficient) * area_m2 * speed);
    }

    /// Falls to nothing right behind what stands upwind.
    double share_of_wind(physics::BodyId body, const Vec3& center) const {
        const Vec3 upwind = -simulation_.description().wind->direction;
        const auto hit = physics::cast_ray(simulation_.physics,
                                           center,
                                           center + upwind * static_cast<Real>(kLee_m),
                                           {.ignored = body});
        if (!hit || simulation_.physics.state(hit->body).kind != physics::BodyKind::Static)
            return 1;
        return static_cast<double>(hit->distance_m) / kLee_m;
    }

    scene::Fidelity fidelity_;
    double time_s_{0};
    Air air_;
};

Callers callers_of_drag(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("drag", true)) return {};
    return entities_with<scene::Drag>(simulation);
}

}  // namespace

EffectRow drag() {
    return with_effect<AirDrag>({.called_for_by = &callers_of_drag});
}

}  // namespace plumbline::effects
