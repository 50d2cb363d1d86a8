// Motions, colliders and triggers of glTF files as entities.
#include "engine/core/limits.h"
#include "engine/scene/build/shape_factory.h"
#include "engine/scene/gltf_scene/gltf_scene_impl.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace plumbline::scene {
namespace {

using physics::BodyKind;
using physics::CombineRule;

// What stands for infinity: heavier than anything that could push it.
constexpr double kImmovable_kg = limits::kMassMax_kg;
constexpr double kUnturnable_kgm2 = 1e9;
constexpr double kFrictionsDiffer = 0.05;

CombineRule rule_of(assets::CombineMode mode) {
    switch (mode) {
        case assets::CombineMode::Average:
            return CombineRule::Average;
        case assets::CombineMode::Minimum:
            return CombineRule::Minimum;
        case assets::CombineMode::Maximum:
            return CombineRule::Maximum;
        case assets::CombineMode::Multiply:
            break;
    }
    return CombineRule::Multiply;
}

struct BodyMaker {
    GltfScene& gltf;
    const VisualDescription& visual;
    std::set<std::string> names{};
    std::vector<std::string> groups{};  ///< by filter
    std::vector<std::string> named{};   ///< by motion: its entity; empty where that has no body
    std::vector<std::vector<const assets::ModelCollider*>> of_motion{};

    const assets::ModelPhysics& physics() const { return gltf.model.physics; }

    /// Of the node's own, one that no other entity has.
    std::string name_for(std::uint32_t node) {
        const std::string& given = gltf.model.nodes[node].name;
        const std::string base = is_good_name(given) ? given : fmt::format("node {}", node);
        std::string name = base;
        for (int i = 2; !names.insert(name).second; ++i) name = fmt::format("{} ({})", base, i);
        return name;
    }

    EntityDescription entity_at(std::uint32_t node) {
        EntityDescription entity;
        entity.name = name_for(node);
        entity.world_from_body = pose_of(gltf.places[node]);
        entity.location = gltf.location;
        return entity;
    }

    /// Where a file shows nothing at all, its colliders are seen.
    VisualDescription seen_of(std::size_t body, const physics::ShapeDef& shape) const {
        if (!gltf.model.mesh.indices.empty()) return part_of(body);
        if (const auto* box = std::get_if<physics::BoxShape>(&shape)) return Primitive{*box};
        if (const auto* ball = std::get_if<physics::SphereShape>(&shape)) return Primitive{*ball};
        if (const auto* it = std::get_if<physics::CylinderShape>(&shape)) return Primitive{*it};
        if (const auto* it = std::get_if<physics::CapsuleShape>(&shape)) return Primitive{*it};
        if (const auto* cone = std::get_if<physics::ConeShape>(&shape)) return Primitive{*cone};
        return {};
    }

    /// What is seen of a body, or of all that none of them moves.
    VisualDescription part_of(std::size_t body) const {
        ModelVisual part = std::get<ModelVisual>(visual);
        part.body = body;
        return part;
    }

    void name_groups() {
        std::set<std::string> taken{"default"};
        for (std::size_t i = 0; i < physics().filters.size(); ++i) {
            std::string name = fmt::format("{}", fmt::join(physics().filters[i].member_of, "+"));
            if (name.empty() || !taken.insert(name).second) {
                name = fmt::format("filter {}", i);
                taken.insert(name);
            }
            groups.push_back(std::move(name));
        }
    }

    /// Whether both sides of a pair agree; no number: a collider without a filter.
    bool touch(const assets::ModelCollisionFilter& a, std::optional<std::size_t> b) const {
        if (!b) return a.accepts({});
        const assets::ModelCollisionFilter& other = physics().filters[*b];
        return a.accepts(other.member_of) && other.accepts(a.member_of);
    }

    void filter(const assets::ModelCollider& collider, BodyDescription& body) const {
        if (!collider.filter) return;
        const assets::ModelCollisionFilter& own = physics().filters[*collider.filter];
        body.group = groups[*collider.filter];
        bool all = touch(own, {});
        if (all) body.collides_with.emplace_back("default");
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const bool agrees = touch(own, i);
            if (agrees) body.collides_with.push_back(groups[i]);
            all &= agrees;
        }
        if (all) body.collides_with.clear();
        if (!all && body.collides_with.empty()) body.collides_with.emplace_back(kNoGroup);
    }

