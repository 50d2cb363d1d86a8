// Bodies of a running scene that break.
#include "engine/physics/medium.h"
#include "engine/scene/build/entity_builder.h"
#include "engine/scene/build/fragments.h"
#include "engine/scene/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace plumbline::scene {
namespace {

/// Bodies as one.
struct Together {
    double mass_kg{0};
    Vec3d center_m{0, 0, 0};
    glm::dmat3 inertia_kgm2{0.0};  ///< about the centre, world axes
};

glm::dmat3 inertia_of(const physics::PhysicsWorld& world, physics::BodyId body) {
    const glm::dmat3 axes = glm::mat3_cast(physics::world_from_mass(world, body));
    const Vec3d moments(world.state(body).mass.inertia_kgm2);
    return axes * glm::dmat3{moments.x, 0, 0, 0, moments.y, 0, 0, 0, moments.z} *
           glm::transpose(axes);
}

Together together(const physics::PhysicsWorld& world, std::span<const physics::BodyId> bodies) {
    Together sum;
    for (const physics::BodyId body : bodies) {
        const physics::BodyState state = world.state(body);
        const auto mass_kg = static_cast<double>(state.mass.mass_kg);
        sum.mass_kg += mass_kg;
        sum.center_m += mass_kg * Vec3d(state.center_of_mass_world());
    }
    sum.center_m /= sum.mass_kg;
    for (const physics::BodyId body : bodies) {
        const physics::BodyState state = world.state(body);
        const Vec3d arm_m = Vec3d(state.center_of_mass_world()) - sum.center_m;
        sum.inertia_kgm2 +=
            inertia_of(world, body) +
            static_cast<double>(state.mass.mass_kg) *
                (glm::dot(arm_m, arm_m) * glm::dmat3{1.0} - glm::outerProduct(arm_m, arm_m));
    }
    return sum;
}

/// The parts go on as `whole` moves: with its centre, momentum and angular momentum, also where their moments are not quite its
/// own, as those of round bodies are not.
void move_as(physics::PhysicsWorld& world,
             physics::BodyId whole,
             std::span<const physics::BodyId> parts) {
    const physics::BodyState state = world.state(whole);
    const Vec3d spun_radps(state.angular_velocity_radps);
    const Vec3d center_m(state.center_of_mass_world());
    const Vec3d drift_mps =
        Vec3d(state.velocity_mps) +
        glm::cross(spun_radps, center_m - Vec3d(state.world_from_body.position));
    const Together all = together(world, parts);
    const Vec3d spin_radps =
        glm::inverse(all.inertia_kgm2) * (inertia_of(world, whole) * spun_radps);
    for (const physics::BodyId part : parts) {
        Pose pose = world.state(part).world_from_body;
        const Vec3d arm_m = Vec3d(pose.position) - all.center_m;
        pose.position = Vec3(center_m + arm_m);
        world.set_pose(part, pose);
        world.set_velocity(part, Vec3(drift_mps + glm::cross(spin_radps, arm_m)), Vec3(spin_radps));
    }
}

}  // namespace

std::span<const std::unique_ptr<FragileWhole>> Simulation::wholes() const {
    return bodies_.wholes;
}

void Simulation::add_whole(const EntityDescription& description,
                           const std::string& name,
                           ecs::Entity entity) {
    const FractureDescription& says = *description.body->fracture;
    const physics::BodyId body = registry.get<BodyRef>(entity).body;
    auto whole = std::make_unique<FragileWhole>();
    whole->name = name;
    whole->description = description;
    whole->pattern = physics::fracture_pattern(physics, body, says.pieces, says.seed);
    const std::size_t pieces = whole->pattern.pieces.size();
    const auto warn = [&](const std::string& what) {
        warnings.push_back(
            fmt::format("{}: entity {}: {}", to_string(description.location), name, what));
    };
    if (pieces < 2) return warn("it is no single convex solid of some size and does not break");
    if (pieces < says.pieces)
        warn(fmt::format("it is too small for {} pieces: cut into {}", says.pieces, pieces));
    const auto mass_kg = static_cast<double>(physics.state(body).mass.mass_kg);
    whole->density_kgpm3 = mass_kg / whole->pattern.volume_m3;
    whole->surface = registry.get<SurfaceRef>(entity).surface;
    Fragile fragile{.whole = static_cast<std::uint32_t>(bodies_.wholes.size())};
    fragile.pieces.resize(pieces);
    std::iota(fragile.pieces.begin(), fragile.pieces.end(), 0U);
    registry.add<Fragile>(entity, std::move(fragile));
    bodies_.wholes.push_back(std::move(whole));
}

void Simulation::note_look(ecs::Entity entity) {
    const auto* fragile = registry.find<Fragile>(entity);
    const auto* visual = registry.find<Visual>(entity);
    if (fragile != nullptr && visual != nullptr)
        bodies_.wholes[fragile->whole]->materials = visual->materials;
}

