#include "engine/effects/physics/deformable_effect.h"

#include "engine/effects/fields/air.h"
#include "engine/effects/fields/field_effect.h"
#include "engine/scene/environment/wave_field.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::effects {
namespace {

constexpr std::string_view kField = "deformables";
/// Of the stiffness asked for; less is said.
constexpr double kStiffEnough = 0.95;

/// Null: in none.
const scene::SceneWater* water_at(const scene::Simulation& simulation, const Vec3d& place) {
    for (const scene::SceneWater& water : simulation.waters) {
        if (place.y >= water.min_m.y && water.spans(place.x, place.z)) return &water;
    }
    return nullptr;
}

int number_of(const scene::Simulation& simulation, const scene::SceneWater& water) {
    return static_cast<int>(&water - simulation.waters.data());
}

/// Sets what is known of a point's water. `rise_m`: of its surface there.
void describe_water(const scene::Simulation& simulation,
                    const scene::SceneWater& water,
                    double rise_m,
                    physics::FluidAtPoint& fluid) {
    const auto number = static_cast<std::size_t>(number_of(simulation, water));
    const scene::WaterDescription& said = simulation.description().forces.waters[number];
    const auto gravity_mps2 = -static_cast<double>(simulation.physics.def().gravity_mps2.y);
    fluid.has_waves = water.waves != nullptr;
    fluid.level_m = water.max_m.y + rise_m;
    fluid.flow_mps = Vec3d(said.flow_mps);
    fluid.density_kgpm3 = static_cast<double>(said.density_kgpm3);
    fluid.weight_Npm3 = fluid.density_kgpm3 * std::max(gravity_mps2, 0.0);
    fluid.drag = static_cast<double>(said.drag);
}

}  // namespace

DeformableEffect::DeformableEffect(scene::Simulation& simulation,
                                   std::string_view name,
                                   List list,
                                   scene::Fidelity fidelity)
    : simulation_(simulation), name_(name), list_(list), fidelity_(fidelity) {
    simulation.force_fields.add(kField, simulation.deformables);
    set_fluids();
}

DeformableEffect::~DeformableEffect() {
    simulation_.force_fields.remove(kField);
    for (const scene::SceneDeformable& each : all()) {
        for (const physics::BodyId body : each.body->movable()) {
            if (simulation_.physics.contains(body)) simulation_.physics.wake(body);
        }
    }
}

void DeformableEffect::set_fluids() {
    const Air air(simulation_);
    const bool has_water =
        !simulation_.waters.empty() && simulation_.switches.is_on("buoyancy", true);
    const bool is_stirred = std::ranges::any_of(simulation_.waters, [](const scene::SceneWater& w) {
        return w.waves && !w.waves->is_asleep();
    });
    for (scene::SceneDeformable& each : all()) {
        const bool blows = air.blows() && each.body->body().feels_air();
        if (each.body->is_asleep() && !blows && !is_stirred) continue;
        set_fluids(each, blows ? &air : nullptr, has_water);
        if (is_stirred && !each.body->fluids().empty()) each.body->stir();
    }
}

/// `air`: null where it stands still.
void DeformableEffect::set_fluids(scene::SceneDeformable& each, const Air* air, bool has_water) {
    const auto points_m = each.body->body().positions_m();
    std::vector<physics::FluidAtPoint>& fluids = each.body->fluids();
    fluids.clear();
    if (air != nullptr) {
        fluids.resize(points_m.size());
        for (std::size_t i = 0; i < points_m.size(); ++i)
            fluids[i].air_mps = air->at(points_m[i], simulation_.time_s());
    }
    const scene::SceneWater* latest = nullptr;
    double own_m = 0;
    for (std::size_t i = 0; has_water && i < points_m.size(); ++i) {
        const scene::SceneWater* water = water_at(simulation_, points_m[i]);
        if (water == nullptr) continue;
        fluids.resize(points_m.size());
        if (water != latest) own_m = scene::own_rise_m(*water, each.displaced);
        latest = water;
        const double rise_m = felt_rise_m(*water, each.displaced, points_m[i], own_m);
        describe_water(simulation_, *water, rise_m, fluids[i]);
    }
}

void DeformableEffect::before_step(scene::Simulation& simulation) {
    set_fluids();
    for (scene::SceneDeformable& each : all()) {
        if (!each.body->is_asleep())
            std::ranges::copy(each.body->body().positions_m(), each.before_m.begin());
        simulation.deformables.enter(*each.body, field_substeps(fidelity_));
    }
}

/// The waves know of it before they go on.
void DeformableEffect::displace_water(scene::SceneDeformable& each) {
    const physics::PointBody& body = each.body->body();
    const auto is_water = [](const physics::FluidAtPoint& fluid) {
        return fluid.density_kgpm3 > 0;
    };
    const bool is_in_water = std::ranges::any_of(each.body->fluids(), is_water);
    if (!is_in_water && each.displaced.volume_m3 == 0) return;
    const physics::PointTotals totals = body.totals();
    scene::Displaced now{.volume_m3 = totals.displaced_m3,
                         .place_m = totals.moment_kgm / body.mass_kg()};
    for (const Vec3d& at : body.positions_m())
        now.radius_m = std::max(now.radius_m, glm::distance(at, now.place_m));
    if (const scene::SceneWater* water = water_at(simulation_, now.place_m))
        now.water = number_of(simulation_, *water);
    scene::displace(simulation_.waters, each.displaced, now);
}

void DeformableEffect::after_step(scene::Simulation& simulation, const scene::Game&) {
    for (scene::SceneDeformable& each : all()) {
        if (!each.body->is_asleep()) displace_water(each);
        work_.cpu_ms += simulation.deformables.cpu_ms(*each.body);
        work_.calls += each.body->substeps();
    }
    warn_of_softness();
}

void DeformableEffect::warn_of_softness() {
    for (const scene::SceneDeformable& each : all()) {
        const double share = each.body->body().stiffness_share();
        if (share >= kStiffEnough || !said_.insert(each.entity).second) continue;
        simulation_.warnings.push_back(
            fmt::format("{} {}: the sub-steps allowed bear {:.0f} % of its stiffness: it is "
                        "softer; make it of larger cells, or set "
                        "[effects.{}] fidelity = \"precise\"",
                        name_,
                        each.name,
                        share * 100,
                        name_));
    }
}

void DeformableEffect::extract(const scene::Simulation& simulation,
                               const scene::ViewPoint& view,
                               render::RenderFrame&) {
    for (const scene::SceneDeformable& each : all()) {
        const bool rests = each.body->is_asleep();
        Drawn& drawn = drawn_[each.entity];
        const bool is_shown = drawn.step == simulation.steps() && drawn.blend == view.blend;
        if (is_shown || (rests && drawn.rests)) continue;
        drawn = {.step = simulation.steps(), .blend = view.blend, .rests = rests};
        draw(each, static_cast<double>(view.blend));
    }
}

void DeformableEffect::draw(const scene::SceneDeformable& each, double blend) {
    const auto* visual = simulation_.registry.find<scene::Visual>(each.entity);
    if (visual == nullptr) return;
    const auto now_m = each.body->body().positions_m();
    std::vector<Vec3d> points_m(now_m.begin(), now_m.end());
    if (!each.body->is_asleep()) {
        for (std::size_t i = 0; i < points_m.size(); ++i)
            points_m[i] = glm::mix(each.before_m[i], points_m[i], blend);
    }
    each.shape_mesh(points_m, simulation_.library().change_mesh(visual->mesh));
}

}  // namespace plumbline::effects
