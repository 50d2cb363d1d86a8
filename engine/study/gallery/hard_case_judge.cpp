#include "engine/study/gallery/hard_case_judge.h"

#include "engine/core/text/nearest_name.h"
#include "engine/physics/totals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kHalfStep = 0.5;
/// A case that holds only because the guard took more of its energy does not hold.
constexpr double kMostBraked = 0.01;
/// Stands for "none" where a rule looks at the world or at joints.
const std::string kNobody;

bool matches(std::string_view pattern, std::string_view name) {
    if (!pattern.ends_with('*')) return pattern == name;
    return name.starts_with(pattern.substr(0, pattern.size() - 1));
}

Error fault_at(const SourceLocation& location, const std::string& message) {
    return {.message = fmt::format("{}: {}", to_string(location), message),
            .exit_code = ExitCode::Refused};
}

Error unknown_measure(const scene::HardCaseRule& rule) {
    std::vector<std::string_view> names;
    for (const Measure& measure : measures()) names.push_back(measure.name);
    const std::string_view nearest = nearest_name(rule.measure, names);
    return fault_at(rule.location,
                    fmt::format("\"{}\" is no measure; {}",
                                rule.measure,
                                nearest.empty() ? fmt::format("known: {}", fmt::join(names, ", "))
                                                : fmt::format("did you mean \"{}\"?", nearest)));
}

Error unknown_rule(const scene::HardCaseRed& red, std::span<const RuleState> rules) {
    std::vector<std::string_view> texts;
    for (const RuleState& rule : rules) texts.push_back(rule.text);
    return fault_at(
        red.location,
        fmt::format("no rule is called \"{}\"; there are: {}", red.rule, fmt::join(texts, " | ")));
}

std::string rule_text(const scene::HardCaseRule& rule, double seconds) {
    std::string text = rule.measure;
    if (!rule.of.empty()) text += fmt::format(" of {}", fmt::join(rule.of, ", "));
    if (!rule.relative_to.empty()) text += fmt::format(" against {}", rule.relative_to);
    if (rule.below) text += fmt::format(" at most {:.4g}", *rule.below);
    if (rule.above) text += fmt::format(" at least {:.4g}", *rule.above);
    if (rule.near) text += fmt::format(" within {:.3g} of {:.4g}", rule.within, *rule.near);
    const double to_s = std::min(seconds, rule.to_s.value_or(seconds));
    if (rule.from_s >= seconds)
        text += ", at the end";
    else if (rule.from_s > 0 && to_s < seconds)
        text += fmt::format(", from {:g} to {:g} s", rule.from_s, to_s);
    else if (rule.from_s > 0)
        text += fmt::format(", from {:g} s", rule.from_s);
    else if (to_s < seconds)
        text += fmt::format(", until {:g} s", to_s);
    return text;
}

RuleState state_of(const scene::HardCaseRule& rule, double seconds) {
    RuleState state;
    state.text = rule_text(rule, seconds);
    state.measure = rule.measure;
    if (rule.below) state.allowed = {Allowed::Kind::Below, *rule.below, 0};
    if (rule.above) state.allowed = {Allowed::Kind::Above, *rule.above, 0};
    if (rule.near) state.allowed = {Allowed::Kind::Near, *rule.near, rule.within};
    state.from_s = std::min(rule.from_s, seconds);
    state.to_s = std::min(rule.to_s.value_or(seconds), seconds);
    return state;
}

}  // namespace

double Allowed::margin(double value) const {
    if (!std::isfinite(value)) return -std::numeric_limits<double>::infinity();
    if (kind == Kind::Near) return 1 - std::abs(value - limit) / within;
    const double inside = kind == Kind::Below ? limit - value : value - limit;
    if (limit != 0) return inside / std::abs(limit);
    return inside == 0 ? 1 : inside;
}

std::string margin_text(double margin) {
    if (!std::isfinite(margin)) return "gone";
    if (margin >= 0) return fmt::format("{:.0f} % inside", std::min(margin, 10.0) * 100);
    if (margin > -10) return fmt::format("{:.0f} % outside", -margin * 100);
    return fmt::format("{:.3g} x outside", -margin);
}

HardCaseJudge::HardCaseJudge(const scene::Simulation& simulation)
    : seconds_(simulation.description().hard_case->seconds) {
    const scene::HardCase& hard = *simulation.description().hard_case;
    const scene::Totals totals = scene::totals_of(simulation);
    start_.energy_J = totals.energy.total_J();
    start_.energy_scale_J =
        hard.energy_scale_J > 0 ? hard.energy_scale_J : std::max(std::abs(start_.energy_J), 1e-9);
    start_.momentum_kgmps = totals.momentum_kgmps;
    start_.angular_momentum_kgm2ps = totals.angular_momentum_kgm2ps;
}

