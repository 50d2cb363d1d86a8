#include "engine/study/engines/neutral_scene.h"

#include "engine/physics/medium.h"
#include "engine/physics/world_copy.h"
#include "engine/study/findings/json_fields_impl.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace plumbline::study {
namespace {

using physics::BodyCopy;
using physics::JointDef;
using physics::JointKind;

constexpr std::array<std::string_view, 11> kNotHanded{"explosion",
                                                      "drag",
                                                      "buoyancy",
                                                      "water",
                                                      "magnets",
                                                      "conveyor",
                                                      "rope",
                                                      "cloth",
                                                      "soft",
                                                      "vehicles",
                                                      "fracture"};

Json numbers(const Vec3& v) {
    return {v.x, v.y, v.z};
}
Json numbers(const Quat& q) {
    return {q.x, q.y, q.z, q.w};
}

struct ShapeWriter {
    Json& json;

    void operator()(const physics::BoxShape& box) const {
        json["shape"] = "box";
        json["half_m"] = numbers(box.size_m * 0.5_r);
    }
    void operator()(const physics::SphereShape& sphere) const {
        json["shape"] = "sphere";
        json["radius_m"] = sphere.radius_m;
    }
    void operator()(const physics::CylinderShape& it) const {
        round("cylinder", it.radius_m, it.height_m);
    }
    void operator()(const physics::CapsuleShape& it) const {
        round("capsule", it.radius_m, it.height_m);
    }
    void operator()(const physics::ConeShape& it) const { round("cone", it.radius_m, it.height_m); }
    void operator()(const physics::HullShape& hull) const {
        json["shape"] = "hull";
        for (const Vec3& point : hull.points_m) json["points_m"].push_back(numbers(point));
    }
    void operator()(const physics::MeshShape& mesh) const {
        json["shape"] = "mesh";
        for (const Vec3& point : mesh.vertices_m) json["points_m"].push_back(numbers(point));
        json["triangles"] = mesh.triangles;
    }
    // A copy has neither: planes are boxes, compounds are parts.
    void operator()(const physics::PlaneShape&) const {}
    void operator()(const physics::CompoundShape&) const {}

private:
    void round(const char* name, Real radius_m, Real height_m) const {
        json["shape"] = name;
        json["radius_m"] = radius_m;
        json["half_height_m"] = height_m * 0.5_r;
    }
};

Json json_of(const physics::CompoundChild& part) {
    Json json;
    std::visit(ShapeWriter{json}, part.shape);
    json["at_m"] = numbers(part.body_from_child.position);
    json["turn"] = numbers(part.body_from_child.orientation);
    return json;
}

std::string_view kind_of(physics::BodyKind kind) {
    switch (kind) {
        case physics::BodyKind::Dynamic:
            return "dynamic";
        case physics::BodyKind::Kinematic:
            return "kinematic";
        case physics::BodyKind::Static:
            break;
    }
    return "static";
}

Json json_of(const BodyCopy& body) {
    Json json;
    json["kind"] = kind_of(body.kind);
    for (const physics::CompoundChild& part : body.parts) json["parts"].push_back(json_of(part));
    json["at_m"] = numbers(body.world_from_mass.position);
    json["turn"] = numbers(body.world_from_mass.orientation);
    json["mass_kg"] = body.mass_kg;
    json["inertia_kgm2"] = numbers(Vec3(body.inertia_kgm2));
    json["friction"] = body.friction;
    json["restitution"] = body.restitution;
    json["rolling_friction_m"] = body.rolling_friction_m;
    json["spinning_friction_m"] = body.spinning_friction_m;
    json["linear_damping_per_s"] = body.linear_damping_per_s;
    json["angular_damping_per_s"] = body.angular_damping_per_s;
    json["linear_factor"] = numbers(body.linear_factor);
    json["continuous"] = body.always_ccd;
    json["group"] = body.filter.group;
    json["collides_with"] = body.filter.collides_with;
    return json;
}

std::string_view kind_of(JointKind kind) {
    switch (kind) {
        case JointKind::BallAndSocket:
            return "ball";
        case JointKind::Hinge:
            return "hinge";
        case JointKind::Slider:
            return "slider";
        case JointKind::Fixed:
            return "fixed";
        case JointKind::Cone:
            return "cone";
        case JointKind::Distance:
            return "distance";
        case JointKind::Spring:
            return "spring";
        case JointKind::Elastic:
            break;
    }
    return "elastic";
}

Json json_of(const JointDef& joint, const std::map<physics::BodyId, int>& places) {
    Json json;
    json["kind"] = kind_of(joint.kind);
    json["a"] = places.at(joint.a);
    json["b"] = joint.b ? places.at(joint.b) : -1;
    json["anchor_a_m"] = numbers(joint.anchor_a_world);
    json["anchor_b_m"] = numbers(joint.anchor_b_world);
    json["axis"] = numbers(glm::normalize(joint.axis_world));
    if (joint.limits) json["limits"] = *joint.limits;
    if (joint.twist_limits) json["twist_limits"] = *joint.twist_limits;
    if (joint.motor) json["motor"] = {{"target", joint.motor->target}, {"max", joint.motor->max}};
    if (joint.kind == JointKind::Spring) {
        json["stiffness_Npm"] = joint.stiffness_Npm;
        json["damping_Nspm"] = joint.damping_Nspm;
    }
    json["rest_length_m"] =
        joint.rest_length_m.value_or(glm::distance(joint.anchor_a_world, joint.anchor_b_world));
    json["collide"] = joint.collide;
    json["breaks"] = joint.break_N > 0;
    return json;
}

/// Whether it is led by the scene: an engine is told of dynamic bodies only.
bool is_led(const scene::Simulation& simulation, const scene::MovingBody& moving) {
    if (simulation.registry.find<scene::MotionPath>(moving.entity) != nullptr) return true;
    const physics::BodyState state = simulation.physics.state(moving.body);
    return moving.kind == physics::BodyKind::Kinematic &&
           (state.velocity_mps != Vec3{0, 0, 0} || state.angular_velocity_radps != Vec3{0, 0, 0});
}

/// Whether it shows in poses and velocities of dynamic bodies, or in gravity.
bool is_handed(const scene::Simulation& simulation, const scene::HardCaseEvent& event) {
    using enum scene::CaseEventKind;
    if (event.kind == Gravity) return true;
    if (event.kind != Teleport && event.kind != Velocity && event.kind != Impulse) return false;
    const std::span<const scene::MovingBody> bodies = simulation.moving_bodies();
    const auto body =
        std::ranges::find(bodies, simulation.find(event.of), &scene::MovingBody::entity);
    return body != bodies.end() && body->kind == physics::BodyKind::Dynamic;
}

}  // namespace