Result<ecs::Entity> Simulation::make_fragment(EntityDescription description,
                                              const std::string& name,
                                              Fragile fragile) {
    const FragileWhole& whole = *bodies_.wholes[fragile.whole];
    const Surface& surface = surfaces_.get(whole.surface);
    description.body->friction = description.body->friction.value_or(surface.friction);
    description.body->restitution = description.body->restitution.value_or(surface.restitution);
    Result<ecs::Entity> made = builder_->build(description, name);
    if (!made) return made;
    registry.get<SurfaceRef>(*made).surface = whole.surface;
    if (!whole.materials.empty()) registry.get<Visual>(*made).materials = {whole.materials.front()};
    registry.add<Spawned>(*made, Spawned{.description = whole.description.name});
    registry.add<Fragile>(*made, std::move(fragile));
    return made;
}

void Simulation::break_up(ecs::Entity entity,
                          std::span<const std::vector<std::uint32_t>> parts,
                          const std::vector<std::uint32_t>& cracked) {
    const Fragile was = registry.get<Fragile>(entity);
    FragileWhole& whole = *bodies_.wholes[was.whole];
    const physics::BodyId body = registry.get<BodyRef>(entity).body;
    const physics::BodyState state = physics.state(body);
    const Quatd turned(state.world_from_body.orientation);
    const Vec3d origin_m = origin_of(whole.pattern, was.pieces);
    note_look(entity);
    std::vector<ecs::Entity> made;
    std::vector<physics::BodyId> bodies;
    for (const std::vector<std::uint32_t>& pieces : parts) {
        const Vec3d at_m = origin_of(whole.pattern, pieces);
        EntityDescription part = fragment_of(whole, pieces);
        part.world_from_body.position =
            state.world_from_body.position + Vec3(turned * (at_m - origin_m));
        part.world_from_body.orientation = state.world_from_body.orientation;
        const std::string name = fmt::format("{}/{}", whole.name, whole.next_part++);
        Result<ecs::Entity> one = make_fragment(
            std::move(part), name, {.whole = was.whole, .pieces = pieces, .cracked = cracked});
        if (!one) {
            warnings.push_back(one.error().message);
            continue;
        }
        if (const auto* dropped = registry.find<Dropped>(entity))
            registry.add<Dropped>(*one, Dropped{.serial = dropped->serial});
        made.push_back(*one);
        bodies.push_back(registry.get<BodyRef>(*one).body);
    }
    if (made.empty()) return;
    move_as(physics, body, bodies);
    if (!whole.broke_at_s) whole.broke_at_s = time_s();
    bursts.push_back({.kind = Burst::Kind::Break,
                      .point_world = state.world_from_body.position,
                      .strength = static_cast<double>(state.mass.mass_kg),
                      .surface = whole.surface});
    hand_over(body, made);
    registry.mark_for_destruction(entity);
}

/// What holds the body holds the part that is nearest to it.
void Simulation::hand_over(physics::BodyId body, std::span<const ecs::Entity> parts) {
    const auto part_at = [&](const Vec3& point_world) {
        const auto away = [&](ecs::Entity part) {
            const Fragile& fragile = registry.get<Fragile>(part);
            const physics::FracturePattern& pattern = bodies_.wholes[fragile.whole]->pattern;
            const Pose& pose = registry.get<Transform>(part).world_from_body;
            const Vec3d point_m = Vec3d(transform_point(invert(pose), point_world)) +
                                  origin_of(pattern, fragile.pieces);
            const std::uint32_t piece = pattern.piece_at(point_m, fragile.pieces);
            return glm::distance(pattern.pieces[piece].seed_m, point_m);
        };
        return registry.get<BodyRef>(*std::ranges::min_element(parts, {}, away)).body;
    };
    const Pose was = physics.state(body).world_from_body;
    const auto moved_to = [&](physics::BodyId next, const Vec3& anchor_m) {
        return transform_point(invert(physics.state(next).world_from_body),
                               transform_point(was, anchor_m));
    };
    std::vector<SceneJoint*> by_b;
    for (SceneJoint& joint : bodies_.joints) {
        if (physics.contains(joint.joint) && physics.joint(joint.joint).def.b == body)
            by_b.push_back(&joint);
    }
    physics::hand_over_joints(physics, body, part_at);
    for (SceneJoint* joint : by_b)
        joint->anchor_b_body = moved_to(physics.joint(joint->joint).def.b, joint->anchor_b_body);
    for (SceneJoint& joint : bodies_.joints) {
        if (!physics.contains(joint.joint)) continue;
        const physics::BodyId a = physics.joint(joint.joint).def.a;
        if (a == joint.a || joint.a != body) continue;
        joint.anchor_a_body = moved_to(a, joint.anchor_a_body);
        joint.a = a;
    }
    for (Rope& rope : bodies_.ropes) {
        for (std::size_t end = 0; end < rope.ends.size(); ++end) {
            if (rope.ends[end] != body) continue;
            rope.ends[end] = part_at(transform_point(was, rope.anchors_m[end]));
            rope.anchors_m[end] = moved_to(rope.ends[end], rope.anchors_m[end]);
        }
    }
    for (Vehicle& vehicle : bodies_.vehicles) {
        if (vehicle.chassis == body) vehicle.chassis = part_at(was.position);
    }
}

}  // namespace plumbline::scene
