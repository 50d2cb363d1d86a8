#include "game/rules/hands/things.h"

#include "engine/physics/query.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/shape_factory.h"
#include "engine/scene/level/shipped_things.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "game/components.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace plumbline::game {

const std::array<std::string_view, kThingCount> kThingNames{
    "crate", "ball", "barrel", "brick", "plank", "stone", "domino"};

namespace {

constexpr Real kDeepestFall_m = 30;  // that a preview follows

std::string_view name_of_kind(std::size_t kind) {
    return kind < kThingCount ? kThingNames[kind] : "shot";
}

struct Plain {
    scene::Primitive primitive;
    Real mass_kg;
    std::string_view surface;
    Vec3f color;
    Real restitution;
};

Plain plain_thing(std::size_t index) {
    using physics::BoxShape;
    using physics::CylinderShape;
    using physics::SphereShape;
    const std::array<Plain, kThingCount + 1> things{
        {{BoxShape{{0.8_r, 0.8_r, 0.8_r}}, 30, "wood", {0.5F, 0.33F, 0.18F}, 0.1_r},
         {SphereShape{0.12_r}, 0.6_r, "rubber", {0.75F, 0.2F, 0.1F}, 0.7_r},
         {CylinderShape{0.3_r, 0.88_r}, 35, "metal", {0.12F, 0.25F, 0.45F}, 0.2_r},
         {BoxShape{{0.24_r, 0.07_r, 0.115_r}}, 3.5_r, "brick", {0.5F, 0.16F, 0.1F}, 0.1_r},
         {BoxShape{{2.4_r, 0.04_r, 0.2_r}}, 13, "wood", {0.6F, 0.45F, 0.27F}, 0.2_r},
         {SphereShape{0.15_r}, 35, "stone", {0.4F, 0.4F, 0.38F}, 0.1_r},
         {BoxShape{{0.5_r, 1, 0.12_r}}, 20, "wood", {0.85F, 0.82F, 0.75F}, 0.1_r},
         {BoxShape{{1, 1, 1}}, 1, "wood", {0.13F, 0.0F, 0.13F}, 0}}};
    return things[index];
}

/// A lump of stone: an uneven ball.
physics::HullShape stone_hull() {
    return {{{0.16_r, 0.02_r, 0.03_r},
             {-0.15_r, -0.01_r, 0.05_r},
             {0.02_r, 0.12_r, -0.02_r},
             {-0.03_r, -0.11_r, 0.01_r},
             {0.04_r, 0.01_r, 0.16_r},
             {-0.02_r, 0.03_r, -0.15_r},
             {0.1_r, 0.08_r, 0.08_r},
             {-0.09_r, 0.08_r, -0.07_r},
             {0.1_r, -0.09_r, -0.06_r},
             {-0.08_r, -0.09_r, 0.09_r}}};
}

Thing make_plain(std::size_t index) {
    const Plain plain = plain_thing(index);
    Thing thing;
    thing.description.name = std::string(name_of_kind(index));
    thing.description.visual = plain.primitive;
    scene::BodyDescription body;
    if (thing.description.name == "stone") body.shape = physics::ShapeDef{stone_hull()};
    body.mass_kg = plain.mass_kg;
    body.restitution = plain.restitution;
    if (thing.description.name == "ball") body.rolling_friction = 0.002_r;
    thing.description.body = body;
    thing.description.material = fmt::format("{} (plain)", thing.description.name);
    thing.material = assets::MaterialData{.name = thing.description.material,
                                          .base_color = plain.color,
                                          .surface = std::string(plain.surface)};
    return thing;
}

/// What was put into the world and is there, by when: the oldest first. Of what broke, its parts.
using PutThings = std::map<std::uint64_t, std::vector<ecs::Entity>>;

PutThings put_things(const scene::Simulation& simulation) {
    PutThings there;
    for (auto [entity, dropped, ref] :
         simulation.registry.view<const scene::Dropped, const scene::BodyRef>())
        there[dropped.serial].push_back(entity);
    return there;
}

}  // namespace

void destroy(scene::Simulation& simulation, ecs::Entity entity) {
    if (!simulation.registry.alive(entity)) return;
    if (const auto* ref = simulation.registry.find<scene::BodyRef>(entity)) {
        if (simulation.physics.contains(ref->body)) simulation.physics.wake(ref->body);
    }
    simulation.registry.destroy(entity);
}