Result<HardCaseJudge> HardCaseJudge::create(const scene::Simulation& simulation) {
    const std::optional<scene::HardCase>& hard = simulation.description().hard_case;
    if (!hard) {
        return Error{.message = fmt::format("{} has no [hard_case]: nothing to judge it by",
                                            simulation.description().file.string()),
                     .exit_code = ExitCode::Refused};
    }
    HardCaseJudge judge(simulation);
    for (const scene::HardCaseRule& rule : hard->rules) {
        if (const Result<Done> added = judge.add_rule(simulation, rule); !added)
            return added.error();
    }
    if (const Result<Done> added = judge.add_general_rules(simulation); !added)
        return added.error();
    for (const scene::HardCaseRed& red : hard->known_red) {
        if (std::ranges::find(judge.states_, red.rule, &RuleState::text) == judge.states_.end())
            return unknown_rule(red, judge.states_);
    }
    return judge;
}

Result<Done> HardCaseJudge::add_general_rules(const scene::Simulation& simulation) {
    const scene::HardCase& hard = *simulation.description().hard_case;
    std::vector<scene::HardCaseRule> rules{
        {.measure = "non_finite", .below = hard.non_finite},
        {.measure = "removed", .below = hard.removed},
        {.measure = "penetration_m", .from_s = hard.settled_s, .below = hard.penetration_m},
        {.measure = "braked_share", .below = kMostBraked}};
    if (hard.energy_from.empty())
        rules.push_back({.measure = "energy_gain", .below = hard.energy_gain});
    for (const scene::HardCaseRule& rule : rules) {
        if (const Result<Done> added = add_rule(simulation, rule); !added) return added.error();
    }
    return Done{};
}

Result<Done> HardCaseJudge::add_rule(const scene::Simulation& simulation,
                                     const scene::HardCaseRule& rule) {
    Watched watched{.measure = find_measure(rule.measure)};
    if (watched.measure == nullptr) return unknown_measure(rule);
    const auto& value = watched.measure->value;
    if (std::holds_alternative<JointMeasure>(value)) {
        auto joints = joints_called(simulation, rule);
        if (!joints) return joints.error();
        watched.joints = std::move(*joints);
    } else if (!std::holds_alternative<WorldMeasure>(value)) {
        auto bodies = bodies_called(simulation, rule);
        if (!bodies) return bodies.error();
        watched.bodies = std::move(*bodies);
        if (!rule.relative_to.empty()) {
            watched.relative_to = body_index(simulation, rule.relative_to);
            if (watched.relative_to == kNone)
                return fault_at(rule.location, fmt::format("\"{}\" has no body", rule.relative_to));
        }
    }
    needs_contacts_ = needs_contacts_ || rule.measure == "contact_force_N";
    watched_.push_back(std::move(watched));
    states_.push_back(state_of(rule, seconds_));
    return Done{};
}

std::size_t HardCaseJudge::body_index(const scene::Simulation& simulation,
                                      const std::string& name) {
    const auto known = std::ranges::find(bodies_, name, &Body::name);
    if (known != bodies_.end()) return static_cast<std::size_t>(known - bodies_.begin());
    const ecs::Entity entity = simulation.find(name);
    const scene::BodyRef* ref = simulation.registry.alive(entity)
                                    ? simulation.registry.find<scene::BodyRef>(entity)
                                    : nullptr;
    if (ref == nullptr) return kNone;
    const physics::BodyState state = simulation.physics.state(ref->body);
    bodies_.push_back({.entity = entity,
                       .id = ref->body,
                       .name = name,
                       .start = {state.world_from_body, Vec3d{state.velocity_mps}}});
    return bodies_.size() - 1;
}

Result<std::vector<std::size_t>> HardCaseJudge::bodies_called(const scene::Simulation& simulation,
                                                              const scene::HardCaseRule& rule) {
    std::vector<std::size_t> found;
    const auto add_matching = [&](std::string_view pattern) {
        const std::size_t before = found.size();
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            const std::string& name = simulation.registry.get<scene::Name>(moving.entity).text;
            const bool all = pattern == "*" && moving.kind != physics::BodyKind::Dynamic;
            if (matches(pattern, name) && !all) found.push_back(body_index(simulation, name));
        }
        return found.size() > before;
    };
    if (rule.of.empty()) add_matching("*");
    for (const std::string& name : rule.of) {
        if (!add_matching(name))
            return fault_at(rule.location, fmt::format("no moving body is called \"{}\"", name));
    }
    if (found.empty()) return fault_at(rule.location, "the scene has no dynamic bodies to watch");
    return found;
}

Result<std::vector<std::size_t>> HardCaseJudge::joints_called(
    const scene::Simulation& simulation, const scene::HardCaseRule& rule) const {
    std::vector<std::size_t> found;
    const auto joints = simulation.joints();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const auto matches_pattern = [&](const std::string& pattern) {
            return matches(pattern, joints[i].name);
        };
        if (rule.of.empty() || std::ranges::any_of(rule.of, matches_pattern)) found.push_back(i);
    }
    if (found.empty())
        return fault_at(rule.location,
                        fmt::format("no joint is called \"{}\"", fmt::join(rule.of, "\", \"")));
    return found;
}

