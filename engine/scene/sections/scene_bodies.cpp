// [entity.body]
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"

#include <array>
#include <string_view>

namespace plumbline::scene {
namespace {

using physics::BodyKind;

constexpr Range kMass_kg{limits::kMassMin_kg, limits::kMassMax_kg, "kg from 0.001 to 10000000"};
constexpr Range kFriction{0, 1000, "a coefficient from 0 to 1000"};
constexpr Range kDamping{0, 1000, "a rate from 0 to 1000 per s"};
constexpr Range kSpin_radps{-1e4, 1e4, "rad/s from -10000 to 10000"};

bool is_mesh(const BodyShapeDescription& shape) {
    if (std::holds_alternative<ModelMeshShape>(shape)) return true;
    const auto* own = std::get_if<physics::ShapeDef>(&shape);
    return own != nullptr && std::holds_alternative<physics::MeshShape>(*own);
}

bool is_plane(const BodyShapeDescription& shape, const VisualDescription& visual) {
    if (const auto* own = std::get_if<physics::ShapeDef>(&shape))
        return std::holds_alternative<physics::PlaneShape>(*own);
    const auto* primitive = std::get_if<Primitive>(&visual);
    return std::holds_alternative<FitShape>(shape) && primitive != nullptr &&
           std::holds_alternative<physics::PlaneShape>(*primitive);
}

void read_mass(TableReader& table, BodyDescription& body) {
    const std::string_view key = table.either("mass_kg", "density_kgpm3");
    if (key == "density_kgpm3")
        return table.read(key, body.density_kgpm3, {1e-3, 1e5, "kg/m3 from 0.001 to 100000"});
    if (key.empty()) return;
    const TomlNode* node = table.find(key);
    const auto* integer = std::get_if<std::int64_t>(&node->value);
    const auto* number = std::get_if<double>(&node->value);
    const bool is_zero =
        (integer != nullptr && *integer == 0) || (number != nullptr && *number == 0.0);
    if (!is_zero) return table.read(key, body.mass_kg, kMass_kg);
    if (body.kind == BodyKind::Dynamic) {
        table.warning(key, "0 means immovable; the body is static");
        body.kind = BodyKind::Static;
    }
}

/// Principal moments of any real body: none negative, none greater than the other two together.
bool is_physical(const Vec3& inertia) {
    const Vec3d i(inertia);
    const double slack = 1e-6 * (i.x + i.y + i.z);
    return i.x > 0 && i.y > 0 && i.z > 0 && i.x <= i.y + i.z + slack && i.y <= i.x + i.z + slack &&
           i.z <= i.x + i.y + slack;
}

void read_mass_frame(TableReader& table, BodyDescription& body) {
    table.read("center_of_mass_m", body.center_of_mass_m, kCoordinate_m);
    table.read("inertia_kgm2", body.inertia_kgm2, {-1e12, 1e12, "kg m2 up to 1e12"});
    if (!body.inertia_kgm2 || is_physical(*body.inertia_kgm2)) return;
    table.warning("inertia_kgm2",
                  "no body has these moments (each is above 0 and at most the sum of the other "
                  "two); the shape's are used");
    body.inertia_kgm2.reset();
}

void read_losses(TableReader& table, BodyDescription& body) {
    table.read("rolling_friction", body.rolling_friction, kFriction);
    table.read("spinning_friction", body.spinning_friction, kFriction);
    table.read("linear_damping_per_s", body.linear_damping_per_s, kDamping);
    table.read("angular_damping_per_s", body.angular_damping_per_s, kDamping);
}

/// 1 for each of the world's axes that the body is free to move along, 0 for the others.
Vec3 read_linear_factor(TableReader& table, const BodyDescription& body) {
    const Vec3 free{1, 1, 1};
    Vec3 factor = free;
    table.read("linear_factor", factor, kAnyNumber);
    for (int axis = 0; axis < 3; ++axis) {
        if (factor[axis] == Real{0} || factor[axis] == Real{1}) continue;
        table.error("linear_factor",
                    "expected 1 (free) or 0 (held) for each of x, y and z, as in [1, 1, 0]");
        return free;
    }
    if (body.kind != BodyKind::Dynamic && factor != free) {
        table.warning("linear_factor", "only dynamic bodies are held along axes; ignored");
        return free;
    }
    return factor;
}

void read_motion_state(TableReader& table, BodyDescription& body) {
    table.read("velocity_mps", body.velocity_mps, kSpeed_mps);
    table.read("angular_velocity_radps", body.angular_velocity_radps, kSpin_radps);
    table.read("gravity_factor", body.gravity_factor, {-1000, 1000, "a factor from -1000 to 1000"});
    if (body.kind == BodyKind::Dynamic) return;
    const bool moves = glm::length(body.velocity_mps) > 0;
    const bool spins = glm::length(body.angular_velocity_radps) > 0;
    if (!moves && !spins) return;
    table.warning(moves ? "velocity_mps" : "angular_velocity_radps",
                  body.kind == BodyKind::Static
                      ? "a static body does not move; ignored"
                      : "a kinematic body moves as its motion says; ignored");
    body.velocity_mps = body.angular_velocity_radps = Vec3{0, 0, 0};
}

void read_groups(TableReader& table, BodyDescription& body) {
    table.read("group", body.group);
    if (body.group.empty()) table.error("group", "is empty; expected a name");
    table.read("collides_with", body.collides_with);
    // An empty list means everything in the description, and nothing in the file.
    const TomlNode* node = table.find("collides_with");
    if (node != nullptr && node->array() != nullptr && node->array()->empty())
        body.collides_with = {std::string(kNoGroup)};
}

void check_shape(TableReader& table,
                 const BodyDescription& body,
                 const VisualDescription& visual,
                 EntityUse use) {
    const bool has_visual = !std::holds_alternative<std::monostate>(visual);
    const bool needs_visual = !std::holds_alternative<physics::ShapeDef>(body.shape);
    // A shape that was given and refused has had its error.
    const TomlNode* given = table.find("shape");
    const bool refused = given != nullptr && given->text() == nullptr &&
                         std::holds_alternative<FitShape>(body.shape);
    if (use == EntityUse::Entity && needs_visual && !has_visual && !refused) {
        table.error("shape", "missing; expected a shape, or a model or primitive to fit");
    }
    if (body.kind == BodyKind::Dynamic && is_mesh(body.shape)) {
        table.error("shape",
                    "a mesh has no inside: static and kinematic bodies only; use hull or compound");
    }
    if (body.kind != BodyKind::Static && is_plane(body.shape, visual))
        table.error("shape", "planes are for static bodies only; use box");
}

}  // namespace

void read_body_surface(TableReader& table, BodyDescription& body) {
    table.read("friction", body.friction, kFriction);
    table.read("restitution", body.restitution, kFraction);
    constexpr std::array<std::string_view, 5> kRules{
        "usual", "multiply", "maximum", "minimum", "average"};
    table.read_choice("friction_combine", body.friction_rule, kRules);
    table.read_choice("restitution_combine", body.restitution_rule, kRules);
}

void read_body_traits(TableReader& table, BodyDescription& body) {
    read_losses(table, body);
    if (table.has("linear_factor")) body.linear_factor = read_linear_factor(table, body);
    table.read("can_sleep", body.can_sleep);
    table.read_choice("ccd", body.ccd, {"auto", "on", "off"});
    read_body_fields(table, body);
}

void read_body(TableReader& table,
               BodyDescription& body,
               const VisualDescription& visual,
               EntityUse use) {
    table.read_choice("kind", body.kind, {"static", "dynamic", "kinematic"});
    read_mass(table, body);
    body.shape = read_body_shape(table, visual);
    read_mass_frame(table, body);
    read_body_surface(table, body);
    read_motion_state(table, body);
    read_groups(table, body);
    read_body_traits(table, body);
    check_shape(table, body, visual, use);
}

}  // namespace plumbline::scene
