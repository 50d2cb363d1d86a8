// glTF files that are refused as a whole, each with the words a person gets to read.

#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <functional>

namespace plumbline::assets::test {
namespace {

TEST(GltfRefusal, of_other_formats_by_name) {
    for (const char* name : {"a.blend", "a.md5mesh", "a.GLTFX", "a"}) {
        expect_refused(import_bytes("anything", name),
                       "convert to glTF (readable: .glb .gltf .obj .ply .stl .dae .fbx)");
    }
    expect_refused(import_bytes("anything", "a.fbx"), "its content is neither Collada nor FBX");
}

TEST(GltfRefusal, of_missing_files_folders_and_devices) {
    const TempFolder folder;
    expect_refused(Import(folder.path() / "absent.glb"), "cannot open");
    fs::create_directory(folder.path() / "folder.glb");
    expect_refused(Import(folder.path() / "folder.glb"), "is not a regular file");
    fs::create_symlink("/dev/zero", folder.path() / "device.glb");
    expect_refused(Import(folder.path() / "device.glb"), "it lies outside");
}

TEST(GltfRefusal, of_images_that_are_no_regular_files) {
    const TempFolder folder;
    fs::create_directory(folder.path() / "folder.png");
    TriangleFile file;
    file.json["images"] = {{{"uri", "folder.png"}}};
    expect_refused(Import(folder.write("m.gltf", file.gltf())),
                   "images[0].uri: \"folder.png\" is no regular file");
}

TEST(GltfRefusal, of_more_files_than_the_limit) {
    for (const std::size_t count : {limits::kReferencedFiles, limits::kReferencedFiles + 1}) {
        TriangleFile file;
        for (std::size_t i = 0; i < count; ++i) file.json["images"].push_back({{"uri", "a.png"}});
        EXPECT_EQ(import_bytes(file.gltf()).ok(), count == limits::kReferencedFiles);
    }
}

TEST(GltfRefusal, of_more_materials_than_the_limit) {
    for (const std::size_t count : {limits::kModelMaterials, limits::kModelMaterials + 1}) {
        TriangleFile file;
        for (std::size_t i = 0; i < count; ++i) file.json["materials"].push_back(Json::object());
        const Import import = import_bytes(file.gltf());
        EXPECT_EQ(import.ok(), count == limits::kModelMaterials);
        if (count > limits::kModelMaterials) {
            expect_refused(import, "it has 4097 materials; at most 4096 are read");
        }
    }
}

/// Fills a list up to `count` with copies of one more entry.
void fill(Json& list, std::size_t count, const Json& entry) {
    while (list.size() < count) list.push_back(entry);
}

TEST(GltfRefusal, of_more_nodes_meshes_and_accessors_than_their_limits) {
    for (const std::size_t above : {0U, 1U}) {
        TriangleFile nodes;
        fill(nodes.json["nodes"], limits::kModelNodes + above, Json::object());
        TriangleFile meshes;
        fill(meshes.json["meshes"], limits::kModelMeshes + above, Json::object());
        TriangleFile accessors;
        const Json accessor = accessors.json["accessors"][0];
        fill(accessors.json["accessors"], limits::kModelAccessors + above, accessor);
        if (above == 0) {
            EXPECT_TRUE(import_bytes(nodes.gltf()).ok());
            EXPECT_TRUE(import_bytes(meshes.gltf()).ok());
            EXPECT_TRUE(import_bytes(accessors.gltf()).ok());
        } else {
            expect_refused(nodes, "it has 65537 nodes; at most 65536 are read");
            expect_refused(meshes, "it has 16385 meshes; at most 16384 are read");
            expect_refused(accessors, "it has 65537 accessors; at most 65536 are read");
        }
    }
}

TEST(GltfRefusal, of_files_over_their_limit_before_they_are_read) {
    const TempFolder folder;
    const fs::path file = folder.write("m.glb", "glTF");
    fs::resize_file(file, limits::kModelFileBytes + 1);  // a hole: takes no room
    expect_refused(Import(file), "has 268435457 bytes; at most 268435456 are read");
}

}  // namespace
}  // namespace plumbline::assets::test
