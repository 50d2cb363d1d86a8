// Water that carries bodies, and resists them.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/physics/field_effect.h"
#include "engine/physics/medium.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyId;
using physics::BodyInField;
using physics::Submersion;

/// Of the mass of the displaced water: what moves along with a ball (Lamb, Hydrodynamics, 92); taken for all shapes.
constexpr double kAddedShare = 0.5;
/// Of critical damping: the waves that a bobbing float sends out, which a level surface does not show. Floats at sea have 0.05 to
/// 0.2 (Newman, Marine Hydrodynamics, 6.19).
constexpr double kRadiated = 0.1;

struct Afloat {
    double coefficient{1};
    double mass_kg{1};
    double added_kg{0};
    bool in_water{false};
    bool followed{false};  ///< since the step before: what it had under water then is known
    double radius_m{0};
    Vec3d half_m{0, 0, 0};  ///< of the box along its principal axes
};

class Buoyancy final : public FieldEffect<Afloat> {
public:
    explicit Buoyancy(scene::Simulation& simulation) : FieldEffect(simulation, "buoyancy") {
        list_now();
    }

    int substeps() const override {
        return by_fidelity(simulation_.description().field_fidelity.buoyancy, std::array{1, 4, 16});
    }
    bool carries() const override { return true; }
    double added_mass_kg(BodyId body) const override {
        return receivers_.has(body) ? own_of(body).added_kg : 0;
    }

    /// What the displaced water has risen by: it lies on the surface now.
    double energy_J() const override {
        double sum = 0;
        for (const auto& [body, own] : receivers_.all()) {
            const physics::BodyState state = simulation_.physics.state(body);
            const Vec3d center(state.center_of_mass_world());
            const scene::WaterDescription* water = water_at(center, own.radius_m);
            if (water == nullptr) continue;
            const Submersion below =
                below_of(*water, body, center, world_from_mass(body, state), kUp);
            sum += density_of(*water) * gravity_mps2() * below.volume_m3 *
                   (static_cast<double>(water->max_m.y) - below.center_m.y);
        }
        return sum;
    }

private:
    static constexpr Vec3d kUp{0, 1, 0};