Things::Things(scene::Simulation& simulation, const std::filesystem::path& assets_folder) {
    const scene::SceneDescription& scene = simulation.description();
    const bool incomplete = std::any_of(kThingNames.begin(), kThingNames.end(), [&](auto name) {
        return !scene.prefabs.contains(std::string(name));
    });
    const scene::SceneDescription shipped =
        incomplete ? scene::shipped_things(assets_folder) : scene::SceneDescription{};
    simulation.builder().lend_materials(shipped.materials);
    for (std::size_t i = 0; i < kKinds; ++i) {
        const std::string name(name_of_kind(i));
        if (const auto own = scene.prefabs.find(name); own != scene.prefabs.end()) {
            things_[i].description = scene::thing_of(own->second, name);
        } else if (const auto known = shipped.prefabs.find(name); known != shipped.prefabs.end()) {
            things_[i].description = scene::thing_of(known->second, name);
        } else {
            things_[i] = make_plain(i);
        }
        measure(simulation, i);
        if (!things_[i].material) continue;
        // Friction of what the scene does not know comes from here: the builder cannot look it up.
        const scene::SurfaceTable& surfaces = simulation.surfaces();
        const scene::Surface& surface = surfaces.get(surfaces.find(things_[i].material->surface));
        scene::BodyDescription& body = *things_[i].description.body;
        if (!body.friction) body.friction = surface.friction;
        if (!body.restitution) body.restitution = surface.restitution;
        if (!body.mass_kg && !body.density_kgpm3) body.density_kgpm3 = surface.density_kgpm3;
    }
}

void Things::choose(std::size_t index) {
    if (index < kThingCount) chosen_ = index;
}

void Things::choose_next(int steps) {
    const int count = static_cast<int>(kThingCount);
    const int next = ((static_cast<int>(chosen_) + steps) % count + count) % count;
    chosen_ = static_cast<std::size_t>(next);
}

void Things::dress(scene::Simulation& simulation, ecs::Entity entity, const Thing& thing) const {
    simulation.registry.add<scene::Dropped>(entity, serial_);
    if (!thing.material) return;
    const assets::MaterialId material = simulation.library().add_material(*thing.material);
    if (auto* visual = simulation.registry.find<scene::Visual>(entity)) {
        std::fill(visual->materials.begin(), visual->materials.end(), material);
    }
    const std::uint16_t surface = simulation.surfaces().find(thing.material->surface);
    if (auto* ref = simulation.registry.find<scene::SurfaceRef>(entity)) ref->surface = surface;
}

void Things::measure(scene::Simulation& simulation, std::size_t kind) {
    Thing& thing = things_[kind];
    const scene::EntityDescription& description = thing.description;
    std::optional<physics::ShapeDef> shape;
    if (const auto* own = std::get_if<physics::ShapeDef>(&description.body->shape)) shape = *own;
    const auto* primitive = std::get_if<scene::Primitive>(&description.visual);
    if (!shape && primitive != nullptr) shape = scene::shape_of_primitive(*primitive);
    if (!shape) return;
    Vec3 low{};
    Vec3 high{};
    scene::bounds_of(scene::scaled(*shape, description.scale), low, high);
    set_size(simulation, kind, high - low);
}

void Things::set_size(scene::Simulation& simulation, std::size_t kind, const Vec3& size_m) {
    const auto box = simulation.physics.create_shape(physics::BoxShape{size_m});
    if (!box) return;
    things_[kind].size_m = size_m;
    boxes_[kind] = *box;
}

std::optional<Vec3> Things::place_for(const physics::PhysicsWorld& world,
                                      const Aim& aim,
                                      const Room& room,
                                      bool is_dropped) const {
    // What is dropped goes where the eye looks; where that is far, or nowhere, it falls before the feet.
    const physics::QueryFilter sight{.ignored = room.itself, .also_ignored = aim.own_body};
    const bool is_seen =
        is_dropped &&
        cast_ray(world, aim.eye_m, aim.eye_m + aim.forward * kDropReach_m, sight).has_value();
    return free_place(world, aim, room, is_seen ? kDropReach_m : kReach_m);
}

