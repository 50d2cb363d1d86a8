// Bodies of the physics as motions and colliders of glTF.
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/gltf_scene/gltf_export_impl.h"

#include <cmath>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;
using physics::BodyCopy;
using physics::CombineRule;

constexpr Real kSamePlace_m = 1e-6_r;

/// The number of an entry that is the same, or of a new one.
std::size_t place_in(Json& list, Json entry) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] == entry) return i;
    }
    list.push_back(std::move(entry));
    return list.size() - 1;
}

struct GeometryWriter {
    GltfOutput& out;

    Json implicit(const char* type, Json fields) const {
        out.writer.use(kGltfShapes);
        Json& shapes = out.writer.json["extensions"][kGltfShapes]["shapes"];
        return {{"shape", place_in(shapes, {{"type", type}, {type, std::move(fields)}})}};
    }
    Json round(const char* type, Real height_m, Real bottom_m, Real top_m) const {
        return implicit(type,
                        {{"height", height_m}, {"radiusBottom", bottom_m}, {"radiusTop", top_m}});
    }
    Json triangles(const std::vector<Vec3>& points,
                   const std::vector<std::array<std::uint32_t, 3>>& corners,
                   bool hull) const {
        std::vector<Vec3f> positions;
        positions.reserve(points.size());
        for (const Vec3& point : points) positions.emplace_back(point);
        const std::size_t mesh = out.writer.add_triangles(positions, corners);
        Json geometry{{"node", out.writer.add_node({{"mesh", mesh}}, false)}};
        if (hull) geometry["convexHull"] = true;
        return geometry;
    }

    Json operator()(const physics::BoxShape& it) const {
        return implicit("box", {{"size", gltf_numbers(it.size_m)}});
    }
    Json operator()(const physics::SphereShape& it) const {
        return implicit("sphere", {{"radius", it.radius_m}});
    }
    Json operator()(const physics::CylinderShape& it) const {
        return round("cylinder", it.height_m, it.radius_m, it.radius_m);
    }
    Json operator()(const physics::CapsuleShape& it) const {
        return round("capsule", it.height_m, it.radius_m, it.radius_m);
    }
    Json operator()(const physics::ConeShape& it) const {
        return round("cylinder", it.height_m, it.radius_m, Real{0});
    }
    Json operator()(const physics::HullShape& it) const {
        return triangles(it.points_m, hull_triangles(it.points_m), true);
    }
    Json operator()(const physics::MeshShape& it) const {
        return triangles(it.vertices_m, it.triangles, false);
    }
    // A copy has neither: planes are boxes, compounds are parts.
    Json operator()(const physics::PlaneShape&) const { return {}; }
    Json operator()(const physics::CompoundShape&) const { return {}; }
};

const char* name_of(CombineRule rule, const char* usual) {
    switch (rule) {
        case CombineRule::Average:
            return "average";
        case CombineRule::Minimum:
            return "minimum";
        case CombineRule::Maximum:
            return "maximum";
        case CombineRule::Multiply:
            return "multiply";
        case CombineRule::Usual:
            break;
    }
    return usual;
}

/// What other programs read of the usual rules: the geometric mean is a product of roots. Ours reads the extras.
std::size_t number_of(GltfOutput& out, const physics::Material& of) {
    const bool usual = of.friction_rule == CombineRule::Usual;
    const Real friction = usual ? std::sqrt(of.friction) : of.friction;
    Json own{{"friction", of.friction},
             {"restitution", of.restitution},
             {"friction_combine", name_of(of.friction_rule, "usual")},
             {"restitution_combine", name_of(of.restitution_rule, "usual")}};
    return place_in(out.physics()["physicsMaterials"],
                    {{"staticFriction", friction},
                     {"dynamicFriction", friction},
                     {"restitution", of.restitution},
                     {"frictionCombine", name_of(of.friction_rule, "multiply")},
                     {"restitutionCombine", name_of(of.restitution_rule, "maximum")},
                     {"extras", {{"plumbline", std::move(own)}}}});
}

/// Nothing for a body that touches everything and that everything touches.
std::optional<std::size_t> filter_of(GltfOutput& out, const physics::CollisionFilter& filter) {
    const auto& groups = out.simulation.builder().groups().bits();
    Json member_of = Json::array();
    Json with = Json::array();
    Json without = Json::array();
    for (const auto& [name, bit] : groups) {
        if ((filter.group & bit) != 0) member_of.push_back(name);
        ((filter.collides_with & bit) != 0 ? with : without).push_back(name);
    }
    if (groups.size() == 1 && without.empty()) return {};
    Json entry{{"collisionSystems", std::move(member_of)}};
    if (with.size() < without.size()) {
        entry["collideWithSystems"] = std::move(with);
    } else if (!without.empty()) {
        entry["notCollideWithSystems"] = std::move(without);
    }
    return place_in(out.physics()["collisionFilters"], std::move(entry));
}