    void list_receivers() override {
        const Receivers<Afloat> before = receivers_;
        receivers_.clear();
        for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
            if (moving.kind != physics::BodyKind::Dynamic ||
                !simulation_.physics.contains(moving.body))
                continue;
            const auto* drag = simulation_.registry.find<scene::Drag>(moving.entity);
            Afloat own{
                .mass_kg = static_cast<double>(simulation_.physics.state(moving.body).mass.mass_kg),
                .half_m = physics::half_extent_m(simulation_.physics, moving.body)};
            if (drag != nullptr) own.coefficient = static_cast<double>(drag->coefficient);
            own.radius_m = glm::length(own.half_m);
            if (const auto* known = before.find(moving.body)) {
                own.added_kg = known->own.added_kg;
                own.in_water = known->own.in_water;
                own.followed = known->own.followed;
            }
            receivers_.add(moving.body, own);
        }
    }

    bool acts_on(BodyId body) const override {
        const auto* entry = receivers_.find(body);
        return entry != nullptr && entry->own.in_water;
    }

    /// What moves along is taken anew for each step. A body that goes under hands on of its momentum (von Karman 1929).
    void prepare() override {
        for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
            if (!moving.awake || !receivers_.has(moving.body)) continue;
            Afloat& own = receivers_.find(moving.body)->own;
            const physics::BodyState state = simulation_.physics.state(moving.body);
            const Vec3d center(state.center_of_mass_world());
            const scene::WaterDescription* water = water_at(center, own.radius_m);
            own.in_water = water != nullptr;
            double added_kg = 0;
            if (water != nullptr && water->drag > 0) {
                const Submersion below =
                    below_of(*water, moving.body, center, world_from_mass(moving.body, state), kUp);
                added_kg = static_cast<double>(water->drag) * kAddedShare * density_of(*water) *
                           below.volume_m3;
            }
            if (own.followed && added_kg > own.added_kg && state.pushable()) {
                const double kept = (own.mass_kg + own.added_kg) / (own.mass_kg + added_kg);
                const Vec3 against = state.velocity_mps - water->flow_mps;
                simulation_.physics.apply_impulse(
                    moving.body, against * static_cast<Real>((kept - 1) * own.mass_kg));
            }
            own.added_kg = added_kg;
            own.followed = true;
        }
    }

    void push(std::span<BodyInField* const> bodies, const physics::FieldTime& time) override {
        for (BodyInField* body : bodies) {
            const Afloat& own = own_of(body->id);
            const scene::WaterDescription* water = water_at(body->center_m, own.radius_m);
            if (water != nullptr) push_one(*body, own, *water, time.h_s);
        }
    }

    void push_one(BodyInField& body,
                  const Afloat& own,
                  const scene::WaterDescription& water,
                  double h) const {
        const Vec3d against = body.velocity_mps - Vec3d(water.flow_mps);
        // Before weight and lift, which cancel, have given their halves.
        const Vec3d direction = normalize_or(against - 0.5 * body.gain_mps, kUp);
        const Submersion below =
            below_of(water, body.id, body.center_m, body.world_from_mass, direction);
        if (!(below.volume_m3 > 0)) return;
        const double rho = density_of(water);
        const double lift_Ns = rho * gravity_mps2() * below.volume_m3 * h;
        // The waterline makes a spring of it: what it and all else leave over is eased.
        const double share =
            stiff_share(rho * gravity_mps2() * below.waterline_m2, body.mass_kg, h);
        const double left_Ns = lift_Ns + body.gain_mps.y * body.mass_kg;
        body.push({0, lift_Ns + (share - 1) * left_Ns, 0}, below.center_m);
        if (water.drag > 0) resist(body, own, water, below, against, h);
    }

    /// Against the velocity in the middle, which has half of the lift by now: solved over the whole sub-step.
    void resist(BodyInField& body,
                const Afloat& own,
                const scene::WaterDescription& water,
                const Submersion& below,
                const Vec3d& against_before,
                double h) const {
        const double half_rho =
            0.5 * density_of(water) * own.coefficient * static_cast<double>(water.drag);
        const Vec3d against = against_before + body.impulse_Ns / (2 * body.mass_kg);
        const double k = half_rho * below.silhouette_m2 / body.mass_kg;
        const double lost = 1 - 1 / (1 + k * glm::length(against) * h);
        body.impulse_Ns -= against * (lost * body.mass_kg);
        const double weight = density_of(water) * gravity_mps2() * below.waterline_m2;
        const double ringing = 2 * kRadiated * std::min(static_cast<double>(water.drag), 1.0);
        const double bobbing = ringing * std::sqrt(weight / body.mass_kg);
        body.impulse_Ns.y += portable_expm1(-bobbing * h) * against.y * body.mass_kg;
        const double rolling_Nm = weight * below.waterline_m2 / 12;  // a square's
        // Turning, as of a box of its size (MuJoCo's documentation, "Fluid forces": inertia model), by what is under.
        const double under = below.whole_m3 > 0 ? below.volume_m3 / below.whole_m3 : 0;
        Vec3d spin = glm::conjugate(body.world_from_mass) * body.spin_radps;
        for (int i = 0; i < 3; ++i) {
            const double a = own.half_m[(i + 1) % 3];
            const double b = own.half_m[(i + 2) % 3];
            const double turning =
                half_rho * under * own.half_m[i] * (a * a * a * a + b * b * b * b);
            const double rate = (turning * std::abs(spin[i]) / body.inertia_kgm2[i] +
                                 ringing * std::sqrt(rolling_Nm / body.inertia_kgm2[i])) *
                                h;
            spin[i] *= -(1 - 1 / (1 + rate)) * body.inertia_kgm2[i];
        }
        body.angular_impulse_Nms += body.world_from_mass * spin;
    }

    /// Below the level and above the ground of the water.
    Submersion below_of(const scene::WaterDescription& water,
                        BodyId body,
                        const Vec3d& center,
                        const Quatd& orientation,
                        const Vec3d& direction) const {
        const physics::PhysicsWorld& world = simulation_.physics;
        Submersion below = physics::submersion(
            world, body, center, orientation, static_cast<double>(water.max_m.y), direction);
        const auto ground_m = static_cast<double>(water.min_m.y);
        if (below.volume_m3 <= 0 || center.y - own_of(body).radius_m > ground_m) return below;
        const Submersion under =
            physics::submersion(world, body, center, orientation, ground_m, direction);
        const double volume_m3 = below.volume_m3 - under.volume_m3;
        if (volume_m3 > 0 && under.volume_m3 > 0)
            below.center_m =
                (below.center_m * below.volume_m3 - under.center_m * under.volume_m3) / volume_m3;
        below.volume_m3 = std::max(volume_m3, 0.0);
        return below;
    }

    const scene::WaterDescription* water_at(const Vec3d& center, double radius_m) const {
        for (const scene::WaterDescription& water : simulation_.description().waters) {
            const Vec3d low(water.min_m);
            const Vec3d high(water.max_m);
            if (center.x >= low.x && center.x <= high.x && center.z >= low.z &&
                center.z <= high.z && center.y - radius_m < high.y && center.y + radius_m > low.y)
                return &water;
        }
        return nullptr;
    }

    static double density_of(const scene::WaterDescription& water) {
        return static_cast<double>(water.density_kgpm3);
    }
    double gravity_mps2() const {
        return std::max(-static_cast<double>(simulation_.physics.def().gravity_mps2.y), 0.0);
    }
    Quatd world_from_mass(BodyId body, const physics::BodyState& state) const {
        return Quatd(state.world_from_body.orientation) *
               glm::conjugate(physics::mass_from_body(simulation_.physics, body));
    }
    const Afloat& own_of(BodyId body) const { return receivers_.find(body)->own; }
};

Callers callers_of_buoyancy(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("buoyancy", true)) return {};
    Callers callers;
    for (const scene::WaterDescription& water : simulation.description().waters)
        callers.push_back(setting("[[water]] " + water.name, water.location));
    return callers;
}

}  // namespace

EffectRow buoyancy() {
    return with_effect<Buoyancy>({.called_for_by = &callers_of_buoyancy});
}

}  // namespace plumbline::effects
