// The use key, and the outlines of what hands would take, use and put.
#include "engine/scene/extract.h"
#include "game/rules/rules.h"

#include <array>

namespace plumbline::game {

namespace {

constexpr Vec3f kTaken{0.9F, 0.9F, 0.9F};
constexpr Vec3f kUsed{1.0F, 0.65F, 0.15F};
constexpr Vec3f kPlaced{0.25F, 0.75F, 1.0F};
constexpr float kOutlineAir_m = 0.01F;  // between a thing and its outline
constexpr float kCornerShare = 0.25F;   // of an edge, at either end

struct BoxEdge {
    Vec3f from;
    Vec3f to;
};

/// The edges of a box about the origin.
std::array<BoxEdge, 12> edges_of(const Vec3f& half) {
    std::array<BoxEdge, 12> edges{};
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float u : {-1.0F, 1.0F}) {
            for (const float v : {-1.0F, 1.0F}) {
                Vec3f from = half;
                from[axis] *= -1.0F;
                from[(axis + 1) % 3] *= u;
                from[(axis + 2) % 3] *= v;
                Vec3f to = from;
                to[axis] = half[axis];
                edges[count++] = {from, to};
            }
        }
    }
    return edges;
}

void add_line(LineList& lines, const Pose& pose, const BoxEdge& edge, const Vec3f& color) {
    const Vec3 from = transform_point(pose, Vec3(edge.from));
    const Vec3 to = transform_point(pose, Vec3(edge.to));
    lines.add(Vec3f(from), Vec3f(to), color);
}

/// The corners of the box round what is seen of an entity.
void add_corners(const scene::Simulation& simulation,
                 ecs::Entity entity,
                 Real blend,
                 const Vec3f& color,
                 LineList& lines) {
    const auto* visual = simulation.registry.find<scene::Visual>(entity);
    const auto* transform = simulation.registry.find<scene::Transform>(entity);
    if (visual == nullptr || transform == nullptr) return;
    const Aabb bounds = simulation.library().mesh(visual->mesh).bounds;
    const Vec3f scale(transform->scale);
    const Vec3f middle = (bounds.min + bounds.max) * 0.5F * scale;
    const Vec3f half = glm::abs((bounds.max - bounds.min) * 0.5F * scale) + kOutlineAir_m;
    const Pose pose = scene::drawn_pose(simulation, entity, *transform, blend);
    for (const BoxEdge& edge : edges_of(half)) {
        const Vec3f from = edge.from + middle;
        const Vec3f to = edge.to + middle;
        const Vec3f part = (to - from) * kCornerShare;
        add_line(lines, pose, {from, from + part}, color);
        add_line(lines, pose, {to, to - part}, color);
    }
}

bool may_be_taken(const scene::Simulation& simulation, const Looked& looked) {
    if (!simulation.registry.alive(looked.entity)) return false;
    const physics::BodyState state = simulation.physics.state(looked.body);
    return state.pushable() && state.mass.mass_kg <= Grab::kMostMass_kg;
}

physics::BodyId seat_of(const scene::Simulation& simulation, ecs::Entity entity) {
    return simulation.registry.get<scene::BodyRef>(entity).body;
}

}  // namespace

PlaygroundGame::Use PlaygroundGame::use_at(const scene::Simulation& simulation,
                                           const Aim& aim) const {
    if (views_model() || views_scene() || mode_ == MoveMode::Orbit) return {};
    const auto looked = looked_at(simulation, aim, Grab::kReach_m);
    if (const ecs::Entity lamp = lamp_at(simulation, aim, looked))
        return {.lamp = lamp, .entity = lamp};
    if (!looked || !simulation.registry.alive(looked->entity)) return {};
    if (goal_ && goal_->guards(looked->entity)) return {};
    if (const auto door = door_at(simulation, *looked, aim.eye_m))
        return {.door = door, .entity = looked->entity};
    if (mode_ != MoveMode::Walk || player_->sits()) return {};
    if (const auto drive = driver_seat_at(simulation, *looked, player_->body()))
        return {.drive = drive, .entity = looked->entity};
    if (const auto seat = player_->seat_at(simulation, *looked))
        return {.seat_m = seat, .entity = looked->entity};
    return {};
}

std::string PlaygroundGame::use_words(const scene::Simulation& simulation, const Use& use) const {
    if (driver_.drives()) return "get off";
    if (use.lamp) return is_lit(simulation, use.lamp) ? "switch off" : "switch on";
    if (use.door) return use.door->opens ? "open" : "close";
    if (use.drive) return "drive";
    if (use.seat_m) return "sit down";
    return player_ && player_->sits() ? "stand up" : "";
}

void PlaygroundGame::use(scene::Simulation& simulation, const Actions& actions) {
    if (actions.presses(Action::Use) > 0) {
        const Use use = driver_.drives() ? Use{} : use_at(simulation, aim());
        if (use.lamp) {
            switch_lamp(simulation, use.lamp, !is_lit(simulation, use.lamp));
        } else if (use.door) {
            doors_.swing(*use.door);
        } else if (use.drive) {
            player_->sit(use.drive->seat_m, {}, true);
            driver_.take(use.drive->vehicle);
        } else if (use.seat_m) {
            player_->sit(*use.seat_m, seat_of(simulation, use.entity));
        } else if (player_ && player_->sits()) {
            player_->stand_up();
        } else {
            say("nothing to use");
        }
    }
    if (player_ && !player_->sits()) driver_.leave(simulation);
    driver_.act(simulation, actions);
    doors_.push(simulation, grab_.body());
}

void PlaygroundGame::add_lines(const scene::Simulation& simulation,
                               Real blend,
                               LineList& lines) const {
    if (mode_ == MoveMode::Orbit || views_scene() || pointer_ || grab_.holding()) return;
    const Aim now = aim();
    const Use use = use_at(simulation, now);
    const auto looked = looked_at(simulation, now, Grab::kReach_m);
    if (use.entity) {
        add_corners(simulation, use.entity, blend, kUsed, lines);
    } else if (looked && may_be_taken(simulation, *looked)) {
        add_corners(simulation, looked->entity, blend, kTaken, lines);
    }
    if (const auto from_m = tying_.first_end_m(simulation)) {
        const auto end = looked_at(simulation, now, Tying::kReach_m);
        const Vec3 to_m = end ? end->point_m : now.eye_m + now.forward * Grab::kReach_m;
        lines.add(Vec3f(*from_m), Vec3f(to_m), kPlaced);
    }
    if (dropping_.preview_left_s <= 0) return;
    const auto placed = things_.preview(simulation, now);
    if (!placed) return;
    for (const BoxEdge& edge : edges_of(Vec3f(placed->size_m) * 0.5F))
        add_line(lines, placed->world_from_box, edge, kPlaced);
}

}  // namespace plumbline::game
