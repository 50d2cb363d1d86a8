// KHR_physics_rigid_bodies and KHR_implicit_shapes, as their texts of 2025 have them; also collider meshes named
// directly (2026), and the drafts KHR_rigid_bodies and KHR_collision_shapes (2024).
#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMostEntries = 100'000;  // of each list
constexpr std::array<const char*, 2> kBodyExtensions{"KHR_physics_rigid_bodies",
                                                     "KHR_rigid_bodies"};
constexpr std::array<const char*, 2> kShapeExtensions{"KHR_implicit_shapes",
                                                      "KHR_collision_shapes"};

/// An object within another one, called after both.
std::optional<GltfObject> part_of(const GltfObject& owner, const char* key) {
    auto part = owner.object(key);
    if (part) part->where = owner.where.empty() ? key : fmt::format("{}.{}", owner.where, key);
    return part;
}

/// The extension's object under whichever of its names.
std::optional<GltfObject> extension_of(const GltfObject& owner,
                                       const std::array<const char*, 2>& names) {
    const auto extensions = owner.object("extensions");
    if (!extensions) return {};
    for (const char* name : names) {
        if (auto found = part_of(*extensions, name)) return found;
    }
    return {};
}

std::vector<std::string> texts_of(const GltfObject& owner, const char* key) {
    std::vector<std::string> texts;
    for (const Json& text : owner.array(key)) {
        if (!text.is_string())
            fail("{}.{} holds {}; expected texts", owner.where, key, text.dump());
        texts.push_back(text.get<std::string>());
    }
    return texts;
}

bool flag_of(const GltfObject& owner, const char* key) {
    const auto found = owner.json.find(key);
    if (found == owner.json.end()) return false;
    if (!found->is_boolean()) fail("{}.{} is not true or false", owner.where, key);
    return found->get<bool>();
}

double above_zero(const GltfObject& owner, const char* key, double absent) {
    const double value = owner.real(key).value_or(absent);
    if (!(value > 0.0)) fail("{}.{} must be a length above 0", owner.where, key);
    return value;
}

std::optional<Vec3d> vector_of(const GltfObject& owner, const char* key) {
    const std::vector<double> v = owner.reals(key, 3);
    if (v.empty()) return {};
    return Vec3d{v[0], v[1], v[2]};
}

CombineMode mode_of(const GltfObject& material, const char* key) {
    constexpr std::array<std::string_view, 4> kModes{"average", "minimum", "maximum", "multiply"};
    const std::string text = material.text(key);
    if (text.empty()) return CombineMode::Average;
    const auto found = std::ranges::find(kModes, text);
    if (found == kModes.end())
        fail("{}.{} is \"{}\"; expected average, minimum, maximum or multiply",
             material.where,
             key,
             text);
    return static_cast<CombineMode>(found - kModes.begin());
}

PhysicsMaterial material_of(const GltfObject& source) {
    PhysicsMaterial material{.static_friction = source.real("staticFriction"),
                             .dynamic_friction = source.real("dynamicFriction"),
                             .restitution = source.real("restitution"),
                             .friction_combine = mode_of(source, "frictionCombine"),
                             .restitution_combine = mode_of(source, "restitutionCombine"),
                             .extras = own_extras(source)};
    for (const auto& value :
         {material.static_friction, material.dynamic_friction, material.restitution}) {
        if (value && *value < 0.0) fail("{} has a coefficient below 0", source.where);
    }
    return material;
}

ModelCollisionFilter filter_of(const GltfObject& source) {
    ModelCollisionFilter filter{.member_of = texts_of(source, "collisionSystems"),
                                .without = texts_of(source, "notCollideWithSystems")};
    if (source.json.contains("collideWithSystems"))
        filter.with = texts_of(source, "collideWithSystems");
    return filter;
}

ModelShape round_shape(const GltfObject& source, bool is_capsule) {
    ModelRound round{.is_capsule = is_capsule, .height_m = above_zero(source, "height", 0.5)};
    round.radius_bottom_m = source.real("radiusBottom").value_or(0.25);
    round.radius_top_m = source.real("radiusTop").value_or(0.25);
    if (round.radius_bottom_m < 0.0 || round.radius_top_m < 0.0 ||
        round.radius_bottom_m + round.radius_top_m <= 0.0)
        fail("{} must have radii of 0 or more, one of them above 0", source.where);
    return round;
}

/// What the document has as one mesh.
std::vector<ColliderMesh> meshes_of(const GltfReader& reader, std::size_t mesh) {
    std::vector<ColliderMesh> meshes;
    for (const std::uint32_t part : reader.mesh_parts[mesh]) meshes.push_back({.mesh = part});
    return meshes;
}

