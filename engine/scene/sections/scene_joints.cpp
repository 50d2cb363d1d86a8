// [[joint]]: read and checked.
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
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

struct End {
    const EntityDescription* entity{nullptr};  ///< null: the world, or nothing good
    Vec3 position_m{0, 0, 0};
    bool good{false};
};

End read_end(TableReader& table, std::string_view key, const SceneNames& names, std::string& name) {
    name = table.text(key, {});
    if (!table.has(key)) {
        table.error(key, "missing; expected the name of an entity");
        return {};
    }
    if (name.empty()) return {};
    if (name == "world" && key == "b") return {.good = true};
    if (name == "world") {
        table.error(key, "\"world\" can only be b; name the entity in a and the world in b");
        return {};
    }
    const auto found_entity = names.find(name);
    if (!found_entity) {
        const std::string nearest = names.nearest(name);
        table.error(key,
                    fmt::format("no entity is called \"{}\"{}",
                                shown(name),
                                nearest.empty() ? ""
                                                : fmt::format("; did you mean \"{}\" ({})?",
                                                              nearest,
                                                              to_string(names.location(nearest)))));
        return {};
    }
    if (!found_entity->entity->body) {
        table.error(key,
                    fmt::format("\"{}\" ({}) has no body to hold on to",
                                shown(name),
                                to_string(names.location(name))));
        return {};
    }
    return {.entity = found_entity->entity, .position_m = found_entity->position_m, .good = true};
}

void check_ends(TableReader& table, const JointDescription& joint, const End& a, const End& b) {
    if (!a.good || !b.good) return;
    if (joint.a == joint.b)
        return table.error("b", fmt::format("\"{}\" cannot be joined to itself", shown(joint.b)));
    const auto is_static = [](const End& end) {
        return end.entity == nullptr || end.entity->body->kind == physics::BodyKind::Static;
    };
    if (is_static(a) && is_static(b))
        table.error("b", "neither a nor b can move; expected at least one dynamic body");
}

void read_anchors(TableReader& table, JointDescription& joint, const End& a, const End& b) {
    if (has_two_anchors(joint.kind)) {
        joint.anchor_a_m = table.vector("anchor_a_m", a.position_m, kCoordinate_m);
        joint.anchor_b_m = table.vector(
            "anchor_b_m", b.entity != nullptr ? b.position_m : a.position_m, kCoordinate_m);
        if (b.good && b.entity == nullptr && !table.has("anchor_b_m"))
            table.error("anchor_b_m", "missing; the world needs a point to hold on to");
        return;
    }
    joint.anchor_a_m = table.vector("anchor_m", a.position_m, kCoordinate_m);
    joint.anchor_b_m = joint.anchor_a_m;
    const bool needed = joint.kind == JointKind::BallAndSocket || joint.kind == JointKind::Hinge ||
                        joint.kind == JointKind::Cone;
    if (needed && !table.has("anchor_m"))
        table.error("anchor_m", "missing; expected the point to turn about, [x, y, z] in world m");
}

std::optional<std::array<Real, 2>> read_pair(TableReader& table,
                                             std::string_view key,
                                             const Range& range) {
    const TomlNode* node = table.find(key);
    if (node == nullptr) return {};
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() != 2) {
        table.error(key, fmt::format("{}; expected two numbers", found(*node)));
        return {};
    }
    const std::string path = table.path_of(key);
    const auto low = number_of((*array)[0], path + "[0]", range, table.faults());
    const auto high = number_of((*array)[1], path + "[1]", range, table.faults());
    if (!low || !high) return {};
    return std::array<Real, 2>{static_cast<Real>(*low), static_cast<Real>(*high)};
}

/// A lower and an upper bound, as the file writes them.
std::optional<std::array<Real, 2>> read_bounds(TableReader& table,
                                               std::string_view key,
                                               const Range& range) {
    const auto bounds = read_pair(table, key, range);
    if (bounds && (*bounds)[0] > (*bounds)[1]) {
        table.error(
            key,
            fmt::format("{} is above {}; expected [lower, upper]", (*bounds)[0], (*bounds)[1]));
    }
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

void read_drive(TableReader& table, JointDescription& joint) {
    if (auto motor = table.table("motor")) {
        constexpr Range kTarget{-1e4, 1e4, "rad/s or m/s from -10000 to 10000"};
        if (!motor->has("target")) motor->error("target", "missing; expected rad/s or m/s");
        if (!motor->has("max")) motor->error("max", "missing; expected N m or N");
        joint.motor = physics::JointMotor{.target = motor->number("target", Real{0}, kTarget),
                                          .max = motor->number("max", Real{0}, kForce)};
        motor->finish();
    }
    joint.stiffness_Npm = table.number("stiffness_Npm", Real{0}, kForce);
    joint.damping_Nspm = table.number("damping_Nspm", Real{0}, kForce);
    constexpr Range kLength_m{0, 1e4, "a length from 0 to 10000 m"};
    joint.rest_length_m = table.optional_number("rest_length_m", kLength_m);
    joint.collide = table.flag("collide", false);
    joint.break_N = table.number("break_N", Real{0}, kForce);
    constexpr Range kCreak{0, 10, "a factor from 0 to 10"};
    joint.creak = table.single("creak", joint.creak, kCreak);
}

/// Keys that the kind has no use for: said, not refused.
void warn_of_unused(TableReader& table, JointKind kind) {
    const auto unused = [&](std::string_view key) {
        if (table.has(key)) {
            table.warning(key,
                          fmt::format("a joint of kind {} does not use it; ignored",
                                      kKinds[static_cast<std::size_t>(kind)]));
        }
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

JointDescription read_joint(TableReader& table, const SceneNames& names) {
    JointDescription joint;
    joint.location = table.location();
    joint.name = read_name(table);
    if (!table.has("kind"))
        table.error("kind", fmt::format("missing; expected one of {}", fmt::join(kKinds, ", ")));
    joint.kind = static_cast<JointKind>(table.choice("kind", 0, kKinds));
    const End a = read_end(table, "a", names, joint.a);
    const End b = read_end(table, "b", names, joint.b);
    check_ends(table, joint, a, b);
    read_anchors(table, joint, a, b);
    joint.axis = Vec3(table.direction("axis", Vec3d(joint.axis)));
    read_limits(table, joint);
    read_drive(table, joint);
    if (a.good && b.good) check_length(table, joint);
    if (joint.kind == JointKind::Spring && !table.has("stiffness_Npm"))
        table.error("stiffness_Npm", "missing; expected N per m");
    warn_of_unused(table, joint.kind);
    table.finish();
    return joint;
}

}  // namespace

void read_joints(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("joint");
    if (nodes.empty()) return;
    const SceneNames names(scene, context);
    std::map<std::string, SourceLocation> locations;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::string path = fmt::format("joint[{}]", i);
        TableReader table(nodes[i], path, context.faults);
        JointDescription joint = read_joint(table, names);
        if (joint.name.empty()) joint.name = path;
        const auto [other, is_new] = locations.emplace(joint.name, table.location());
        if (!is_new) {
            table.error("name",
                        fmt::format("\"{}\" is the name of the joint at {} already",
                                    shown(joint.name),
                                    to_string(other->second)));
        }
        scene.joints.push_back(std::move(joint));
    }
}

}  // namespace plumbline::scene
