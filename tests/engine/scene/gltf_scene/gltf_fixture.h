// glTF files with physics made in code, and what our reader makes of them.
#pragma once

#include "engine/scene/scene_file.h"
#include "tests/support/scene_in_code.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace plumbline::scene::gltf {

using Json = nlohmann::json;

/// What was read: the scene, or why there is none.
struct ReadGltf {
    Result<SceneDescription> scene;
    Diagnostics faults{};

    const SceneDescription& operator*() const { return scene.value(); }
    const SceneDescription* operator->() const { return &scene.value(); }
    const EntityDescription& entity(const std::string& name) const {
        const auto found = std::ranges::find(scene->entities, name, &EntityDescription::name);
        EXPECT_NE(found, scene->entities.end()) << name;
        return found == scene->entities.end() ? scene->entities.front() : *found;
    }
    const BodyDescription& body(const std::string& name) const { return *entity(name).body; }
    template <class Shape>
    Shape shape(const std::string& name) const {
        const auto* def = std::get_if<physics::ShapeDef>(&body(name).shape);
        const Shape* shape = def == nullptr ? nullptr : std::get_if<Shape>(def);
        EXPECT_NE(shape, nullptr) << name;
        return shape == nullptr ? Shape{} : *shape;
    }
    std::string said() const {
        std::string text = scene.ok() ? "" : scene.error().message;
        for (const Diagnostic& fault : faults.list()) text += to_string(fault) + "\n";
        return text;
    }
};

/// Nodes are roots unless another one has them as children.
class PhysicsFile {
public:
    Json json{{"asset", {{"version", "2.0"}}}, {"nodes", Json::array()}};

    std::size_t add_shape(const char* type, Json fields) {
        Json& shapes = json["extensions"]["KHR_implicit_shapes"]["shapes"];
        shapes.push_back({{"type", type}, {type, std::move(fields)}});
        return shapes.size() - 1;
    }
    std::size_t add_box(double x, double y, double z) {
        return add_shape("box", {{"size", {x, y, z}}});
    }
    std::size_t add(const char* list, Json entry) {
        Json& entries = json["extensions"]["KHR_physics_rigid_bodies"][list];
        entries.push_back(std::move(entry));
        return entries.size() - 1;
    }
    std::size_t add_node(Json node) {
        json["nodes"].push_back(std::move(node));
        return json["nodes"].size() - 1;
    }
    /// A node with what the extension says of it.
    std::size_t add_body(const char* name, Json translation, Json physics) {
        return add_node({{"name", name},
                         {"translation", std::move(translation)},
                         {"extensions", {{"KHR_physics_rigid_bodies", std::move(physics)}}}});
    }
    static Json collider(std::size_t shape) { return {{"geometry", {{"shape", shape}}}}; }
    /// A ball of 0.5 m.
    std::size_t add_ball(const char* name, Json translation, Json motion) {
        const std::size_t shape = add_shape("sphere", {{"radius", 0.5}});
        return add_body(name,
                        std::move(translation),
                        {{"motion", std::move(motion)}, {"collider", collider(shape)}});
    }
    void add_child(std::size_t parent, std::size_t child) {
        json["nodes"][parent]["children"].push_back(child);
    }
    /// A mesh of these triangles; its number.
    std::size_t add_mesh(const std::vector<float>& positions,
                         const std::vector<std::uint32_t>& corners) {
        const auto view = [this](const void* bytes, std::size_t size) {
            json["bufferViews"].push_back(
                {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}});
            binary_.append(static_cast<const char*>(bytes), size);
            return json["bufferViews"].size() - 1;
        };
        const auto accessor = [&](const void* bytes,
                                  std::size_t size,
                                  int component,
                                  const char* type,
                                  std::size_t count) {
            const std::size_t number = view(bytes, size);
            json["accessors"].push_back({{"bufferView", number},
                                         {"componentType", component},
                                         {"count", count},
                                         {"type", type}});
            return json["accessors"].size() - 1;
        };
        const std::size_t place = accessor(
            positions.data(), positions.size() * sizeof(float), 5126, "VEC3", positions.size() / 3);
        const std::size_t index = accessor(
            corners.data(), corners.size() * sizeof(std::uint32_t), 5125, "SCALAR", corners.size());
        json["meshes"].push_back(
            {{"primitives", {{{"attributes", {{"POSITION", place}}}, {"indices", index}}}}});
        return json["meshes"].size() - 1;
    }
    /// The corners of a cube with edges of 2 m round the origin.
    std::size_t add_cube_mesh() {
        return add_mesh(
            {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1},
            {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
    }

    std::string text() const {
        Json whole = json;
        whole["extensionsUsed"] = {"KHR_physics_rigid_bodies", "KHR_implicit_shapes"};
        if (!binary_.empty())
            whole["buffers"] = {{{"byteLength", binary_.size()}, {"uri", "m.bin"}}};
        if (whole.contains("scenes")) return whole.dump();
        std::vector<bool> is_child(whole["nodes"].size(), false);
        for (const Json& node : whole["nodes"]) {
            for (const Json& child : node.value("children", Json::array()))
                is_child[child.get<std::size_t>()] = true;
        }
        Json roots = Json::array();
        for (std::size_t i = 0; i < is_child.size(); ++i) {
            if (!is_child[i]) roots.push_back(i);
        }
        whole["scenes"] = {{{"nodes", roots}}};
        return whole.dump();
    }

    ReadGltf read() const { return read_text(text()); }
    ReadGltf read_text(const std::string& document) const {
        const test::TemporaryFolder folder;
        const std::filesystem::path file = folder.write("m.gltf", document);
        folder.write("m.bin", binary_);
        ReadGltf read{.scene = Error{}};
        ::testing::internal::CaptureStderr();
        read.scene = read_description(file, {}, read.faults);
        log_ = ::testing::internal::GetCapturedStderr();
        return read;
    }

private:
    std::string binary_;
    mutable std::string log_;
};

inline double num(Real value) {
    return static_cast<double>(value);
}

/// Without what is seen, whose file is gone, and without the stage's ground.
inline SceneDescription unseen(SceneDescription scene) {
    std::erase_if(scene.entities,
                  [](const EntityDescription& entity) { return entity.name == "ground"; });
    for (EntityDescription& entity : scene.entities) {
        if (std::holds_alternative<ModelVisual>(entity.visual)) entity.visual = std::monostate{};
    }
    return scene;
}

/// Of an entity's body after so many seconds.
inline physics::BodyState state_after(test::Running& run, const char* name, double time_s) {
    run.step(static_cast<int>(time_s / run->step_s() + 0.5));
    return run->physics.state(run->registry.get<BodyRef>(run->find(name)).body);
}

}  // namespace plumbline::scene::gltf
