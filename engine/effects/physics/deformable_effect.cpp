#include "engine/effects/physics/deformable_effect.h"

#include "engine/effects/fields/air.h"
#include "engine/effects/fields/field_effect.h"
#include "engine/scene/environment/wave_field.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::effects {
namespace {

/// Of the stiffness asked for; less is said.
constexpr double kStiffEnough = 0.95;

/// Null: in none.
const scene::SceneWater* water_at(const scene::Simulation& simulation, const Vec3d& place) {
    for (const scene::SceneWater& water : simulation.waters) {
        const bool is_within = place.x >= water.min_m.x && place.x <= water.max_m.x &&
                               place.z >= water.min_m.z && place.z <= water.max_m.z &&
                               place.y >= water.min_m.y;
        if (is_within && (!water.basin || water.basin->holds(place.x, place.z))) return &water;
    }
    return nullptr;
}

/// Sets what is known of a point's water.
void describe_water(const scene::Simulation& simulation,
                    const scene::SceneWater& water,
                    const Vec3d& place,
                    physics::FluidAtPoint& fluid) {
    const auto number = static_cast<std::size_t>(&water - simulation.waters.data());
    const scene::WaterDescription& said = simulation.description().forces.waters[number];
    const auto gravity_mps2 = -static_cast<double>(simulation.physics.def().gravity_mps2.y);
    fluid.level_m = water.max_m.y + (water.waves ? water.waves->height_m(place.x, place.z) : 0);
    fluid.flow_mps = Vec3d(said.flow_mps);
    fluid.density_kgpm3 = static_cast<double>(said.density_kgpm3);
    fluid.weight_Npm3 = fluid.density_kgpm3 * std::max(gravity_mps2, 0.0);
    fluid.drag = static_cast<double>(said.drag);
}

}  // namespace

using physics::BodyId;

DeformableEffect::DeformableEffect(scene::Simulation& simulation,
                                   std::string_view name,
                                   List list,
                                   scene::Fidelity fidelity)
    : simulation_(simulation), name_(name), list_(list), fidelity_(fidelity) {
    simulation.force_fields.add(name_, *this);
    set_fluids();
}

DeformableEffect::~DeformableEffect() {
    simulation_.force_fields.remove(name_);
    for (const BodyId body : pushed_) {
        if (simulation_.physics.contains(body)) simulation_.physics.wake(body);
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
        set_fluids(*each.body, blows ? &air : nullptr, has_water);
        if (is_stirred && !each.body->fluids().empty()) each.body->stir();
    }
}

/// `air`: null where it stands still.
void DeformableEffect::set_fluids(physics::Deformable& body, const Air* air, bool has_water) {
    const auto points_m = body.body().positions_m();
    std::vector<physics::FluidAtPoint>& fluids = body.fluids();
    fluids.clear();
    if (air != nullptr) {
        fluids.resize(points_m.size());
        for (std::size_t i = 0; i < points_m.size(); ++i)
            fluids[i].air_mps = air->at(points_m[i], simulation_.time_s());
    }
    for (std::size_t i = 0; has_water && i < points_m.size(); ++i) {
        const scene::SceneWater* water = water_at(simulation_, points_m[i]);
        if (water == nullptr) continue;
        fluids.resize(points_m.size());
        describe_water(simulation_, *water, points_m[i], fluids[i]);
    }
}

void DeformableEffect::before_step(scene::Simulation& simulation) {
    set_fluids();
    pushed_.clear();
    for (scene::SceneDeformable& each : all()) {
        if (!each.body->is_asleep())
            std::ranges::copy(each.body->body().positions_m(), each.before_m.begin());
        each.body->begin_step(simulation.physics, simulation.step_s());
        const auto movable = each.body->movable();
        pushed_.insert(pushed_.end(), movable.begin(), movable.end());
    }
    std::ranges::sort(pushed_);
}

bool DeformableEffect::acts_on(BodyId body) const {
    return std::ranges::binary_search(pushed_, body);
}

double DeformableEffect::added_mass_kg(BodyId body) const {
    double sum = 0;
    for (const scene::SceneDeformable& each : all()) sum += each.body->pinned_kg(body);
    return sum;
}

int DeformableEffect::substeps() const {
    return field_substeps(fidelity_);
}

void DeformableEffect::list_pairs(std::vector<Pair>& pairs) const {
    for (const scene::SceneDeformable& each : all()) {
        const auto movable = each.body->movable();
        for (std::size_t i = 1; i < movable.size(); ++i) pairs.emplace_back(movable[0], movable[i]);
    }
}

void DeformableEffect::act(std::span<physics::BodyInField* const> bodies,
                           const physics::FieldTime& time) {
    lap_.start();
    for (scene::SceneDeformable& each : all()) {
        const auto movable = each.body->movable();
        const bool is_here =
            !movable.empty() &&
            std::ranges::find(bodies, movable[0], &physics::BodyInField::id) != bodies.end();
        if (is_here) each.body->act(simulation_.physics, bodies, time.h_s);
    }
    work_.cpu_ms += lap_.lap_ms();
}

void DeformableEffect::after_step(scene::Simulation& simulation, const scene::Game&) {
    for (scene::SceneDeformable& each : all()) {
        each.body->end_step(simulation.physics);
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