/// In the draft convex and trimesh are shapes as well, which name a mesh.
ModelShape shape_of(const GltfReader& reader, const GltfObject& source) {
    const std::string type = source.text("type");
    const auto fields = source.object(type.c_str());
    const Json none = Json::object();
    GltfObject own{.json = fields ? fields->json : none,
                   .where = fmt::format("{}.{}", source.where, type)};
    if (type == "box") {
        const Vec3d size = vector_of(own, "size").value_or(Vec3d{1, 1, 1});
        if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0))
            fail("{}.size must be three lengths above 0", own.where);
        return ModelBox{.size_m = size};
    }
    if (type == "sphere") {
        return ModelSphere{.radius_m = above_zero(own, "radius", 0.5)};
    }
    if (type == "capsule" || type == "cylinder") return round_shape(own, type == "capsule");
    if (type == "convex" || type == "trimesh") {
        const auto mesh = own.index("mesh", reader.mesh_parts.size());
        if (!mesh) fail("{}.mesh is missing", own.where);
        return ModelTriangles{.meshes = meshes_of(reader, *mesh), .convex_hull = type == "convex"};
    }
    fail("{} has the type \"{}\"; box, sphere, capsule and cylinder are read", source.where, type);
}

/// Names of nodes become places in the model; nothing for a node outside the scene.
std::optional<std::uint32_t> node_of(const GltfReader& reader,
                                     const GltfObject& source,
                                     const char* key) {
    const auto number = source.index(key, reader.node_places.size());
    if (!number) fail("{}.{} is missing; expected a node", source.where, key);
    return reader.node_places[*number];
}

struct PhysicsReader {
    GltfReader& reader;
    std::vector<ModelShape> shapes{};
    std::vector<GltfObject> joints{};
    std::size_t vertices{0};  ///< of colliders that are meshes, each as often as it is named
    ModelPhysics& physics = reader.model.physics;

    void read_lists() {
        if (const auto extension = extension_of(reader.root, kShapeExtensions)) {
            for (const GltfObject& shape : extension->objects("shapes", kMostEntries))
                shapes.push_back(shape_of(reader, shape));
        }
        const auto extension = extension_of(reader.root, kBodyExtensions);
        if (!extension) return;
        for (const GltfObject& material : extension->objects("physicsMaterials", kMostEntries))
            physics.materials.push_back(material_of(material));
        for (const GltfObject& filter : extension->objects("collisionFilters", kMostEntries))
            physics.filters.push_back(filter_of(filter));
        joints = extension->objects("physicsJoints", kMostEntries);
        for (GltfObject& draft : extension->objects("physicsJointLimits", kMostEntries))
            joints.push_back(std::move(draft));
    }

    ModelShape geometry_of(const GltfObject& source) {
        if (const auto shape = source.index("shape", shapes.size())) return shapes[*shape];
        ModelTriangles triangles{.convex_hull = flag_of(source, "convexHull")};
        if (const auto mesh = source.index("mesh", reader.mesh_parts.size())) {
            triangles.meshes = meshes_of(reader, *mesh);
        } else if (const auto node = source.index("node", reader.node_places.size())) {
            triangles.meshes = meshes_below(reader, *node);
        } else {
            fail("{} names no shape and no node", source.where);
        }
        for (const ColliderMesh& part : triangles.meshes)
            vertices += reader.model.meshes[part.mesh].vertices.size();
        if (vertices > limits::kVertices)
            fail("its colliders have more than {} vertices", limits::kVertices);
        return triangles;
    }

    void read_collider(const GltfObject& owner, std::uint32_t node, const char* key) {
        const auto source = part_of(owner, key);
        if (!source) return;
        const auto geometry = source->object("geometry");
        const bool is_trigger = std::string_view(key) == "trigger";
        // A compound trigger has its volumes below it, each a trigger of its own.
        if (is_trigger && !geometry && !source->json.contains("shape")) return;
        ModelCollider collider{.node = node,
                               .shape = geometry_of(geometry ? *geometry : *source),
                               .is_trigger = is_trigger};
        if (const auto material = source->index("physicsMaterial", physics.materials.size()))
            collider.material = static_cast<std::uint32_t>(*material);
        if (const auto filter = source->index("collisionFilter", physics.filters.size()))
            collider.filter = static_cast<std::uint32_t>(*filter);
        physics.colliders.push_back(std::move(collider));
    }

