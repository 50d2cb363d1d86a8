// [hard_case]: what a scene of the gallery shows, who fails it, what passes, and what is done to it.
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace plumbline::scene {
namespace {

constexpr Range kTime_s{0, 3600, "seconds from 0 to 3600"};
constexpr Range kLimit{-1e12, 1e12, "a number from -1e12 to 1e12"};
constexpr std::array<std::string_view, 8> kEvents{
    "teleport", "velocity", "force", "impulse", "gravity", "remove", "motor_off", "not_finite"};

/// Names that rules and events may give.
struct Known {
    const SceneNames& entities;
    std::set<std::string_view> joints;
};

void check_name(TableReader& table,
                std::string_view key,
                const std::string& name,
                const Known& at) {
    // "cube.*" is looked up when the bodies are there.
    if (name.empty() || name.ends_with('*') || at.joints.contains(name)) return;
    if (at.entities.find(name)) return;
    const std::string hint = at.entities.hint(name);
    table.error(key, "no entity or joint is called \"{}\"{}", shown(name), hint);
}

void read_rule(TableReader& table, HardCaseRule& rule, const Known& known) {
    table.require("measure", "the name of a measure");
    table.read("measure", rule.measure);
    table.read("of", rule.of);
    for (const std::string& name : rule.of) check_name(table, "of", name, known);
    table.read("relative_to", rule.relative_to);
    check_name(table, "relative_to", rule.relative_to, known);
    table.read("from_s", rule.from_s, kTime_s);
    table.read("to_s", rule.to_s, kTime_s);
    table.read("below", rule.below, kLimit);
    table.read("above", rule.above, kLimit);
    if (rule.to_s && *rule.to_s < rule.from_s) table.error("to_s", "lies before from_s");
    table.read("near", rule.near, kLimit);
    if (rule.near) table.require("within", "how near");
    table.read("within", rule.within, {1e-12, 1e12, "a number above 0"});
    if (int{rule.below.has_value()} + int{rule.above.has_value()} + int{rule.near.has_value()} != 1)
        table.error("below", "expected one of below, above, and near with within");
}

void read_red(TableReader& table, HardCaseRed& red) {
    for (const std::string_view key : {"rule", "why"}) table.require(key, "text");
    table.read("rule", red.rule);
    table.read("gone", red.gone);
    if (table.has("reached") == red.gone)
        table.error("reached", "expected either the worst value or gone = true");
    table.read("reached", red.reached, kLimit);
    table.read("why", red.why);
}

bool has_value(CaseEventKind kind) {
    return kind != CaseEventKind::Remove && kind != CaseEventKind::MotorOff &&
           kind != CaseEventKind::NotFinite;
}

void read_event(TableReader& table, HardCaseEvent& event, const Known& known) {
    if (!table.has("do"))
        table.error("do", "missing; expected one of {}", fmt::join(kEvents, ", "));
    table.read_choice("do", event.kind, kEvents);
    table.read("at_s", event.at_s, kTime_s);
    table.read("of", event.of);
    if (event.kind == CaseEventKind::MotorOff) {
        if (!known.joints.contains(event.of)) table.error("of", "expected the name of a joint");
    } else if (event.kind != CaseEventKind::Gravity) {
        const auto found = known.entities.find(event.of);
        if (!found) check_name(table, "of", event.of, known);
        if (event.of.empty() || (found && !found->entity->body))
            table.error("of", "expected the name of an entity with a body");
    }
    if (has_value(event.kind)) table.require("value", "[x, y, z]");
    table.read("value", event.value, kLimit);
    if (event.kind == CaseEventKind::Velocity)
        table.read("angular_velocity_radps", event.angular_velocity_radps, kLimit);
    if (event.kind == CaseEventKind::Force || event.kind == CaseEventKind::Impulse)
        table.read("point_m", event.point_m, kCoordinate_m);
    if (event.kind == CaseEventKind::Force) table.read("duration_s", event.duration_s, kTime_s);
}

void read_general_limits(TableReader& table, HardCase& hard) {
    table.read("settled_s", hard.settled_s, kTime_s);
    table.read("unsettled", hard.unsettled);
    if (hard.settled_s > 0 && hard.unsettled.empty())
        table.error("settled_s", "expected `unsettled`, which says why not from the start");
    constexpr Range kLength_m{1e-9, 1e4, "a length above 0, up to 10000 m"};
    table.read("penetration_m", hard.penetration_m, kLength_m);
    table.read("energy_gain", hard.energy_gain, {1e-9, 1e6, "a share above 0"});
    table.read("energy_scale_J", hard.energy_scale_J, kNotNegative);
    table.read("energy_from", hard.energy_from);
    table.read("non_finite", hard.non_finite, 0, 1000);
    table.read("removed", hard.removed, 0, 50'000);
}

void read_case(TableReader& table,
               HardCase& hard,
               const SceneDescription& scene,
               const LoadContext& context) {
    for (const std::string_view key : {"id", "shows"}) table.require(key, "text");
    table.read("id", hard.id);
    table.read("shows", hard.shows);
    table.read("known_to_fail", hard.known_to_fail);
    table.read("seconds", hard.seconds, {0.1, 3600, "seconds from 0.1 to 3600"});
    table.read_choice("tier", hard.nightly, {"ci", "nightly"});
    read_general_limits(table, hard);

    const SceneNames names(scene, context);
    Known known{names, {}};
    for (const JointDescription& joint : scene.joints) known.joints.insert(joint.name);
    table.read_tables("pass", hard.rules, read_rule, known);
    table.read_tables("known_red", hard.known_red, read_red);
    table.read_tables("event", hard.events, read_event, known);
    std::ranges::stable_sort(hard.events, {}, &HardCaseEvent::at_s);
}

}  // namespace

void read_hard_case(TableReader& root, SceneDescription& scene, LoadContext& context) {
    root.read_table("hard_case", scene.hard_case, read_case, scene, context);
}

}  // namespace plumbline::scene