std::optional<Placed> Things::preview(const scene::Simulation& simulation, const Aim& aim) const {
    const Thing& thing = things_[chosen_];
    if (!thing.size_m) return {};
    const physics::PhysicsWorld& world = simulation.physics;
    const Room room{.box = boxes_[chosen_], .size_m = *thing.size_m};
    const auto place = place_for(world, aim, room, true);
    if (!place) return {};
    Placed placed{
        .world_from_box = {.position = *place,
                           .orientation = portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0})},
        .size_m = room.size_m};
    const Vec3 deep = *place - Vec3{0, kDeepestFall_m, 0};
    const auto ground =
        physics::sweep(world, room.box, placed.world_from_box, deep, {.ignored = aim.own_body});
    if (ground) placed.world_from_box.position = glm::mix(*place, deep, ground->fraction);
    return placed;
}

Result<ecs::Entity> Things::put(scene::Simulation& simulation,
                                const Aim& aim,
                                const Vec3& velocity,
                                std::size_t kind) {
    Thing& thing = things_[kind];
    scene::EntityDescription description = thing.description;
    // It appears level and turned as the person looks; its size is known once one exists.
    const Quat turn = portable_angle_axis(aim.yaw_rad, Vec3{0, 1, 0});
    description.world_from_body = {.position = aim.eye_m};
    description.body->velocity_mps = velocity;
    const ecs::Entity entity = simulation.spawn(description);
    if (!simulation.registry.alive(entity)) {
        return Error{fmt::format("cannot create a {}", name_of_kind(kind))};
    }
    const physics::BodyId body = simulation.registry.get<scene::BodyRef>(entity).body;
    Vec3 low{};
    Vec3 high{};
    physics::bounds(simulation.physics, body, low, high);
    if (!thing.size_m) set_size(simulation, kind, high - low);
    const Vec3 middle = (low + high) * 0.5_r - aim.eye_m;
    const Room room{
        .box = boxes_[kind], .size_m = thing.size_m.value_or(high - low), .itself = body};
    const bool is_dropped = velocity == Vec3{0, 0, 0};
    const auto place =
        room.box ? place_for(simulation.physics, aim, room, is_dropped) : std::nullopt;
    if (!place) {
        destroy(simulation, entity);
        return Error{fmt::format("no room for a {}", name_of_kind(kind))};
    }
    const Pose pose{.position = *place - turn * middle, .orientation = turn};
    simulation.physics.set_pose(body, pose);
    simulation.registry.get<scene::Transform>(entity).world_from_body = pose;
    if (auto* previous = simulation.registry.find<scene::PreviousTransform>(entity)) {
        previous->world_from_body = pose;
    }
    ++serial_;
    dress(simulation, entity, thing);
    return entity;
}

void Things::number(scene::Simulation& simulation, const scene::Rope& rope) {
    ++serial_;
    for (const physics::BodyId piece : rope.pieces) {
        const ecs::Entity entity = scene::entity_of(simulation, piece);
        simulation.registry.get<scene::Dropped>(entity).serial = serial_;
    }
}

ecs::Entity Things::make_again(scene::Simulation& simulation,
                               const std::string& kind,
                               const std::string& name) {
    const auto known = std::ranges::find_if(
        things_, [&](const Thing& thing) { return thing.description.name == kind; });
    if (known == things_.end()) return {};
    const ecs::Entity entity = simulation.respawn(known->description, name);
    if (simulation.registry.alive(entity)) dress(simulation, entity, *known);
    return entity;
}

bool Things::undo(scene::Simulation& simulation) {
    const PutThings there = put_things(simulation);
    if (there.empty()) return false;
    for (const ecs::Entity entity : there.rbegin()->second) destroy(simulation, entity);
    return true;
}

bool Things::keep_limit(scene::Simulation& simulation) {
    const PutThings there = put_things(simulation);
    if (there.size() <= kMost) return false;
    // The oldest that sleeps, else the oldest; never what is in the hand.
    const auto may_go = [&](ecs::Entity entity) { return !simulation.registry.has<Held>(entity); };
    const auto sleeps = [&](ecs::Entity entity) {
        return may_go(entity) &&
               !simulation.physics.state(simulation.registry.get<scene::BodyRef>(entity).body)
                    .awake;
    };
    const auto first = [&](const auto& all_are) {
        return std::ranges::find_if(
            there, [&](const auto& one) { return std::ranges::all_of(one.second, all_are); });
    };
    auto oldest = first(sleeps);
    if (oldest == there.end()) oldest = first(may_go);
    if (oldest == there.end()) return false;
    for (const ecs::Entity entity : oldest->second) destroy(simulation, entity);
    return !std::exchange(limit_told_, true);
}

}  // namespace plumbline::game