    void wear(const assets::ModelCollider& collider, BodyDescription& body) const {
        if (!collider.material) return;
        const assets::PhysicsMaterial& material = physics().materials[*collider.material];
        if (!material.extras.empty()) return wear_own(material.extras, body);
        const auto friction =
            material.dynamic_friction ? material.dynamic_friction : material.static_friction;
        if (friction) {
            body.friction = static_cast<Real>(std::min(*friction, 1000.0));
            body.friction_rule = rule_of(material.friction_combine);
        }
        if (material.static_friction && material.dynamic_friction &&
            std::abs(*material.static_friction - *material.dynamic_friction) > kFrictionsDiffer)
            gltf.warn(
                collider.node,
                "static friction {} differs from dynamic friction {}; that of sliding is used",
                *material.static_friction,
                *material.dynamic_friction);
        if (!material.restitution) return;
        body.restitution = static_cast<Real>(std::min(*material.restitution, 1.0));
        body.restitution_rule = rule_of(material.restitution_combine);
        if (*material.restitution > 1.0)
            gltf.warn(collider.node,
                      "a restitution of {} makes energy; 1 is used",
                      *material.restitution);
    }

    /// What our exporter says of a material: glTF has no geometric mean.
    void wear_own(const std::string& extras, BodyDescription& body) const {
        const auto table = table_of_extras(extras, gltf.location, gltf.faults);
        if (!table) return;
        TableReader reader(*table, "physicsMaterials", gltf.faults);
        read_body_surface(reader, body);
        reader.finish();
    }

    void weigh(const assets::ModelMotion& motion, BodyDescription& body) const {
        const bool turns = !motion.inertia_kgm2 || motion.inertia_kgm2->x > 0 ||
                           motion.inertia_kgm2->y > 0 || motion.inertia_kgm2->z > 0;
        if (motion.is_kinematic || (motion.mass_kg == 0.0 && !motion.inertia_kgm2) ||
            (motion.mass_kg == 0.0 && !turns)) {
            body.kind = BodyKind::Kinematic;  // nothing can move it
            return;
        }
        body.kind = BodyKind::Dynamic;
        if (motion.mass_kg) {
            const double mass_kg = *motion.mass_kg == 0.0 ? kImmovable_kg : *motion.mass_kg;
            const double taken = std::clamp(mass_kg, limits::kMassMin_kg, limits::kMassMax_kg);
            if (taken != mass_kg)
                gltf.warn(motion.node, "a mass of {} kg; {} kg is used", mass_kg, taken);
            body.mass_kg = static_cast<Real>(taken);
            if (*motion.mass_kg == 0.0) body.linear_factor = {0, 0, 0};
        }
        if (motion.center_of_mass_m)
            body.center_of_mass_m =
                Vec3(gltf.places[motion.node].stretch * *motion.center_of_mass_m);
        if (!motion.inertia_kgm2) return;
        Vec3d moments = *motion.inertia_kgm2;
        for (int i = 0; i < 3; ++i) {
            if (moments[i] == 0.0) moments[i] = kUnturnable_kgm2;
        }
        body.inertia_kgm2 = Vec3(moments);
        body.body_from_inertia = Quat(motion.node_from_inertia);
    }

    void launch(const assets::ModelMotion& motion, BodyDescription& body) const {
        const Quatd& turn = gltf.places[motion.node].turn;
        const auto in_world = [&](const Vec3d& own, double most) {
            const double length = glm::length(own);
            if (length <= most) return Vec3(turn * own);
            gltf.warn(motion.node, "a velocity of {:g}; {:g} is used", length, most);
            return Vec3(turn * own * (most / length));
        };
        body.velocity_mps = in_world(motion.velocity_mps, limits::kSpeed_mps);
        body.angular_velocity_radps = in_world(motion.angular_velocity_radps, 1e4);
        body.gravity_factor = static_cast<Real>(std::clamp(motion.gravity_factor, -1000.0, 1000.0));
    }

    /// What our exporter says beyond glTF of an entity that stands at the node. Joints read their own.
    void add_extras(std::uint32_t node, EntityDescription& entity) const {
        const std::string& extras = gltf.model.nodes[node].extras;
        if (extras.empty()) return;
        const auto table = table_of_extras(extras, gltf.location, gltf.faults);
        if (!table) return;
        TableReader reader(*table, gltf.called(node), gltf.faults);
        auto traits = reader.table("body");
        if (traits && entity.body) {
            read_body_traits(*traits, *entity.body);
            traits->finish();
        }
        if (!entity.body || entity.body->kind != BodyKind::Static)
            reader.read_table("light", entity.light, read_light);
        for (const char* read_elsewhere : {"light", "joint"}) reader.find(read_elsewhere);
        reader.finish();
    }

