// What the hands do: choose, drop, throw, hold, freeze, remove.
#include "game/rules/rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::game {

namespace {

constexpr int kMostDropsAtOnce = 4;
constexpr Real kChargeFrom_s = 0.2_r;
constexpr Real kChargeTo_s = 1.0_r;
constexpr Real kSlowestThrow_mps = 5;
constexpr Real kFastestThrow_mps = 25;
constexpr Real kRemoveReach_m = 12;
constexpr Real kReadReach_m = 4;
constexpr Real kReadCosine = 0.94_r;  // of 20 degrees off the middle of the view
constexpr Real kNotch_m = 0.25_r;
constexpr Real kPushSpeed_mps = 1.5_r;
constexpr Real kPreview_s = 5;  // after a choice or a drop

Real charge_after(Real held_s) {
    return std::clamp((held_s - kChargeFrom_s) / (kChargeTo_s - kChargeFrom_s), Real{0}, Real{1});
}

/// What a person reads: the label, or the name without its numbers ("oak_crate#3" is an oak crate);
/// nothing for what the scene gave no name.
std::string words_of(const scene::Name& name) {
    if (!name.label.empty()) return name.label;
    std::string words = name.text.substr(0, name.text.find_first_of("#["));
    if (words == "entity" || words == "array") return {};
    while (!words.empty() && (words.back() >= '0' && words.back() <= '9')) words.pop_back();
    std::ranges::replace(words, '_', ' ');
    while (!words.empty() && words.back() == ' ') words.pop_back();
    return words;
}

/// The plaque nearest to the middle of the view, of those that can be read from there.
std::optional<scene::PlaqueReading> plaque_before(const scene::Simulation& simulation,
                                                  const Aim& aim) {
    std::optional<scene::PlaqueReading> read;
    Real best = kReadCosine;
    for (auto [entity, plaque, transform] :
         simulation.registry.view<const scene::Plaque, const scene::Transform>()) {
        const Vec3 way = transform.world_from_body.position - aim.eye_m;
        const Real away_m = glm::length(way);
        if (away_m > kReadReach_m || glm::dot(way, aim.forward) < best * away_m) continue;
        best = glm::dot(way, aim.forward) / away_m;
        read = {.says = plaque.says,
                .measured = plaque.meter.measured(),
                .periods = plaque.meter.periods()};
    }
    return read;
}

struct Weighed {
    ecs::Entity entity{};
    double mass_kg{0};
};

/// What hands could take hold of.
std::optional<Weighed> weighed_in_sight(const scene::Simulation& simulation, const Aim& aim) {
    const auto looked = looked_at(simulation, aim, Grab::kReach_m);
    const Real reach_m = sight_m(looked, aim, Grab::kReach_m);
    if (const auto soft = soft_looked_at(simulation, aim, static_cast<double>(reach_m)))
        return Weighed{soft->entity, soft->mass_kg};
    if (!looked || !simulation.registry.alive(looked->entity)) return {};
    const physics::BodyState state = simulation.physics.state(looked->body);
    if (state.kind != physics::BodyKind::Dynamic) return {};
    return Weighed{looked->entity, static_cast<double>(state.mass.mass_kg)};
}

}  // namespace

void PlaygroundGame::begin_goal(const scene::Simulation& simulation) {
    if (!simulation.description().goal) return;
    goal_.emplace(simulation);
    const auto with = std::ranges::find(kThingNames, simulation.description().goal->with);
    dropping_.chooses = with == kThingNames.end();
    if (!dropping_.chooses) things_.choose(static_cast<std::size_t>(with - kThingNames.begin()));
}

bool PlaygroundGame::is_guarded(ecs::Entity entity) {
    if (!goal_ || !goal_->guards(entity)) return false;
    say("this object is a target: throw something at it");
    return true;
}

void PlaygroundGame::choose(const Actions& actions) {
    dropping_.preview_left_s = std::max(dropping_.preview_left_s - step_s_, Real{0});
    if (!dropping_.chooses) return;
    const std::size_t before = things_.chosen();
    for (std::size_t i = 0; i < 9; ++i) {
        const auto select = static_cast<Action>(static_cast<std::size_t>(Action::Select1) + i);
        if (actions.presses(select) > 0) things_.choose(i);
    }
    things_.choose_next(actions.presses(Action::NextThing) -
                        actions.presses(Action::PreviousThing));
    if (things_.chosen() != before) dropping_.preview_left_s = kPreview_s;
}

void PlaygroundGame::put_one(scene::Simulation& simulation, const Vec3& velocity_mps) {
    if (const auto refusal = goal_ ? goal_->refusal() : std::nullopt) return say(*refusal);
    const auto made = things_.put(simulation, aim(), velocity_mps);
    if (!made) return say(made.error().message);
    if (goal_) goal_->count_throw(simulation);
    if (things_.keep_limit(simulation)) {
        say(fmt::format(
            "limit of {} dropped objects reached: the oldest one is removed for each new one",
            Things::kMost));
    }
}

void PlaygroundGame::drop(scene::Simulation& simulation, const Actions& actions) {
    for (int i = 0; i < actions.presses(Action::UndoDrop); ++i) {
        if (!things_.undo(simulation)) say("nothing to undo");
        forget_gone(simulation);
    }
    const int drops =
        dropping_.repeat.acts(std::min(actions.presses(Action::Drop), kMostDropsAtOnce),
                              actions.is_held(Action::Drop) ? 1 : 0,
                              step_s_);
    for (int i = 0; i < drops; ++i) put_one(simulation, {0, 0, 0});
    if (drops > 0) dropping_.preview_left_s = kPreview_s;
}

