// Water that carries bodies, and resists them.
#include "engine/core/io/archive.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/fields/field_effect.h"
#include "engine/physics/medium.h"
#include "engine/scene/environment/wave_field.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using physics::BodyId;
using physics::BodyInField;
using physics::Submersion;

/// Of the mass: as much more moves along before momentum is handed on to it again. What bobs is left in peace.
constexpr double kReckoned = 1e-3;
/// A float at rest wakes when the surface has risen or fallen by so much.
constexpr double kWakingRise_m = 1e-3;

/// Of bodies; a damaged save names none beyond.
constexpr std::uint32_t kMostIndex = 1U << 24U;

/// Its water is the one that it is in, in this step.
struct Afloat : scene::Displaced {
    double coefficient{1};
    double mass_kg{1};
    Vec3d half_m{0, 0, 0};   ///< of the box along its principal axes
    double rise_m{0};        ///< of the surface at its place, above the water's level
    glm::dvec2 slope{0, 0};  ///< of the surface, along x and z
    double added_kg{0};      ///< of water that moves along
    double reckoned_kg{0};   ///< of that, what momentum was handed on to
    bool followed{false};    ///< since the step before: what it had under water then is known

    void serialize(Archive& archive) {
        scene::Displaced::serialize(archive);
        archive(coefficient, mass_kg, half_m, rise_m, slope.x, slope.y, added_kg, reckoned_kg);
        archive(followed);
    }
};

class Buoyancy final : public FieldEffect<Afloat> {
public:
    explicit Buoyancy(scene::Simulation& simulation) : FieldEffect(simulation, "buoyancy") {
        list_now();
    }

    int substeps() const override {
        return field_substeps(simulation_.description().forces.fidelity.buoyancy);
    }
    bool carries() const override { return true; }
    double added_mass_kg(BodyId body) const override {
        return receivers_.has(body) ? own_of(body).added_kg : 0;
    }

    /// What the displaced water has risen by: it lies on the level surface now. Waves have their own.
    double energy_J() const override {
        double sum = 0;
        for (const auto& [body, own] : receivers_.all()) {
            const physics::BodyState state = simulation_.physics.state(body);
            const Vec3d center(state.center_of_mass_world());
            Afloat there = own;
            find_water(there, center);
            if (there.water < 0) continue;
            there.rise_m = 0;
            const Submersion below = below_of(
                there, body, center, physics::world_from_mass(simulation_.physics, body), kUp);
            sum += weight_Npm3(there) * below.volume_m3 * (level_m(there) - below.center_m.y);
        }
        return sum;
    }

    /// The body's motion in the step does work on the waves: as much as they did on it, at the surface that it felt.
    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        if (!has_waves()) return;
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            auto* entry = moving.awake ? receivers_.find(moving.body) : nullptr;
            if (entry == nullptr || waves_of(entry->own) == nullptr) continue;
            if (simulation.physics.contains(moving.body)) move_displaced(moving.body, entry->own);
        }
    }

    void serialize(Archive& archive) override {
        // Those that went in the latest step, too: the waves still know their volume.
        std::vector<Receivers<Afloat>::Entry> kept = receivers_.all();
        archive(kept);
        if (!archive.reads()) return;
        const auto waters = static_cast<int>(simulation_.waters.size());
        receivers_.clear();
        for (const auto& each : kept) {
            if (archive.expect(each.own.water < waters && each.body.index < kMostIndex,
                               "a body and a water that are there"))
                receivers_.add(each.body, each.own);
        }
        receivers_.sort();
        list_before_next_step();
    }