    /// Lamps that no body carries.
    void add_lamps() {
        for (std::uint32_t node = 0; node < gltf.model.nodes.size(); ++node) {
            if (gltf.model.nodes[node].extras.empty() || gltf.moves(node)) continue;
            EntityDescription lamp;
            lamp.world_from_body = pose_of(gltf.places[node]);
            lamp.location = gltf.location;
            add_extras(node, lamp);
            if (!lamp.light) continue;
            lamp.name = name_for(node);
            gltf.scene.entities.push_back(std::move(lamp));
        }
    }

    void add_moving(std::size_t number) {
        const assets::ModelMotion& motion = physics().motions[number];
        const std::vector<const assets::ModelCollider*>& colliders = of_motion[number];
        EntityDescription entity = entity_at(motion.node);
        entity.visual = part_of(number);
        if (colliders.empty()) {
            gltf.warn(motion.node, "it has motion and no collider: it stands, and is only seen");
            gltf.scene.entities.push_back(std::move(entity));
            return;
        }
        BodyDescription body;
        weigh(motion, body);
        const bool solid = body.kind == BodyKind::Dynamic || colliders.size() > 1;
        physics::CompoundShape whole;
        for (const assets::ModelCollider* collider : colliders)
            whole.children.push_back(
                shape_of_collider(gltf, *collider, gltf.places[motion.node], solid));
        const physics::CompoundChild& first = whole.children.front();
        const bool is_one = whole.children.size() == 1 &&
                            first.body_from_child.position == Vec3{0, 0, 0} &&
                            first.body_from_child.orientation == Quat{1, 0, 0, 0};
        const physics::ShapeDef shape = is_one ? first.shape : physics::ShapeDef{whole};
        entity.visual = seen_of(number, shape);
        body.shape = shape;
        touch_as(colliders, body);
        launch(motion, body);
        entity.body = std::move(body);
        add_extras(motion.node, entity);
        named[number] = entity.name;
        gltf.scene.entities.push_back(std::move(entity));
    }

    /// Materials and filters of the colliders: the body's, or where they differ each part's own.
    void touch_as(const std::vector<const assets::ModelCollider*>& colliders,
                  BodyDescription& body) const {
        const assets::ModelCollider& first = *colliders.front();
        filter(first, body);
        wear(first, body);
        const bool alike = std::ranges::all_of(colliders, [&first](const auto* other) {
            return other->material == first.material && other->filter == first.filter;
        });
        if (alike) return;
        for (const assets::ModelCollider* collider : colliders) {
            BodyDescription& part = body.parts.emplace_back();
            filter(*collider, part);
            wear(*collider, part);
        }
    }

    /// Nodes without a name are parts of what they hang on, as our exporter has them.
    std::uint32_t owner_of(std::uint32_t node) const {
        const std::vector<assets::ModelNode>& nodes = gltf.model.nodes;
        std::uint32_t owner = node;
        while (nodes[owner].name.empty() && nodes[owner].parent) owner = *nodes[owner].parent;
        return nodes[owner].name.empty() ? node : owner;
    }

    static bool is_mesh(const assets::ModelCollider& collider) {
        const auto* triangles = std::get_if<assets::ModelTriangles>(&collider.shape);
        return triangles != nullptr && !triangles->convex_hull;
    }

    /// One body that stands, of the colliders of one owner.
    void add_standing(std::uint32_t owner,
                      const std::vector<const assets::ModelCollider*>& colliders) {
        const assets::ModelCollider& first = *colliders.front();
        const std::uint32_t node = colliders.size() == 1 ? first.node : owner;
        EntityDescription entity;
        entity.name = name_for(owner);
        entity.world_from_body = pose_of(gltf.places[node]);
        entity.location = gltf.location;
        BodyDescription body{.kind = BodyKind::Static};
        physics::CompoundShape whole;
        for (const assets::ModelCollider* collider : colliders)
            whole.children.push_back(
                shape_of_collider(gltf, *collider, gltf.places[node], colliders.size() > 1));
        const physics::ShapeDef shape =
            colliders.size() == 1 ? whole.children.front().shape : physics::ShapeDef{whole};
        if (gltf.model.mesh.indices.empty()) entity.visual = seen_of(0, shape);
        body.shape = shape;
        touch_as(colliders, body);
        entity.body = std::move(body);
        add_extras(owner, entity);
        gltf.entities[owner] = entity.name;
        for (const assets::ModelCollider* collider : colliders)
            gltf.entities[collider->node] = entity.name;
        gltf.scene.entities.push_back(std::move(entity));
    }