void PlaygroundGame::charge_and_throw(scene::Simulation& simulation, const Actions& actions) {
    const bool held = actions.is_held(Action::Throw);
    if (keys_.throw_s >= 0) {
        keys_.throw_s += step_s_;
        if (held) return;
        launch(simulation, charge_after(keys_.throw_s));
        keys_.throw_s = -1;
        return;
    }
    if (actions.presses(Action::Throw) == 0) return;
    if (held) {
        keys_.throw_s = 0;
    } else {
        launch(simulation, 0);  // pressed and released within one step
    }
}

void PlaygroundGame::launch(scene::Simulation& simulation, Real charge) {
    const Aim now = aim();
    const Real speed = glm::mix(kSlowestThrow_mps, kFastestThrow_mps, charge);
    const Vec3 velocity = now.forward * speed + now.velocity_mps;
    if (!grab_.holding()) {
        put_one(simulation, velocity);
    } else if (!grab_.throw_it(simulation, now, velocity)) {
        say("cannot release it behind a wall: pull it out first");
    }
}

void PlaygroundGame::hold(scene::Simulation& simulation, const Actions& actions) {
    const bool wants = actions.is_held(Action::Grab);
    // Let go and pressed again within one step also takes hold anew.
    const bool pressed = wants && (!keys_.grabbed || actions.presses(Action::Grab) > 1);
    if (!wants && grab_.holding()) grab_.release(simulation);
    if (pressed && !grab_.holding()) {
        const auto looked =
            goal_ ? looked_at(simulation, aim(), Grab::kReach_m) : std::optional<Looked>{};
        if (!looked || !is_guarded(looked->entity)) {
            if (const auto refusal = grab_.take(simulation, aim())) say(*refusal);
        }
        if (goal_ && grab_.holding()) goal_->begin(simulation);
    }
    keys_.grabbed = wants;

    const int notches = actions.presses(Action::Push) - actions.presses(Action::Pull);
    const Real along = travel_of(actions, Action::Push) - travel_of(actions, Action::Pull);
    if (grab_.holding() && mode_ != MoveMode::Orbit) {
        grab_.change_distance(notches != 0 ? static_cast<Real>(notches) * kNotch_m
                                           : along * kPushSpeed_mps * step_s_);
    }
    if (actions.presses(Action::Freeze) % 2 == 1) freeze(simulation);
    if (actions.presses(Action::Remove) > 0) remove_looked_at(simulation);
    if (const auto why = grab_.pull(simulation, aim())) say(*why);
}

ecs::Entity PlaygroundGame::thing_to(std::string_view verb, const scene::Simulation& simulation) {
    if (simulation.registry.alive(grab_.entity())) return grab_.entity();
    const auto looked = looked_at(simulation, aim(), kRemoveReach_m);
    const Real reach_m = sight_m(looked, aim(), kRemoveReach_m);
    if (const auto soft = soft_looked_at(simulation, aim(), static_cast<double>(reach_m)))
        return soft->entity;
    const bool movable = looked && simulation.registry.alive(looked->entity) &&
                         simulation.physics.state(looked->body).kind == physics::BodyKind::Dynamic;
    if (movable) return is_guarded(looked->entity) ? ecs::Entity{} : looked->entity;
    say(fmt::format("nothing to {}", verb));
    return {};
}

void PlaygroundGame::freeze(scene::Simulation& simulation) {
    const ecs::Entity entity = thing_to("freeze", simulation);
    if (!simulation.registry.alive(entity)) return;
    if (grab_.holding()) grab_.release(simulation);
    bool freezes = true;
    if (physics::Deformable* soft = deformable_of(simulation, entity)) {
        freezes = !soft->is_frozen();
        soft->set_frozen(freezes);
    } else {
        const physics::BodyId body = simulation.registry.get<scene::BodyRef>(entity).body;
        freezes = !simulation.physics.state(body).frozen;
        simulation.physics.set_frozen(body, freezes);
    }
    say(freezes ? "frozen" : "unfrozen");
}

void PlaygroundGame::tie(scene::Simulation& simulation, const Actions& actions) {
    for (int i = 0; i < actions.presses(Action::Tie); ++i) {
        const std::size_t ropes = simulation.ropes().size();
        say(tying_.press(simulation, aim()));
        if (simulation.ropes().size() > ropes)
            things_.number(simulation, simulation.ropes().back());
    }
}

void PlaygroundGame::remove_looked_at(scene::Simulation& simulation) {
    const ecs::Entity entity = thing_to("delete", simulation);
    if (!simulation.registry.alive(entity)) return;
    if (grab_.holding()) grab_.release(simulation);
    destroy(simulation, entity);
    forget_gone(simulation);
}

scene::HudContent PlaygroundGame::hud(const scene::Simulation& simulation) {
    scene::HudContent content;
    content.crosshair = mode_ != MoveMode::Orbit && !views_scene() && !pointer_;
    if (keys_.throw_s >= 0) content.charge = charge_after(keys_.throw_s);
    if (!views_model() && !views_scene()) content.chosen_thing = std::string(things_.chosen_name());
    if (const auto weighed = weighed_in_sight(simulation, aim())) {
        const std::string words = words_of(simulation.registry.get<scene::Name>(weighed->entity));
        content.looking_at =
            fmt::format("{}{}{:.3g} kg", words, words.empty() ? "" : ", ", weighed->mass_kg);
    }
    content.plaque = plaque_before(simulation, aim());
    content.use = use_words(simulation, use_at(simulation, aim()));
    if (goal_) content.goal = goal_->state(simulation);
    content.messages = std::move(messages_);
    messages_.clear();
    return content;
}

}  // namespace plumbline::game