    void read_motion(const GltfObject& owner, std::uint32_t node) {
        const auto source = part_of(owner, "motion");
        if (!source) return;
        ModelMotion motion{.node = node,
                           .is_kinematic = flag_of(*source, "isKinematic"),
                           .mass_kg = source->real("mass"),
                           .inertia_kgm2 = vector_of(*source, "inertiaDiagonal"),
                           .center_of_mass_m = vector_of(*source, "centerOfMass"),
                           .gravity_factor = source->real("gravityFactor").value_or(1.0)};
        if (motion.mass_kg && *motion.mass_kg < 0.0) fail("{}.mass is below 0", source->where);
        if (motion.inertia_kgm2 &&
            glm::any(glm::lessThan(*motion.inertia_kgm2, Vec3d{0.0, 0.0, 0.0})))
            fail("{}.inertiaDiagonal has a moment below 0", source->where);
        const std::vector<double> turn = source->reals("inertiaOrientation", 4);
        if (!turn.empty()) {
            const Quatd given{turn[3], turn[0], turn[1], turn[2]};
            if (!(glm::length(given) > 1e-6)) fail("{}.inertiaOrientation is zero", source->where);
            motion.node_from_inertia = glm::normalize(given);
        }
        motion.velocity_mps = vector_of(*source, "linearVelocity").value_or(Vec3d{0, 0, 0});
        motion.angular_velocity_radps =
            vector_of(*source, "angularVelocity").value_or(Vec3d{0, 0, 0});
        physics.motions.push_back(motion);
    }

    static ModelJointLimit limit_of(const GltfObject& source) {
        ModelJointLimit limit{.is_angular = source.json.contains("angularAxes"),
                              .min = source.real("min"),
                              .max = source.real("max"),
                              .stiffness = source.real("stiffness"),
                              .damping = source.real("damping").value_or(0.0)};
        const char* key = limit.is_angular ? "angularAxes" : "linearAxes";
        for (const Json& axis : source.array(key)) {
            if (!axis.is_number_unsigned() || axis.get<std::size_t>() > 2)
                fail("{}.{} holds {}; expected 0, 1 or 2", source.where, key, axis.dump());
            limit.axes.at(axis.get<std::size_t>()) = true;
        }
        if (limit.min && limit.max && *limit.min > *limit.max)
            fail("{}: min is above max", source.where);
        return limit;
    }

    static ModelJointDrive drive_of(const GltfObject& source) {
        ModelJointDrive drive{.is_angular = source.text("type") == "angular",
                              .by_mass = source.text("mode") == "acceleration",
                              .max_force = source.real("maxForce"),
                              .position_target = source.real("positionTarget").value_or(0.0),
                              .velocity_target = source.real("velocityTarget").value_or(0.0),
                              .stiffness = source.real("stiffness").value_or(0.0),
                              .damping = source.real("damping").value_or(0.0)};
        const auto axis = source.index("axis", 3);
        if (!axis) fail("{}.axis is missing", source.where);
        drive.axis = *axis;
        return drive;
    }

    void read_joint(const GltfObject& owner, std::uint32_t node) {
        const auto source = part_of(owner, "joint");
        if (!source) return;
        const auto connected = node_of(reader, *source, "connectedNode");
        const char* key = source->json.contains("jointLimits") ? "jointLimits" : "joint";
        const auto number = source->index(key, joints.size());
        if (!number) fail("{}.joint is missing", source->where);
        if (!connected) {
            log_warning("model {}: {} is left out: its connected node is not in the scene",
                        reader.name,
                        source->where);
            return;
        }
        ModelJoint joint{
            .node = node, .connected = *connected, .collide = flag_of(*source, "enableCollision")};
        for (const GltfObject& limit : joints[*number].objects("limits", kMostEntries))
            joint.limits.push_back(limit_of(limit));
        for (const GltfObject& drive : joints[*number].objects("drives", kMostEntries))
            joint.drives.push_back(drive_of(drive));
        physics.joints.push_back(std::move(joint));
    }

    void read_all() {
        read_lists();
        const std::vector<GltfObject> nodes = reader.objects("nodes", limits::kModelNodes);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!reader.node_places[i]) continue;
            const auto extension = extension_of(nodes[i], kBodyExtensions);
            if (!extension) continue;
            read_motion(*extension, *reader.node_places[i]);
            read_collider(*extension, *reader.node_places[i], "collider");
            read_collider(*extension, *reader.node_places[i], "trigger");
            read_joint(*extension, *reader.node_places[i]);
        }
    }
};

}  // namespace

bool ModelCollisionFilter::accepts(const std::vector<std::string>& systems) const {
    const auto meets = [&systems](const std::vector<std::string>& names) {
        return std::ranges::any_of(names, [&](const std::string& name) {
            return std::ranges::find(systems, name) != systems.end();
        });
    };
    if (with && !meets(*with)) return false;
    return !meets(without);
}

void read_physics(GltfReader& reader) {
    PhysicsReader{reader}.read_all();
}

}  // namespace plumbline::assets