    void add_all_standing() {
        std::map<std::uint32_t, std::vector<const assets::ModelCollider*>> owned;
        for (const assets::ModelCollider& collider : physics().colliders) {
            if (!collider.is_trigger && !gltf.moves(collider.node))
                owned[owner_of(collider.node)].push_back(&collider);
        }
        for (const auto& [owner, colliders] : owned) {
            // Meshes are bodies of their own: a compound has none.
            if (std::ranges::none_of(colliders, [](const auto* each) { return is_mesh(*each); })) {
                add_standing(owner, colliders);
                continue;
            }
            for (const assets::ModelCollider* collider : colliders) add_standing(owner, {collider});
        }
    }

    /// A volume that says when something comes in: what glTF leaves to the program.
    void add_trigger(const assets::ModelCollider& collider) {
        if (gltf.moves(collider.node))
            gltf.warn(collider.node, "a trigger that moves stays where it starts");
        EntityDescription entity = entity_at(collider.node);
        const physics::ShapeDef shape =
            shape_of_collider(gltf, collider, gltf.places[collider.node], true).shape;
        if (const auto* box = std::get_if<physics::BoxShape>(&shape)) {
            entity.visual = Primitive{*box};
        } else if (const auto* sphere = std::get_if<physics::SphereShape>(&shape)) {
            entity.visual = Primitive{*sphere};
        } else {
            Vec3 min{0, 0, 0};
            Vec3 max{0, 0, 0};
            bounds_of(shape, min, max);
            entity.visual = Primitive{physics::BoxShape{.size_m = max - min}};
            entity.world_from_body =
                compose(entity.world_from_body, {.position = (min + max) / Real{2}});
        }
        entity.material = kTriggerMaterial;
        entity.casts_shadow = false;
        entity.trigger = TriggerDescription{
            .times = 1000, .message = fmt::format("something came into {}", entity.name)};
        gltf.scene.materials.try_emplace(
            kTriggerMaterial,
            assets::MaterialData{.name = kTriggerMaterial,
                                 .base_color = {0.2F, 0.7F, 1.0F},
                                 .alpha = 0.15F,
                                 .alpha_mode = assets::AlphaMode::Blend});
        gltf.scene.entities.push_back(std::move(entity));
    }

    void add_all() {
        name_groups();
        named.resize(physics().motions.size());
        of_motion.resize(physics().motions.size());
        for (const assets::ModelCollider& collider : physics().colliders) {
            if (!collider.is_trigger && gltf.moves(collider.node))
                of_motion[gltf.bodies[collider.node]].push_back(&collider);
        }
        for (std::size_t i = 0; i < named.size(); ++i) add_moving(i);
        for (std::uint32_t node = 0; node < gltf.bodies.size(); ++node)
            gltf.entities.push_back(gltf.moves(node) ? named[gltf.bodies[node]] : std::string{});
        add_all_standing();
        for (const assets::ModelCollider& collider : physics().colliders) {
            if (collider.is_trigger) add_trigger(collider);
        }
        add_lamps();
        EntityDescription scenery;
        for (scenery.name = "scenery"; !names.insert(scenery.name).second;) scenery.name += "'";
        scenery.visual = part_of(physics().motions.size());
        scenery.location = gltf.location;
        gltf.scene.entities.push_back(std::move(scenery));
    }

    static constexpr const char* kTriggerMaterial = "plumbline.trigger";
};

}  // namespace

std::string GltfScene::called(std::uint32_t node) const {
    const std::string& name = model.nodes[node].name;
    return name.empty() ? fmt::format("node {}", node) : shown(name);
}

void add_gltf_bodies(GltfScene& gltf, const VisualDescription& visual) {
    BodyMaker{gltf, visual}.add_all();
}

}  // namespace plumbline::scene
