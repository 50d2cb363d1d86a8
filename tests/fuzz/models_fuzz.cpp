// Models in the formats that our own readers read: the first letter of an input names the format.
#include "engine/assets/mesh_files/ply_import.h"
#include "engine/assets/model/model_bodies.h"
#include "engine/assets/model/model_pose.h"
#include "engine/assets/model/model_readers_impl.h"
#include "tests/engine/assets/animation_files.h"
#include "tests/fuzz/fuzz_target.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace plumbline::fuzz {
namespace {

using assets::ModelData;

std::string binary_stl() {
    std::string bytes(80, ' ');
    assets::test::append_bytes<std::uint32_t>(bytes, {1});
    assets::test::append_bytes<float>(bytes, {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    return bytes + std::string(2, '\0');
}

std::string binary_ply() {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float "
        "y\n"
        "property float z\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n";
    for (const float x : {0.0F, 1.0F, 2.0F}) {
        assets::test::append_bytes<float>(bytes, {x, x * x, 0});
        bytes += '\x80';
    }
    bytes += '\3';
    assets::test::append_bytes<std::int32_t>(bytes, {0, 1, 2});
    return bytes;
}

Result<ModelData> read(char format, std::string_view bytes) {
    assets::ModelReferences references("/nonexistent/m", "/nonexistent");
    if (format == 'o') return assets::read_obj(bytes, "mutant", references);
    if (format == 'p') return assets::read_ply(bytes, "mutant");
    if (format == 's') return assets::read_stl(bytes, "mutant");
    return assets::read_gltf(bytes, "mutant", references);
}

/// As the library and the viewer do.
void use(const ModelData& model) {
    const assets::MeshData mesh = merged_mesh(model, rest_pose(model), "mutant");
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.vertices.size()) std::abort();
    }
    if (!model.physics.is_empty()) {
        for (const assets::MeshData& body : body_meshes(model, "mutant")) {
            for (const std::uint32_t index : body.indices) {
                if (index >= body.vertices.size()) std::abort();
            }
        }
    }
    for (const assets::ModelAnimation& animation : model.animations) {
        const assets::ModelPose pose = pose_at(model, animation, animation.duration_s / 2);
        for (const assets::ModelPart& part : parts_of(model).moving) {
            assets::MeshData moved = part_mesh(model, part, rest_pose(model));
            deform(model, part, pose, moved);
        }
    }
}

}  // namespace

std::vector<std::string> seeds() {
    assets::test::TriangleFile sliding;
    sliding.slide(0);
    assets::test::TriangleFile turning;
    turning.hang_on_turning_bone();
    assets::test::TriangleFile physical;
    physical.json["extensions"] = {
        {"KHR_implicit_shapes",
         {{"shapes", {{{"type", "capsule"}, {"capsule", {{"height", 1}, {"radiusTop", 0.5}}}}}}}},
        {"KHR_physics_rigid_bodies",
         {{"physicsMaterials", {{{"dynamicFriction", 0.5}, {"frictionCombine", "minimum"}}}},
          {"collisionFilters", {{{"collisionSystems", {"a"}}, {"collideWithSystems", {"a"}}}}},
          {"physicsJoints", {{{"limits", {{{"linearAxes", {0, 1}}, {"max", 1}}}}}}}}}};
    physical.json["nodes"] = assets::test::Json::parse(R"([
        {"mesh": 0, "children": [1], "scale": [1, 2, 1], "extensions": {"KHR_physics_rigid_bodies": {
            "motion": {"mass": 2, "inertiaOrientation": [0, 0, 0, 1]},
            "collider": {"geometry": {"shape": 0}, "physicsMaterial": 0, "collisionFilter": 0}}}},
        {"rotation": [0, 0, 1, 1], "extensions": {"KHR_physics_rigid_bodies": {
            "trigger": {"geometry": {"node": 0, "convexHull": true}},
            "joint": {"connectedNode": 0, "joint": 0}}}}])");
    return {"g" + physical.gltf(),
            "g" + sliding.glb(),
            "g" + turning.glb(),
            "g" + assets::test::skinned().gltf(),
            "ov 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl a\n"
            "f 1/1/1 2/2/1 3//1 4\nf -1 -2 -3\n",
            "p" + binary_ply(),
            "pply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
            "s" + binary_stl(),
            "ssolid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
            "endloop\nendfacet\nendsolid a\n"};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    if (input.empty()) return 0;
    const auto model = plumbline::fuzz::read(input.front(), input.substr(1));
    if (!model) return model.error().message.empty() ? 1 : 0;
    plumbline::fuzz::note_taken();
    plumbline::fuzz::use(*model);
    return 0;
}
