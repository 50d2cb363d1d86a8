// [[joint]]: read and checked.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <array>

namespace plumbline::scene {
namespace {

constexpr std::array<std::string_view, 7> kKinds{
    "ball_and_socket", "hinge", "slider", "fixed", "cone", "distance", "spring"};
constexpr Range kForce{0, 1e12, "a number from 0 to 1e12"};

bool has_axis(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::Slider || kind == JointKind::Cone;
}
bool has_two_anchors(JointKind kind) {
    return kind == JointKind::Distance || kind == JointKind::Spring;
}
bool turns(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::Cone;
}
bool has_limits(JointKind kind) {
    return has_axis(kind) || kind == JointKind::Distance;
}
bool has_motor(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::Slider;
}

/// Those whose bodies turn against each other.
bool creaks(JointKind kind) {
    return kind == JointKind::Hinge || kind == JointKind::BallAndSocket || kind == JointKind::Cone;
}

void check_ends(TableReader& table,
                const JointDescription& joint,
                const NamedEnd& a,
                const NamedEnd& b) {
    if (!a.good || !b.good) return;
    if (joint.a == joint.b)
        return table.error("b", "\"{}\" cannot be joined to itself", shown(joint.b));
    const auto is_static = [](const NamedEnd& end) {
        return end.entity == nullptr || end.entity->body->kind == physics::BodyKind::Static;
    };
    if (is_static(a) && is_static(b))
        table.error("b", "neither a nor b can move; expected at least one dynamic body");
}

void read_anchors(TableReader& table,
                  JointDescription& joint,
                  const NamedEnd& a,
                  const NamedEnd& b) {
    joint.anchor_a_m = a.position_m;
    if (has_two_anchors(joint.kind)) {
        joint.anchor_b_m = b.entity != nullptr ? b.position_m : a.position_m;
        table.read("anchor_a_m", joint.anchor_a_m, kCoordinate_m);
        table.read("anchor_b_m", joint.anchor_b_m, kCoordinate_m);
        if (b.good && b.entity == nullptr && !table.has("anchor_b_m"))
            table.error("anchor_b_m", "missing; the world needs a point to hold on to");
        return;
    }
    table.read("anchor_m", joint.anchor_a_m, kCoordinate_m);
    joint.anchor_b_m = joint.anchor_a_m;
    const bool needed = joint.kind == JointKind::BallAndSocket || joint.kind == JointKind::Hinge ||
                        joint.kind == JointKind::Cone;
    if (needed) table.require("anchor_m", "the point to turn about, [x, y, z] in world m");
}

/// A lower and an upper bound, as the file writes them.
std::optional<std::array<Real, 2>> read_bounds(TableReader& table,
                                               std::string_view key,
                                               const Range& range) {
    const auto bounds = table.pair(key, range, "two numbers");
    if (bounds && (*bounds)[0] > (*bounds)[1])
        table.error(key, "{} is above {}; expected [lower, upper]", (*bounds)[0], (*bounds)[1]);
    return bounds;
}

void make_radians(std::optional<std::array<Real, 2>>& bounds) {
    if (!bounds) return;
    for (Real& bound : *bounds) bound = radians_from_degrees(bound);
}

void read_limits(TableReader& table, JointDescription& joint) {
    constexpr Range kAngle_deg{-360, 360, "degrees from -360 to 360"};
    constexpr Range kTwist_deg{-180, 180, "degrees from -180 to 180"};
    constexpr Range kDistance_m{0, 1e4, "a length from 0 to 10000 m"};
    const Range range = turns(joint.kind)                   ? kAngle_deg
                        : joint.kind == JointKind::Distance ? kDistance_m
                                                            : kCoordinate_m;
    joint.limits = read_bounds(table, "limits", range);
    if (turns(joint.kind)) make_radians(joint.limits);
    if (joint.kind != JointKind::Cone) return;
    joint.twist = read_bounds(table, "twist", kTwist_deg);
    make_radians(joint.twist);
}

/// One row along a line needs a line.
void check_length(TableReader& table, const JointDescription& joint) {
    constexpr double kShortest_m = limits::kSizeMin_m;
    if (joint.kind != JointKind::Distance || joint.limits) return;
    if (joint.rest_length_m) {
        if (static_cast<double>(*joint.rest_length_m) < kShortest_m)
            table.error("rest_length_m", "too short to keep; use kind = \"ball_and_socket\"");
        return;
    }
    if (glm::distance(Vec3d{joint.anchor_a_m}, Vec3d{joint.anchor_b_m}) < kShortest_m)
        table.error("anchor_b_m",
                    "the anchors are on one spot; use kind = \"ball_and_socket\", or limits");
}

void read_motor(TableReader& table, physics::JointMotor& motor) {
    table.require("target", "rad/s or m/s");
    table.require("max", "N m or N");
    table.read("target", motor.target, {-1e4, 1e4, "rad/s or m/s from -10000 to 10000"});
    table.read("max", motor.max, kForce);
    table.read("stiffness", motor.stiffness, kForce);
    table.read("damping", motor.damping, kForce);
    table.read("position", motor.position, {-1e4, 1e4, "rad or m from -10000 to 10000"});
}

void read_drive(TableReader& table, JointDescription& joint) {
    table.read_table("motor", joint.motor, read_motor);
    table.read("stiffness_Npm", joint.stiffness_Npm, kForce);
    table.read("damping_Nspm", joint.damping_Nspm, kForce);
    table.read("rest_length_m", joint.rest_length_m, {0, 1e4, "a length from 0 to 10000 m"});
    table.read("collide", joint.collide);
    read_joint_traits(table, joint);
}

/// Keys that the kind has no use for: said, not refused.
void warn_of_unused(TableReader& table, JointKind kind) {
    const auto unused = [&](std::string_view key) {
        if (!table.has(key)) return;
        const std::string_view name = kKinds[static_cast<std::size_t>(kind)];
        table.warning(key, "a joint of kind {} does not use it; ignored", name);
    };
    if (!has_axis(kind)) unused("axis");
    if (!has_limits(kind)) unused("limits");
    if (!has_motor(kind)) unused("motor");
    if (!creaks(kind)) unused("creak");
    if (kind != JointKind::Cone) unused("twist");
    if (has_two_anchors(kind)) {
        unused("anchor_m");
    } else {
        unused("anchor_a_m");
        unused("anchor_b_m");
    }
    if (kind != JointKind::Spring) {
        unused("stiffness_Npm");
        unused("damping_Nspm");
        if (kind != JointKind::Distance) unused("rest_length_m");
    }
}

void read_joint(TableReader& table, JointDescription& joint, const SceneNames& names) {
    joint.name = read_name(table);
    if (!table.has("kind"))
        table.error("kind", "missing; expected one of {}", fmt::join(kKinds, ", "));
    table.read_choice("kind", joint.kind, kKinds);
    for (const char* key : {"a", "b"}) table.require(key, "the name of an entity");
    const NamedEnd a = read_named_end(table, "a", names, joint.a, false);
    const NamedEnd b = read_named_end(table, "b", names, joint.b, true);
    check_ends(table, joint, a, b);
    read_anchors(table, joint, a, b);
    table.read_direction("axis", joint.axis);
    read_limits(table, joint);
    read_drive(table, joint);
    if (a.good && b.good) check_length(table, joint);
    if (joint.kind == JointKind::Spring) table.require("stiffness_Npm", "N per m");
    warn_of_unused(table, joint.kind);
}

}  // namespace

void read_joint_traits(TableReader& table, JointDescription& joint) {
    table.read("break_N", joint.break_N, kForce);
    table.read("creak", joint.creak, {0, 10, "a factor from 0 to 10"});
    table.read("bar_m", joint.bar_m, {0, 10, "a radius from 0 to 10 m"});
}

NamedEnd read_named_end(TableReader& table,
                        std::string_view key,
                        const SceneNames& names,
                        std::string& name,
                        bool or_world) {
    table.read(key, name);
    if (name.empty()) return {};
    if (name == "world" && or_world) return {.good = true};
    if (name == "world") {
        table.error(key, "\"world\" can only be b; name the entity in a and the world in b");
        return {};
    }
    const auto found_entity = names.find(name);
    if (!found_entity) {
        const std::string nearest = names.nearest(name);
        const std::string place = to_string(names.location(nearest));
        const std::string hint =
            nearest.empty() ? "" : fmt::format("; did you mean \"{}\" ({})?", nearest, place);
        table.error(key, "no entity is called \"{}\"{}", shown(name), hint);
        return {};
    }
    if (!found_entity->entity->body) {
        const std::string place = to_string(names.location(name));
        table.error(key, "\"{}\" ({}) has no body to hold on to", shown(name), place);
        return {};
    }
    return {.entity = found_entity->entity, .position_m = found_entity->position_m, .good = true};
}

void read_joints(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("joint");
    if (nodes.empty()) return;
    const SceneNames names(scene, context);
    root.read_tables("joint", scene.joints, read_joint, names);
    std::map<std::string, SourceLocation> locations;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        TableReader table = root.item("joint", nodes, i);
        std::string& name = scene.joints[i].name;
        if (name.empty()) name = table.path();
        const auto [other, is_new] = locations.emplace(name, table.location());
        if (is_new) continue;
        table.error("name",
                    "\"{}\" is the name of the joint at {} already",
                    shown(name),
                    to_string(other->second));
    }
}

}  // namespace plumbline::scene