BodyObservation HardCaseJudge::look_at(const scene::Simulation& simulation,
                                       std::size_t body,
                                       std::size_t other) const {
    const Body& mine = bodies_[body];
    BodyObservation look{
        .id = mine.id,
        .start = mine.start,
        .now = simulation.physics.state(mine.id),
        .lowest_m = mine.lowest_m,
        .gravity_mps2 = static_cast<double>(glm::length(simulation.physics.def().gravity_mps2)),
        .contacts = contacts_,
        .step_s = simulation.physics.def().step_s};
    if (other != kNone && simulation.physics.contains(bodies_[other].id)) {
        look.other = bodies_[other].id;
        look.other_start = bodies_[other].start;
        look.other_now = simulation.physics.state(look.other);
    }
    return look;
}

void HardCaseJudge::look(const scene::Simulation& simulation,
                         const Watched& watched,
                         RuleState& state) {
    const auto take = [&](double value, const std::string& whose) {
        const bool is_worse = state.allowed.margin(value) < state.margin();
        // Once not a number, for ever.
        if (state.seen && !is_worse && !std::isnan(value)) return;
        if (state.seen && std::isnan(state.value)) return;
        state.seen = true;
        state.value = value;
        state.worst_of = whose;
        state.worst_at_s = simulation.time_s();
    };
    constexpr double kGone = std::numeric_limits<double>::quiet_NaN();
    const auto& value = watched.measure->value;
    if (const auto* of_world = std::get_if<WorldMeasure>(&value)) {
        take((*of_world)({.world = simulation.physics,
                          .totals = totals_,
                          .start = start_,
                          .added_energy_J = simulation.added_energy_J,
                          .braked_J = interventions_.braked_J,
                          .penetration_m = penetration_m_,
                          .removed = simulation.tally().removed}),
             kNobody);
        return;
    }
    if (const auto* of_joint = std::get_if<JointMeasure>(&value)) {
        for (const std::size_t i : watched.joints) {
            const scene::SceneJoint& joint = simulation.joints()[i];
            const bool is_there = simulation.physics.contains(joint.joint);
            take(is_there ? (*of_joint)(simulation.physics.joint(joint.joint).state) : kGone,
                 joint.name);
        }
        return;
    }
    std::vector<BodyObservation> looks;
    for (const std::size_t i : watched.bodies) {
        const bool is_there = simulation.physics.contains(bodies_[i].id);
        if (!is_there) return take(kGone, bodies_[i].name);
        const BodyObservation look = look_at(simulation, i, watched.relative_to);
        if (const auto* of_body = std::get_if<BodyMeasure>(&value))
            take((*of_body)(look), bodies_[i].name);
        else
            looks.push_back(look);
    }
    if (const auto* of_bodies = std::get_if<BodiesMeasure>(&value))
        take((*of_bodies)(looks), kNobody);
}

void HardCaseJudge::after_step(const scene::Simulation& simulation,
                               const std::optional<double>& penetration_m) {
    if (has_ended_) return;
    penetration_m_ = penetration_m;
    interventions_.add(simulation.physics.report().cost.interventions);
    totals_ = scene::totals_of(simulation);
    // Fields are there once effects are, which is after the judge.
    if (!std::exchange(knows_fields_, true))
        start_.energy_J += totals_.energy_J() - totals_.energy.total_J();
    const double time_s = simulation.time_s();
    const double half_step_s = kHalfStep * simulation.step_s();
    for (Body& body : bodies_) {
        if (!simulation.physics.contains(body.id)) continue;
        const physics::BodyState state = simulation.physics.state(body.id);
        body.lowest_m =
            std::min(body.lowest_m, static_cast<double>(state.world_from_body.position.y));
    }
    if (needs_contacts_) contacts_ = all_contacts(simulation.physics);
    has_ended_ = time_s > seconds_ - half_step_s;
    bool any_failed = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        RuleState& state = states_[i];
        const bool has_begun = time_s > state.from_s - half_step_s;
        if (has_begun && time_s < state.to_s + half_step_s) look(simulation, watched_[i], state);
        if (state.seen && !(state.margin() >= 0))
            state.verdict = Verdict::Fail;
        else if (has_ended_ || time_s > state.to_s + half_step_s)
            state.verdict = state.seen ? Verdict::Pass : Verdict::Fail;
        any_failed = any_failed || state.verdict == Verdict::Fail;
    }
    verdict_ = any_failed ? Verdict::Fail : has_ended_ ? Verdict::Pass : Verdict::Undecided;
}

const RuleState* HardCaseJudge::worst() const {
    const RuleState* worst = nullptr;
    for (const RuleState& state : states_) {
        if (state.seen && (worst == nullptr || state.margin() < worst->margin())) worst = &state;
    }
    return worst;
}

}  // namespace plumbline::study