Json motion_of(const BodyCopy& body, const physics::BodyState& state) {
    const Quat node_from_world = glm::conjugate(state.world_from_body.orientation);
    const bool held = body.linear_factor == Vec3{0, 0, 0};
    Json motion{{"mass", held ? 0.0 : body.mass_kg}};
    if (body.kind == physics::BodyKind::Kinematic) motion = {{"isKinematic", true}};
    if (body.kind == physics::BodyKind::Dynamic) {
        const Pose node_from_mass = compose(invert(state.world_from_body), body.world_from_mass);
        motion["inertiaDiagonal"] = gltf_numbers(Vec3(body.inertia_kgm2));
        if (std::abs(node_from_mass.orientation.w) < Real{1})
            motion["inertiaOrientation"] = gltf_numbers(node_from_mass.orientation);
        if (state.mass.center_of_mass_m != Vec3{0, 0, 0})
            motion["centerOfMass"] = gltf_numbers(state.mass.center_of_mass_m);
    }
    if (state.velocity_mps != Vec3{0, 0, 0})
        motion["linearVelocity"] = gltf_numbers(node_from_world * state.velocity_mps);
    if (state.angular_velocity_radps != Vec3{0, 0, 0})
        motion["angularVelocity"] = gltf_numbers(node_from_world * state.angular_velocity_radps);
    const Real factor = body.gravity_factor.y;
    if (body.kind == physics::BodyKind::Dynamic && !held && factor != Real{1} &&
        body.linear_factor.y != Real{0})
        motion["gravityFactor"] = factor;
    return motion;
}

/// For our reader alone.
Json traits_of(const BodyCopy& body) {
    Json traits = Json::object();
    const auto put = [&traits](const char* key, double value) {
        if (value != 0.0) traits[key] = value;
    };
    put("rolling_friction", static_cast<double>(body.rolling_friction_m));
    put("spinning_friction", static_cast<double>(body.spinning_friction_m));
    put("linear_damping_per_s", body.linear_damping_per_s);
    put("angular_damping_per_s", body.angular_damping_per_s);
    if (!body.can_sleep) traits["can_sleep"] = false;
    if (body.always_ccd) traits["ccd"] = "on";
    const Vec3& factor = body.linear_factor;
    if (factor != Vec3{1, 1, 1} && factor != Vec3{0, 0, 0})
        traits["linear_factor"] = gltf_numbers(factor);
    return traits;
}

}  // namespace

Json geometry_of(GltfOutput& out, const physics::ShapeDef& shape) {
    return std::visit(GeometryWriter{out}, shape);
}

void write_body(GltfOutput& out, const BodyCopy& body, std::size_t number) {
    out.writer.use(kGltfBodies);
    const physics::BodyState state = out.simulation.physics.state(body.id);
    if (body.kind != physics::BodyKind::Static)
        out.node(number)["extensions"][kGltfBodies]["motion"] = motion_of(body, state);
    if (Json traits = traits_of(body); !traits.empty())
        out.node(number)["extras"]["plumbline"]["body"] = std::move(traits);
    if (body.is_belt) out.note("surfaces that move along themselves stand still");
    const physics::PartTraits whole{.material = {.friction = body.friction,
                                                 .restitution = body.restitution,
                                                 .friction_rule = body.friction_rule,
                                                 .restitution_rule = body.restitution_rule},
                                    .filter = body.filter};
    const Pose node_from_mass = compose(invert(state.world_from_body), body.world_from_mass);
    for (std::size_t i = 0; i < body.parts.size(); ++i) {
        const physics::CompoundChild& part = body.parts[i];
        const physics::PartTraits& traits =
            body.part_traits.empty() ? whole : body.part_traits.at(i);
        Json collider{{"geometry", geometry_of(out, part.shape)},
                      {"physicsMaterial", number_of(out, traits.material)}};
        if (const auto filter = filter_of(out, traits.filter))
            collider["collisionFilter"] = *filter;
        const Pose at = compose(node_from_mass, part.body_from_child);
        const bool is_here = glm::length(at.position) < kSamePlace_m &&
                             std::abs(at.orientation.w) > Real{1} - kSamePlace_m * kSamePlace_m;
        if (is_here && body.parts.size() == 1) {
            out.node(number)["extensions"][kGltfBodies]["collider"] = std::move(collider);
            continue;
        }
        Json child{{"extensions", {{kGltfBodies, {{"collider", std::move(collider)}}}}}};
        put_pose(child, at);
        out.add_child(number, std::move(child));
    }
}

}  // namespace plumbline::scene
