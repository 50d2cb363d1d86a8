// glTF files that are refused as a whole, each with the words a person gets to read.

#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <functional>

namespace plumbline::assets::test {
namespace {

TEST(GltfRefusal, of_other_content_under_its_name) {
    expect_refused(import_bytes("IDPO\x06\0\0\0"),
                   "its content is not glTF: neither JSON nor a GLB");
    expect_refused(import_bytes(""), "its content is not glTF");
    expect_refused(import_bytes("v 0 0 0\nf 1 1 1\n"), "its content is not glTF");
    expect_refused(import_bytes("[1]"), "its content is not glTF");
    expect_refused(import_bytes("{}"), "it has no \"asset\"; it is not glTF 2");
    expect_refused(import_bytes(R"({"asset":{"version":"1.0"}})"), "it is glTF version \"1.0\"");
    expect_refused(import_bytes("{\"asset\":"), "its JSON is bad: parse error at line 1");
    expect_refused(import_bytes(R"({"asset":{"version":"2.0"}})"), "it holds no triangles");
}

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

TEST(GltfRefusal, of_keys_that_come_twice) {
    expect_refused(import_bytes(R"({"asset":{"version":"2.0","version":"2.0"}})"),
                   "its JSON has the key \"version\" twice");
}

TEST(GltfRefusal, of_numbers_that_json_does_not_have) {
    expect_refused(import_bytes(R"({"asset":{"version":"2.0"},"extras":NaN})"), "its JSON is bad");
    expect_refused(import_bytes(R"({"asset":{"version":"2.0"},"extras":1e999})"),
                   "its JSON is bad");
}

TEST(GltfRefusal, of_a_chain_of_100000_nodes) {
    Json nodes = Json::array();
    for (int i = 0; i < 99'999; ++i) nodes.push_back({{"children", {i + 1}}});
    nodes.push_back({{"mesh", 0}});
    TriangleFile file;
    file.json["nodes"] = std::move(nodes);
    expect_refused(file, "it has 100000 nodes; at most 65536 are read");
}

TEST(GltfRefusal, of_nodes_nested_too_deep) {
    for (const std::size_t depth : {limits::kModelNodeDepth, limits::kModelNodeDepth + 1}) {
        TriangleFile file;
        file.json["nodes"] = Json::array();
        for (std::size_t i = 0; i + 1 < depth; ++i) {
            file.json["nodes"].push_back({{"children", {i + 1}}});
        }
        file.json["nodes"].push_back({{"mesh", 0}});
        const Import import = import_bytes(file.gltf());
        EXPECT_EQ(import.ok(), depth == limits::kModelNodeDepth) << import.error();
        if (depth > limits::kModelNodeDepth) {
            expect_refused(import, "nodes[256] is nested deeper than 256");
        }
    }
}

TEST(GltfRefusal, of_200000_brackets) {
    const std::string many(100'000, '[');
    const std::string text = R"({"asset":{"version":"2.0"},"extras":)" + many;
    expect_refused(import_bytes(text), "its JSON nests deeper than 64");
    expect_refused(import_bytes(text + std::string(100'000, ']') + "}"),
                   "its JSON nests deeper than 64");
}

TEST(GltfRefusal, of_json_nesting_one_above_the_limit_but_not_at_it) {
    for (const std::size_t depth : {limits::kModelJsonDepth, limits::kModelJsonDepth + 1}) {
        TriangleFile file;
        std::string text = file.gltf();
        text.pop_back();  // the last bracket
        text += R"(,"extras":)" + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}";
        EXPECT_EQ(import_bytes(text).ok(), depth == limits::kModelJsonDepth);
    }
}

TEST(GltfRefusal, counts_no_brackets_within_texts) {
    TriangleFile file;
    file.json["extras"] = std::string(1000, '[') + "\\\"";
    EXPECT_TRUE(import_bytes(file.gltf()).ok());
}

struct BadUri {
    const char* uri;
    const char* why;
};

TEST(GltfRefusal, of_uris_that_lead_out_of_the_folder) {
    const TempFolder folder;
    folder.write("x.bin", TriangleFile{}.bytes);  // what they try to reach is there
    for (const BadUri& bad : {BadUri{"../x.bin", "\"../x.bin\" leads out of its folder"},
                              BadUri{"%2e%2e/x.bin", "\"../x.bin\" leads out of its folder"},
                              BadUri{"%2E%2E%2Fx.bin", "\"../x.bin\" leads out of its folder"},
                              BadUri{"a/../../x.bin", "leads out of its folder"},
                              BadUri{"/etc/hostname", "is absolute; paths are relative"},
                              BadUri{"%2Fetc/hostname", "is absolute; paths are relative"},
                              BadUri{"..\\x.bin", "holds a backslash"},
                              BadUri{"a%5Cx.bin", "holds a backslash"},
                              BadUri{"C:/x.bin", "names a drive or a URL"},
                              BadUri{"file:///etc/hostname", "names a drive or a URL"},
                              BadUri{"https://example.org/x.bin", "names a drive or a URL"},
                              BadUri{"%00x.bin", "has a bad percent escape"},
                              BadUri{"%zz.bin", "has a bad percent escape"},
                              BadUri{"x%2", "has a bad percent escape"},
                              BadUri{"%252e%252e/x.bin", "cannot open"},  // decoded once only
                              BadUri{"absent.bin", "cannot open"}}) {
        TriangleFile file;
        file.json["buffers"][0]["uri"] = bad.uri;
        const Import buffer(folder.write("models/m.gltf", file.json.dump()), folder.path());
        expect_refused(buffer, bad.why);
        EXPECT_TRUE(contains(buffer.error(), "buffers[0]")) << buffer.error();
        if (std::string_view(bad.why) == "cannot open") continue;  // images may be missing
        TriangleFile image;
        image.json["images"] = {{{"uri", bad.uri}}};
        const std::string text = image.gltf();
        const Import import(folder.write("models/i.gltf", text), folder.path());
        expect_refused(import, bad.why);
        EXPECT_TRUE(contains(import.error(), "images[0].uri")) << import.error();
    }
}

TEST(GltfRefusal, of_images_that_are_no_regular_files) {
    const TempFolder folder;
    fs::create_directory(folder.path() / "folder.png");
    TriangleFile file;
    file.json["images"] = {{{"uri", "folder.png"}}};
    expect_refused(Import(folder.write("m.gltf", file.gltf())),
                   "images[0].uri: \"folder.png\" is no regular file");
}

TEST(GltfRefusal, of_bad_data_uris) {
    for (const auto& [uri, why] :
         {std::pair{"data:application/octet-stream;base64,AA*A", "buffers[0].uri holds bad base64"},
          std::pair{"data:application/octet-stream;base64,AAA", "buffers[0].uri holds bad base64"},
          std::pair{"data:application/octet-stream;base64,AA=A", "buffers[0].uri holds bad base64"},
          std::pair{"data:text/plain,abc", "is a data URI that is not base64"},
          std::pair{"data:", "is a data URI that is not base64"},
          std::pair{"data:;base64,AAAA", "buffers[0] has 3 bytes; its byteLength says 104"}}) {
        TriangleFile file;
        file.json["buffers"][0]["uri"] = uri;
        expect_refused(import_bytes(file.json.dump()), why);
    }
}

TEST(GltfRefusal, of_json_over_its_limit_as_a_100_mib_data_uri_is) {
    TriangleFile file;
    file.json["extras"] = "";
    const std::size_t padding = limits::kModelJsonBytes - file.gltf().size();
    file.json["extras"] = std::string(padding, 'x');
    EXPECT_TRUE(import_bytes(file.gltf()).ok());
    file.json["extras"] = std::string(padding + 1, 'x');
    expect_refused(file, "its JSON has 33554433 bytes; at most 33554432 are read");
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

TEST(GltfRefusal, of_more_vertices_drawn_than_the_limit_before_they_are_built) {
    TriangleFile file;
    // 200 vertices, drawn by 50,001 nodes: ten million and two hundred.
    file.primitive()["attributes"] = {
        {"POSITION", file.add_accessor(std::string(200 * 12, '\0'), 5126, 200, "VEC3")}};
    file.json["nodes"] = Json::array();
    Json& roots = file.json["scenes"][0]["nodes"] = Json::array();
    for (int i = 0; i < 50'001; ++i) {
        file.json["nodes"].push_back({{"mesh", 0}});
        roots.push_back(i);
    }
    expect_refused(file, "it draws 10000200 vertices; at most 10000000 are read");
}

TEST(GltfRefusal, of_glb_headers_that_lie) {
    const std::string good = TriangleFile{}.glb();
    const auto with_u32 = [&](std::size_t place, std::uint32_t value) {
        std::string bytes = good;
        std::memcpy(bytes.data() + place, &value, sizeof(value));
        return import_bytes(bytes, "m.glb");
    };
    expect_refused(with_u32(4, 1), "it is GLB version 1; 2 is read");
    expect_refused(
        with_u32(8, static_cast<std::uint32_t>(good.size() + 1)),
        fmt::format("the GLB header says {} bytes, the file has {}", good.size() + 1, good.size()));
    expect_refused(with_u32(8, 12), "the GLB header says 12 bytes");
    expect_refused(with_u32(12, 0x7FFFFFFF), "chunk 0 of the GLB says 2147483647 bytes");
    expect_refused(with_u32(16, 0x004E4942), "the GLB's chunks are not JSON first, then binary");
    expect_refused(import_bytes(good.substr(0, 16), "m.glb"), "the GLB breaks off");
    expect_refused(import_bytes(good.substr(0, good.size() - 5), "m.glb"), "the GLB header says");
}

TEST(GltfRefusal, survives_every_truncation_of_a_glb) {
    const std::string good = TriangleFile{}.glb();
    const TempFolder folder;
    for (std::size_t size = 0; size < good.size(); size += 7) {
        const Import import(folder.write("m.glb", std::string_view(good).substr(0, size)));
        EXPECT_FALSE(import.ok()) << size;
    }
}

TEST(GltfRefusal, survives_every_flipped_byte_of_the_json) {
    const std::string good = TriangleFile{}.gltf();
    const TempFolder folder;
    std::size_t loaded = 0;
    for (std::size_t i = 0; i < good.size(); i += 5) {
        std::string bytes = good;
        bytes[i] = static_cast<char>(bytes[i] ^ 1);
        const Import import(folder.write("m.gltf", bytes));
        if (import.ok()) {
            ++loaded;
            EXPECT_LE(import.mesh().indices.size(), 3U);
        }
    }
    EXPECT_GT(loaded, 0U);  // a letter in a name changes nothing
}

}  // namespace
}  // namespace plumbline::assets::test
