#include "engine/scene/gltf_scene/gltf_export.h"

#include "engine/scene/build/shape_factory.h"
#include "engine/scene/gltf_scene/gltf_export_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;

/// The meshes of what is seen, each once for its materials.
class SeenMeshes {
public:
    explicit SeenMeshes(GltfOutput& out) : out_(out) {}

    std::optional<std::size_t> mesh_of(const Visual& visual) {
        const assets::AssetLibrary& library = out_.simulation.library();
        const assets::MeshData& mesh = library.mesh(visual.mesh);
        if (mesh.indices.empty()) return {};
        std::vector<std::size_t> materials;
        for (const assets::MaterialId material : visual.materials)
            materials.push_back(out_.writer.add_material(library.material(material)));
        const auto key = std::make_pair(visual.mesh, materials);
        const auto known = meshes_.find(key);
        if (known != meshes_.end()) return known->second;
        const std::size_t number = out_.writer.add_mesh(mesh, materials);
        meshes_.emplace(key, number);
        return number;
    }

private:
    GltfOutput& out_;
    std::map<std::pair<assets::MeshId, std::vector<std::size_t>>, std::size_t> meshes_;
};

/// What glTF has no words for, by what the scene has of it.
void note_losses(GltfOutput& out) {
    const SceneDescription& scene = out.simulation.description();
    const auto lost = [&out](bool is_there, const char* what) {
        if (is_there) out.note(fmt::format("{} left out", what));
    };
    lost(!out.simulation.ropes().empty(), "ropes are");
    lost(!out.simulation.vehicles().empty(), "vehicles are");
    lost(!out.simulation.cloths().empty() || !out.simulation.softs().empty(),
         "cloths and soft bodies are");
    lost(!scene.fountains.empty() || !scene.forces.waters.empty(), "water is");
    lost(scene.grass.has_value() || !scene.flocks.empty(), "grass and flocks are");
    lost(scene.wind.has_value() || !scene.forces.wind_zones.empty(), "wind is");
    lost(scene.goal.has_value(), "the goal is");
    for (const MovingBody& moving : out.simulation.moving_bodies()) {
        if (out.simulation.registry.find<MotionPath>(moving.entity) == nullptr) continue;
        out.note("bodies that are led along a path keep the velocity that they have now");
        break;
    }
}

/// What is drawn of cloths and soft bodies, which glTF would leave standing.
std::set<ecs::Entity> deformables_of(const Simulation& simulation) {
    std::set<ecs::Entity> entities;
    for (const SceneDeformable& cloth : simulation.cloths()) entities.insert(cloth.entity);
    for (const SceneDeformable& soft : simulation.softs()) entities.insert(soft.entity);
    return entities;
}

void write_trigger(GltfOutput& out, const std::string& name, std::size_t node) {
    for (const EntityDescription& entity : out.simulation.description().entities) {
        const auto* primitive = std::get_if<Primitive>(&entity.visual);
        if (entity.name != name || primitive == nullptr) continue;
        const physics::ShapeDef shape = scaled(shape_of_primitive(*primitive), entity.scale);
        out.writer.use(kGltfBodies);
        out.node(node)["extensions"][kGltfBodies]["trigger"] = {
            {"geometry", geometry_of(out, shape)}};
        out.note("triggers are volumes that do nothing: what they do is left to the program");
    }
}

/// For our reader alone, with the keys of [entity.light].
Json light_of(const PointLight& light) {
    const float brightest =
        std::max({light.intensity.x, light.intensity.y, light.intensity.z, 1e-6F});
    const Vec3f color = light.intensity / brightest;
    Json table{{"kind", light.is_spot ? "spot" : "point"},
               {"color", {color.x, color.y, color.z}},
               {"intensity", brightest},
               {"radius_m", light.radius_m},
               {"shadow", light.casts_shadow},
               {"offset_m", {light.offset_body.x, light.offset_body.y, light.offset_body.z}}};
    table["on"] = light.on == LampOn::Always;
    if (light.on == LampOn::Dark) table["on"] = "dark";
    if (!light.is_spot) return table;
    const Vec3f& direction = light.direction_body;
    table["direction"] = {direction.x, direction.y, direction.z};
    table["inner_deg"] = degrees_from_radians(light.inner_rad);
    table["outer_deg"] = degrees_from_radians(light.outer_rad);
    return table;
}

void write_entities(GltfOutput& out) {
    Simulation& simulation = out.simulation;
    std::map<physics::BodyId, const physics::BodyCopy*> copies;
    const physics::WorldCopy world = physics::copy_of(simulation.physics);
    for (const physics::BodyCopy& body : world.bodies) copies.emplace(body.id, &body);
    const std::set<ecs::Entity> deformables = deformables_of(simulation);
    SeenMeshes meshes(out);
    simulation.registry.view<const Name, const Transform>().each([&](ecs::Entity entity,
                                                                     const Name& name,
                                                                     const Transform& transform) {
        if (simulation.registry.find<PartOf>(entity) != nullptr || deformables.contains(entity))
            return;
        Json node{{"name", name.text}};
        put_pose(node, transform.world_from_body);
        const std::size_t number = out.writer.add_node(std::move(node));
        const bool is_trigger = simulation.registry.find<TriggerVolume>(entity) != nullptr;
        if (is_trigger) return write_trigger(out, name.text, number);
        if (const auto* visual = simulation.registry.find<Visual>(entity)) {
            const auto mesh = meshes.mesh_of(*visual);
            if (mesh && transform.scale == Vec3{1, 1, 1}) {
                out.node(number)["mesh"] = *mesh;
            } else if (mesh) {
                out.add_child(number, {{"mesh", *mesh}, {"scale", gltf_numbers(transform.scale)}});
            }
        }
        if (const auto* light = simulation.registry.find<PointLight>(entity))
            out.node(number)["extras"]["plumbline"]["light"] = light_of(*light);
        const auto* ref = simulation.registry.find<BodyRef>(entity);
        if (ref == nullptr || !copies.contains(ref->body)) return;
        out.nodes.emplace(ref->body, number);
        write_body(out, *copies.at(ref->body), number);
    });
}

}  // namespace

void GltfOutput::note(std::string text) {
    if (std::ranges::find(notes, text) == notes.end()) notes.push_back(std::move(text));
}

GltfExport gltf_of(Simulation& simulation, const std::string& surroundings) {
    const auto read_image = [&simulation](const std::filesystem::path& file) {
        return simulation.library().encoded_image(file);
    };
    GltfOutput out{.simulation = simulation, .writer = GltfWriter(read_image)};
    write_entities(out);
    write_joints(out);
    note_losses(out);
    if (!surroundings.empty()) out.writer.json["extras"]["plumbline"] = Json::parse(surroundings);
    for (const std::string& note : out.writer.notes()) out.note(note);
    std::string glb = out.writer.glb();
    return {.glb = std::move(glb), .notes = std::move(out.notes)};
}

}  // namespace plumbline::scene
