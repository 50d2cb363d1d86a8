#include "game/rules/goal.h"

#include "engine/scene/goal_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::game {
namespace {

constexpr double kLastThrow_s = 6.0;  // for the last thing thrown to do its work

bool is_within(const scene::Region& region, const Vec3& point_m) {
    return glm::all(glm::greaterThanEqual(point_m, region.min_m)) &&
           glm::all(glm::lessThanEqual(point_m, region.max_m));
}

std::vector<ecs::Entity> things_of(const scene::Simulation& simulation,
                                   const scene::GoalDescription& goal) {
    std::vector<ecs::Entity> things;
    for (auto [entity, name, body] :
         simulation.registry.view<const scene::Name, const scene::BodyRef>()) {
        const std::string& text = name.text;
        const auto meant = [&](const std::string& wanted) {
            return scene::matches_pattern(text, wanted);
        };
        if (std::ranges::any_of(goal.things, meant)) things.push_back(entity);
    }
    return things;
}

}  // namespace

Goal::Goal(const scene::Simulation& simulation)
    : goal_(*simulation.description().goal),
      things_(things_of(simulation, goal_)),
      wanted_(goal_.count > 0 ? goal_.count : static_cast<int>(things_.size())) {}

double Goal::passed_s(const scene::Simulation& simulation) const {
    return start_s_ ? simulation.time_s() - *start_s_ : 0.0;
}

void Goal::begin(const scene::Simulation& simulation) {
    if (!start_s_) start_s_ = simulation.time_s();
}

std::optional<std::string> Goal::refusal() const {
    if (end_ != scene::GoalEnd::Open || !goal_.throws || thrown_ < *goal_.throws) return {};
    return "no throws left";
}

void Goal::count_throw(const scene::Simulation& simulation) {
    begin(simulation);
    ++thrown_;
    last_throw_s_ = simulation.time_s();
}

bool Goal::guards(ecs::Entity entity) const {
    return goal_.hands_off && std::ranges::find(things_, entity) != things_.end();
}

bool Goal::counts(const scene::Simulation& simulation, ecs::Entity thing) const {
    const auto* place = simulation.registry.find<scene::Transform>(thing);
    if (place == nullptr) return !goal_.inside;
    const auto* body = simulation.registry.find<scene::BodyRef>(thing);
    if (goal_.inside && body != nullptr && simulation.physics.state(body->body).frozen)
        return false;  // it is held there
    const Vec3 at_m = place->world_from_body.position;
    if (goal_.below_m) return at_m.y < *goal_.below_m;
    return goal_.inside ? is_within(*goal_.inside, at_m) : !is_within(*goal_.outside, at_m);
}

std::string Goal::end(scene::GoalEnd how, double at_s) {
    end_ = how;
    ended_s_ = at_s;
    if (how == scene::GoalEnd::Won) return fmt::format("won in {:.1f} s", at_s);
    return fmt::format("lost: {} of {}", counted_, wanted_);
}

std::optional<double> Goal::won_in_s() const {
    if (end_ != scene::GoalEnd::Won) return {};
    return ended_s_;
}

std::optional<std::string> Goal::judge(const scene::Simulation& simulation, ecs::Entity in_hand) {
    if (end_ != scene::GoalEnd::Open) return {};
    counted_ = goal_.triggers
                   ? simulation.counted
                   : static_cast<int>(std::ranges::count_if(things_, [&](ecs::Entity thing) {
                         return thing != in_hand && counts(simulation, thing);
                     }));
    const double now_s = simulation.time_s();
    if (counted_ > 0) begin(simulation);
    if (counted_ < wanted_) {
        reached_s_.reset();
    } else if (!reached_s_) {
        reached_s_ = now_s;
    }
    if (reached_s_) {  // after the end of the time too: it may hold
        if (now_s - *reached_s_ < goal_.holds_s) return {};
        return end(scene::GoalEnd::Won, *reached_s_ - *start_s_);
    }
    const bool is_over = goal_.within_s && passed_s(simulation) >= *goal_.within_s;
    const bool none_left =
        goal_.throws && thrown_ >= *goal_.throws && now_s - last_throw_s_ >= kLastThrow_s;
    if (is_over || none_left) return end(scene::GoalEnd::Lost, passed_s(simulation));
    return {};
}

scene::GoalState Goal::state(const scene::Simulation& simulation) const {
    scene::GoalState state{
        .text = goal_.text,
        .counted = counted_,
        .wanted = wanted_,
        .end = end_,
        .passed_s = end_ == scene::GoalEnd::Open ? passed_s(simulation) : ended_s_};
    if (end_ == scene::GoalEnd::Open && reached_s_)
        state.holds_for_s = std::max(0.0, goal_.holds_s - (simulation.time_s() - *reached_s_));
    if (goal_.within_s) state.left_s = std::max(0.0, *goal_.within_s - state.passed_s);
    if (goal_.throws) state.throws_left = std::max(0, *goal_.throws - thrown_);
    return state;
}

}  // namespace plumbline::game