private:
    static constexpr Vec3d kUp{0, 1, 0};

    void list_receivers() override {
        Receivers<Afloat> before = receivers_;
        receivers_.clear();
        for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
            if (moving.kind != physics::BodyKind::Dynamic ||
                !simulation_.physics.contains(moving.body))
                continue;
            auto* known = before.find(moving.body);
            receivers_.add(moving.body, known != nullptr ? known->own : new_body(moving));
            if (known != nullptr) known->own.volume_m3 = 0;
        }
        // What is gone has left its place to the water.
        for (auto& [body, own] : before.all()) displace(own, {});
    }

    Afloat new_body(const scene::MovingBody& moving) const {
        Afloat own;
        own.mass_kg = static_cast<double>(simulation_.physics.state(moving.body).mass.mass_kg);
        own.half_m = physics::half_extent_m(simulation_.physics, moving.body);
        own.radius_m = glm::length(own.half_m);
        const auto* drag = simulation_.registry.find<scene::Drag>(moving.entity);
        if (drag != nullptr) own.coefficient = static_cast<double>(drag->coefficient);
        return own;
    }

    bool acts_on(BodyId body) const override {
        const auto* entry = receivers_.find(body);
        return entry != nullptr && entry->own.water >= 0;
    }

    void prepare() override {
        if (has_waves()) wake_by_waves();
        for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
            if (!moving.awake || !receivers_.has(moving.body)) continue;
            follow(moving.body, receivers_.find(moving.body)->own);
        }
    }

    void wake_by_waves() {
        for (const auto& [body, own] : receivers_.all()) {
            if (own.water < 0 || waves_of(own) == nullptr || waves_of(own)->is_asleep()) continue;
            if (simulation_.physics.state(body).awake) continue;
            Afloat there = own;
            find_water(there, own.place_m);
            if (std::abs(there.rise_m - own.rise_m) > kWakingRise_m) simulation_.physics.wake(body);
        }
    }

    /// Where it is, and what of the water moves along, is taken anew for each step.
    void follow(BodyId body, Afloat& own) {
        const physics::BodyState state = simulation_.physics.state(body);
        const Vec3d center(state.center_of_mass_world());
        Afloat before = own;
        find_water(own, center);
        double volume_m3 = 0;
        double added_kg = 0;
        if (own.water >= 0) {
            volume_m3 =
                below_of(
                    own, body, center, physics::world_from_mass(simulation_.physics, body), kUp)
                    .volume_m3;
            added_kg = static_cast<double>(water_of(own).drag) * physics::kAddedShare *
                       density_of(own) * volume_m3;
        }
        if (own.followed && own.water == before.water) {
            if (scene::WaveField* waves = waves_of(own))
                waves->raise_level(volume_m3 - before.volume_m3);
        } else if (own.followed) {
            displace(before, at(own, center, volume_m3));
        }
        own.volume_m3 = volume_m3;
        own.place_m = center;
        own.added_kg = added_kg;
        if (!own.followed || added_kg < own.reckoned_kg) own.reckoned_kg = added_kg;
        own.followed = true;
        if (added_kg > own.reckoned_kg + kReckoned * own.mass_kg && state.pushable())
            hand_on(body, own, state);
    }

    void move_displaced(BodyId body, Afloat& own) const {
        const physics::BodyState state = simulation_.physics.state(body);
        const Vec3d center(state.center_of_mass_world());
        const double volume_m3 =
            below_of(own, body, center, physics::world_from_mass(simulation_.physics, body), kUp)
                .volume_m3;
        displace(own, at(own, center, volume_m3));
    }

    /// A body that goes under hands on of its momentum to what moves along from now on (von Karman 1929).
    void hand_on(BodyId body, Afloat& own, const physics::BodyState& state) {
        const double kept = (own.mass_kg + own.reckoned_kg) / (own.mass_kg + own.added_kg);
        const Vec3 against = state.velocity_mps - water_of(own).flow_mps;
        simulation_.physics.apply_impulse(body,
                                          against * static_cast<Real>((kept - 1) * own.mass_kg));
        own.reckoned_kg = own.added_kg;
    }

    void push(std::span<BodyInField* const> bodies, const physics::FieldTime& time) override {
        for (BodyInField* body : bodies) push_one(*body, own_of(body->id), time.h_s);
    }

    /// Lift is across the surface.
    void push_one(BodyInField& body, const Afloat& own, double h) const {
        const scene::WaterDescription& water = water_of(own);
        const Vec3d against = body.velocity_mps - Vec3d(water.flow_mps);
        // Before weight and lift, which cancel, have given their halves.
        const Vec3d direction = normalize_or(against - 0.5 * body.gain_mps, kUp);
        const Submersion below =
            below_of(own, body.id, body.center_m, body.world_from_mass, direction);
        if (!(below.volume_m3 > 0)) return;
        const double lift_Ns = weight_Npm3(own) * below.volume_m3 * h;
        // The waterline makes a spring of it: what it and all else leave over is eased.
        const double share = stiff_share(weight_Npm3(own) * below.waterline_m2, body.mass_kg, h);
        const double left_Ns = lift_Ns + body.gain_mps.y * body.mass_kg;
        const double upwards_Ns = lift_Ns + (share - 1) * left_Ns;
        body.push({-own.slope.x * lift_Ns, upwards_Ns, -own.slope.y * lift_Ns}, below.center_m);
        if (water.drag > 0) resist(body, own, below, against, h);
    }

    /// Against the velocity in the middle, which has half of the lift by now: solved over the whole sub-step.
    void resist(BodyInField& body,
                const Afloat& own,
                const Submersion& below,
                const Vec3d& against_before,
                double h) const {
        const auto drag = static_cast<double>(water_of(own).drag);
        const double half_rho = 0.5 * density_of(own) * own.coefficient * drag;
        const Vec3d against = against_before + body.impulse_Ns / (2 * body.mass_kg);
        const double k = half_rho * below.silhouette_m2 / body.mass_kg;
        const double lost = 1 - 1 / (1 + k * glm::length(against) * h);
        body.impulse_Ns -= against * (lost * body.mass_kg);
        const double weight = weight_Npm3(own) * below.waterline_m2;
        const bool radiates = waves_of(own) == nullptr;  // waves take it with them
        const double ringing = radiates ? 2 * physics::kRadiated * std::min(drag, 1.0) : 0;
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
    Submersion below_of(const Afloat& own,
                        BodyId body,
                        const Vec3d& center,
                        const Quatd& orientation,
                        const Vec3d& direction) const {
        const physics::PhysicsWorld& world = simulation_.physics;
        Submersion below =
            physics::submersion(world, body, {center, orientation}, level_m(own), direction);
        const double ground_m = place_of(own).min_m.y;
        if (below.volume_m3 <= 0 || center.y - own.radius_m > ground_m) return below;
        const Submersion under =
            physics::submersion(world, body, {center, orientation}, ground_m, direction);
        const double volume_m3 = below.volume_m3 - under.volume_m3;
        if (volume_m3 > 0 && under.volume_m3 > 0)
            below.center_m =
                (below.center_m * below.volume_m3 - under.center_m * under.volume_m3) / volume_m3;
        below.volume_m3 = std::max(volume_m3, 0.0);
        return below;
    }

    /// Which water a body is in at a place, and where its surface is there.
    void find_water(Afloat& own, const Vec3d& center) const {
        own.water = -1;
        own.rise_m = 0;
        own.slope = {0, 0};
        const std::vector<scene::SceneWater>& waters = simulation_.waters;
        for (std::size_t i = 0; i < waters.size(); ++i) {
            if (center.y + own.radius_m < waters[i].min_m.y) continue;
            if (!waters[i].spans(center.x, center.z)) continue;
            Afloat there = own;
            there.water = static_cast<int>(i);
            if (const scene::WaveField* waves = waves_of(there)) {
                there.rise_m = scene::felt_rise_m(waters[i], own, center);
                there.slope = waves->slope(center.x, center.z, scene::kFeltOfRadius * own.radius_m);
            }
            if (center.y - own.radius_m > waters[i].max_m.y + there.rise_m) continue;
            own = there;
            return;
        }
    }

    static scene::Displaced at(const scene::Displaced& own, const Vec3d& place, double volume_m3) {
        scene::Displaced there = own;
        there.place_m = place;
        there.volume_m3 = volume_m3;
        return there;
    }
    void displace(Afloat& own, const scene::Displaced& now) const {
        scene::displace(simulation_.waters, own, now);
    }

    const scene::WaterDescription& water_of(const Afloat& own) const {
        return simulation_.description().forces.waters[static_cast<std::size_t>(own.water)];
    }
    const scene::SceneWater& place_of(const Afloat& own) const {
        return simulation_.waters[static_cast<std::size_t>(own.water)];
    }
    scene::WaveField* waves_of(const Afloat& own) const {
        return own.water >= 0 ? place_of(own).waves.get() : nullptr;
    }
    bool has_waves() const {
        return std::ranges::any_of(simulation_.waters, [](const scene::SceneWater& water) {
            return water.waves != nullptr;
        });
    }
    double level_m(const Afloat& own) const { return place_of(own).max_m.y + own.rise_m; }
    double density_of(const Afloat& own) const {
        return static_cast<double>(water_of(own).density_kgpm3);
    }
    double weight_Npm3(const Afloat& own) const {
        return density_of(own) *
               std::max(-static_cast<double>(simulation_.physics.def().gravity_mps2.y), 0.0);
    }
    const Afloat& own_of(BodyId body) const { return receivers_.find(body)->own; }
};

Callers callers_of_buoyancy(const scene::Simulation& simulation) {
    return tables_of(simulation, "buoyancy", "water", simulation.description().forces.waters);
}

}  // namespace

EffectRow buoyancy() {
    return with_effect<Buoyancy>({.called_for_by = &callers_of_buoyancy});
}

}  // namespace plumbline::effects