std::vector<std::string> not_handed(const PlayedScene& scene) {
    std::vector<std::string> names;
    for (const effects::LedgerLine& line : scene.effects().ledger()) {
        if (line.constructions > 0 && std::ranges::find(kNotHanded, line.name) != kNotHanded.end())
            names.emplace_back(line.name);
    }
    const scene::Simulation& simulation = scene.simulation();
    if (const auto& hard_case = simulation.description().hard_case) {
        for (const scene::HardCaseEvent& event : hard_case->events) {
            if (is_handed(simulation, event)) continue;
            names.emplace_back("what happens on the way");
            break;
        }
    }
    const physics::WorldCopy copy = physics::copy_of(simulation.physics);
    const bool parts_differ = std::ranges::any_of(
        copy.bodies, [](const BodyCopy& body) { return !body.part_traits.empty(); });
    if (parts_differ) names.emplace_back("parts of one body that differ in friction or groups");
    const bool gives_way = std::ranges::any_of(copy.joints, [](const JointDef& joint) {
        return joint.motor && (joint.motor->stiffness > 0 || joint.motor->damping > 0);
    });
    if (gives_way) names.emplace_back("a motor that is a spring");
    for (const BodyCopy& body : copy.bodies) {
        const bool pulled = body.gravity_factor != body.linear_factor;
        const bool ruled = body.friction_rule != physics::CombineRule::Usual ||
                           body.restitution_rule != physics::CombineRule::Usual;
        if (!pulled && !ruled) continue;
        names.emplace_back(pulled ? "a gravity factor"
                                  : "a rule that combines friction or restitution");
        break;
    }
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (!is_led(simulation, moving)) continue;
        names.emplace_back("a body that is led");
        break;
    }
    return names;
}

NeutralScene neutral_scene(const scene::Simulation& simulation,
                           std::span<const physics::BodyId> moving,
                           const EngineSetting& setting) {
    NeutralScene scene;
    Json json;
    const physics::WorldCopy copy = physics::copy_of(simulation.physics);
    json["gravity_mps2"] = numbers(simulation.physics.def().gravity_mps2);
    std::map<physics::BodyId, int> places;
    for (const BodyCopy& body : copy.bodies) {
        places[body.id] = static_cast<int>(places.size());
        json["bodies"].push_back(json_of(body));
    }
    json["joints"] = Json::array();
    for (const JointDef& joint : copy.joints) json["joints"].push_back(json_of(joint, places));
    for (const physics::BodyId body : moving)
        scene.places.push_back(static_cast<std::size_t>(places.at(body)));
    json["moving"] = scene.places;
    json["step_hz"] = setting.step_hz;
    for (const EngineKnob& knob : setting.knobs) json["knobs"][knob.name] = knob.value;
    scene.text = text_of(Json{{"scene", std::move(json)}});
    return scene;
}

std::vector<double> states_of(const physics::PhysicsWorld& world,
                              std::span<const physics::BodyId> bodies) {
    std::vector<double> numbers;
    const auto add = [&numbers](const Vec3& v) {
        for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<double>(v[i]));
    };
    for (const physics::BodyId id : bodies) {
        if (!world.contains(id)) {
            numbers.resize(numbers.size() + kNumbersOfBody);
            continue;
        }
        const physics::BodyState state = world.state(id);
        const Vec3 center = state.center_of_mass_world();
        const Quatd turn = physics::world_from_mass(world, id);
        add(center);
        numbers.insert(numbers.end(), {turn.x, turn.y, turn.z, turn.w});
        add(state.velocity_mps +
            glm::cross(state.angular_velocity_radps, center - state.world_from_body.position));
        add(state.angular_velocity_radps);
    }
    return numbers;
}

void set_states(physics::PhysicsWorld& world,
                std::span<const physics::BodyId> bodies,
                std::span<const double> numbers) {
    const auto vector_at = [&numbers](std::size_t first) {
        return Vec3(Vec3d{numbers[first], numbers[first + 1], numbers[first + 2]});
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!world.contains(bodies[i])) continue;
        const std::size_t at = i * kNumbersOfBody;
        const Quatd turn = glm::normalize(
            Quatd{numbers[at + 6], numbers[at + 3], numbers[at + 4], numbers[at + 5]});
        const Quat orientation(glm::normalize(turn * physics::mass_from_body(world, bodies[i])));
        const Vec3 to_center =
            orientation * world.state(bodies[i]).mass.center_of_mass_m;  // from the origin
        const Vec3 spin_radps = vector_at(at + 10);
        world.set_pose(bodies[i], {vector_at(at) - to_center, orientation});
        world.set_velocity(
            bodies[i], vector_at(at + 7) - glm::cross(spin_radps, to_center), spin_radps);
    }
}

}  // namespace plumbline::study
