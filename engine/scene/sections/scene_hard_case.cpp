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
constexpr std::array<std::string_view, 2> kTiers{"ci", "nightly"};
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
    table.error(
        key,
        fmt::format("no entity or joint is called \"{}\"{}", shown(name), at.entities.hint(name)));
}

HardCaseRule read_rule(TableReader& table, const Known& known) {
    HardCaseRule rule;
    rule.location = table.location();
    if (!table.has("measure")) table.error("measure", "missing; expected the name of a measure");
    rule.measure = table.text("measure", {});
    rule.of = table.texts("of");
    for (const std::string& name : rule.of) check_name(table, "of", name, known);
    rule.relative_to = table.text("relative_to", {});
    check_name(table, "relative_to", rule.relative_to, known);
    rule.from_s = static_cast<double>(table.number("from_s", Real{0}, kTime_s));
    const auto number = [&](std::string_view key, const Range& range) -> std::optional<double> {
        const std::optional<Real> value = table.optional_number(key, range);
        return value ? std::optional<double>(static_cast<double>(*value)) : std::nullopt;
    };
    rule.to_s = number("to_s", kTime_s);
    rule.below = number("below", kLimit);
    rule.above = number("above", kLimit);
    if (rule.to_s && *rule.to_s < rule.from_s) table.error("to_s", "lies before from_s");
    rule.near = number("near", kLimit);
    if (rule.near && !table.has("within")) table.error("within", "missing; expected how near");
    rule.within = number("within", Range{1e-12, 1e12, "a number above 0"}).value_or(0);
    if (int{rule.below.has_value()} + int{rule.above.has_value()} + int{rule.near.has_value()} != 1)
        table.error("below", "expected one of below, above, and near with within");
    table.finish();
    return rule;
}

HardCaseRed read_red(TableReader& table) {
    HardCaseRed red;
    red.location = table.location();
    for (const std::string_view key : {"rule", "why"}) {
        if (!table.has(key)) table.error(key, "missing; expected text");
    }
    red.rule = table.text("rule", {});
    red.gone = table.flag("gone", false);
    if (table.has("reached") == red.gone)
        table.error("reached", "expected either the worst value or gone = true");
    red.reached = static_cast<double>(table.number("reached", Real{0}, kLimit));
    red.why = table.text("why", {});
    table.finish();
    return red;
}

bool has_value(CaseEventKind kind) {
    return kind != CaseEventKind::Remove && kind != CaseEventKind::MotorOff &&
           kind != CaseEventKind::NotFinite;
}

HardCaseEvent read_event(TableReader& table, const Known& known) {
    constexpr Range kValue{-1e12, 1e12, "a number from -1e12 to 1e12"};
    HardCaseEvent event;
    if (!table.has("do"))
        table.error("do", fmt::format("missing; expected one of {}", fmt::join(kEvents, ", ")));
    event.kind = static_cast<CaseEventKind>(table.choice("do", 0, kEvents));
    event.at_s = static_cast<double>(table.number("at_s", Real{0}, kTime_s));
    event.of = table.text("of", {});
    if (event.kind == CaseEventKind::MotorOff) {
        if (!known.joints.contains(event.of)) table.error("of", "expected the name of a joint");
    } else if (event.kind != CaseEventKind::Gravity) {
        const auto found = known.entities.find(event.of);
        if (!found) check_name(table, "of", event.of, known);
        if (event.of.empty() || (found && !found->entity->body))
            table.error("of", "expected the name of an entity with a body");
    }
    if (has_value(event.kind) && !table.has("value"))
        table.error("value", "missing; expected [x, y, z]");
    event.value = table.vector("value", event.value, kValue);
    if (event.kind == CaseEventKind::Velocity)
        event.angular_velocity_radps =
            table.vector("angular_velocity_radps", event.angular_velocity_radps, kValue);
    if (event.kind == CaseEventKind::Force || event.kind == CaseEventKind::Impulse)
        event.point_m = table.vector("point_m", event.point_m, kCoordinate_m);
    if (event.kind == CaseEventKind::Force)
        event.duration_s = static_cast<double>(table.number("duration_s", Real{0}, kTime_s));
    table.finish();
    return event;
}

void read_general_limits(TableReader& table, HardCase& hard) {
    constexpr Range kLength_m{1e-9, 1e4, "a length above 0, up to 10000 m"};
    constexpr Range kShare{1e-9, 1e6, "a share above 0"};
    const auto number = [&](std::string_view key, double fallback, const Range& range) {
        return static_cast<double>(table.number(key, static_cast<Real>(fallback), range));
    };
    hard.settled_s = number("settled_s", 0, kTime_s);
    hard.unsettled = table.text("unsettled", {});
    if (hard.settled_s > 0 && hard.unsettled.empty())
        table.error("settled_s", "expected `unsettled`, which says why not from the start");
    hard.penetration_m = number("penetration_m", hard.penetration_m, kLength_m);
    hard.energy_gain = number("energy_gain", hard.energy_gain, kShare);
    hard.energy_scale_J = number("energy_scale_J", hard.energy_scale_J, kNotNegative);
    hard.energy_from = table.text("energy_from", {});
    hard.non_finite = table.integer("non_finite", 0, 0, 1000);
    hard.removed = table.integer("removed", 0, 0, 50'000);
}

}  // namespace

void read_hard_case(TableReader& root, SceneDescription& scene, LoadContext& context) {
    auto table = root.table("hard_case");
    if (!table) return;
    HardCase hard;
    hard.location = table->location();
    for (const std::string_view key : {"id", "shows"}) {
        if (!table->has(key)) table->error(key, "missing; expected text");
    }
    hard.id = table->text("id", {});
    hard.shows = table->text("shows", {});
    hard.known_to_fail = table->text("known_to_fail", {});
    hard.seconds = static_cast<double>(
        table->number("seconds", Real{10}, Range{0.1, 3600, "seconds from 0.1 to 3600"}));
    hard.nightly = table->choice("tier", 0, kTiers) == 1;
    read_general_limits(*table, hard);

    const SceneNames names(scene, context);
    Known known{names, {}};
    for (const JointDescription& joint : scene.joints) known.joints.insert(joint.name);
    const auto rules = table->tables("pass");
    for (std::size_t i = 0; i < rules.size(); ++i) {
        TableReader rule(rules[i], fmt::format("hard_case.pass[{}]", i), context.faults);
        hard.rules.push_back(read_rule(rule, known));
    }
    const auto reds = table->tables("known_red");
    for (std::size_t i = 0; i < reds.size(); ++i) {
        TableReader red(reds[i], fmt::format("hard_case.known_red[{}]", i), context.faults);
        hard.known_red.push_back(read_red(red));
    }
    const auto events = table->tables("event");
    for (std::size_t i = 0; i < events.size(); ++i) {
        TableReader event(events[i], fmt::format("hard_case.event[{}]", i), context.faults);
        hard.events.push_back(read_event(event, known));
    }
    std::ranges::stable_sort(hard.events, {}, &HardCaseEvent::at_s);
    table->finish();
    scene.hard_case = std::move(hard);
}

}  // namespace plumbline::scene
