// glTF files that are refused as a whole, each with the words a person gets to read.

#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <functional>

namespace plumbline::assets::test {
namespace {

/// Refused with exit code 4 and a message that ends in `why`.
void expect_refused(const Import& import, std::string_view why) {
    ASSERT_FALSE(import.ok()) << "expected: " << why;
    EXPECT_TRUE(contains(import.error(), why)) << import.error() << "\nexpected: " << why;
    EXPECT_EQ(import.model.error().exit_code, ExitCode::Refused);
    EXPECT_TRUE(import.error().starts_with("model ")) << import.error();
}

void expect_refused(const TriangleFile& file, std::string_view why) {
    expect_refused(import_bytes(file.gltf()), why);
}

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

struct Spoiled {
    std::string name;
    std::function<void(TriangleFile&)> spoil;
    std::string why;
};

void PrintTo(const Spoiled& file, std::ostream* out) {
    *out << file.name;
}

class GltfSpoiled : public ::testing::TestWithParam<Spoiled> {};

TEST_P(GltfSpoiled, is_refused) {
    TriangleFile file;
    GetParam().spoil(file);
    expect_refused(file, GetParam().why);
}

std::vector<Spoiled> node_faults() {
    return {
        {"cycle",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
         },
         "its nodes form a cycle: node 1 < node 2 < node 1"},
        {"own_child",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {0}; },
         "its nodes form a cycle: node 0 < node 0"},
        {"child_of_two",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
         },
         "node 2 is a child of node 0 and of node 1"},
        {"child_twice",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
         },
         "node 1 is a child of node 0 and of node 0"},
        {"node_7_of_1",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {7}; },
         "nodes[0].children names node 7 of 1"},
        {"negative_child",
         [](TriangleFile& f) { f.json["nodes"][0]["children"] = {-1}; },
         "nodes[0].children holds -1; it must name nodes by number"},
        {"mesh_out_of_range",
         [](TriangleFile& f) { f.json["nodes"][0]["mesh"] = 1; },
         "nodes[0].mesh names number 1 of 1"},
        {"scene_names_a_child",
         [](TriangleFile& f) {
             f.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
             f.json["scenes"][0]["nodes"] = {1};
         },
         "scenes[0].nodes names node 1, a child"},
        {"scene_out_of_range",
         [](TriangleFile& f) { f.json["scene"] = 1; },
         ".scene names number 1 of 1"},
        {"short_matrix",
         [](TriangleFile& f) {
             f.json["nodes"][0]["matrix"] = {1, 0, 0};
         },
         "nodes[0].matrix must be 16 numbers"},
        {"zero_rotation",
         [](TriangleFile& f) {
             f.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
         },
         "nodes[0].rotation is zero"},
        {"huge_translation",
         [](TriangleFile& f) {
             f.json["nodes"][0]["translation"] = {1e300, 0, 0};
         },
         "nodes[0].translation must be 3 numbers"},
        {"nodes_no_array", [](TriangleFile& f) { f.json["nodes"] = 3; }, "nodes is not an array"},
        {"node_no_object",
         [](TriangleFile& f) { f.json["nodes"] = {3}; },
         "nodes[0] is not an object"}};
}

std::vector<Spoiled> accessor_faults() {
    const auto accessor = [](const char* key, const Json& value) {
        return [key, value](TriangleFile& f) { f.json["accessors"][0][key] = value; };
    };
    return {{"past_its_view",
             accessor("count", 4),
             "accessors[0] runs past its bufferView: 48 bytes from 0 of 36"},
            {"offset_past_its_view",
             accessor("byteOffset", 1),
             "accessors[0] runs past its bufferView: 36 bytes from 1 of 36"},
            {"huge_offset",
             accessor("byteOffset", 18'446'744'073'709'551'615ULL),
             "accessors[0] runs past its bufferView"},
            {"count_1e9",
             accessor("count", 1'000'000'000),
             "accessors[0].count is 1000000000; 1 to 30000000 are read"},
            {"count_0", accessor("count", 0), "accessors[0].count is 0"},
            {"negative_offset",
             accessor("byteOffset", -4),
             "accessors[0].byteOffset is -4; it must be a whole number, 0 or more"},
            {"fractional_count", accessor("count", 2.5), "accessors[0].count is 2.5"},
            {"view_out_of_range",
             accessor("bufferView", 4),
             "accessors[0].bufferView names number 4 of 4"},
            {"unknown_component",
             accessor("componentType", 5130),
             "accessors[0]: componentType 5130 of type \"VEC3\" is unknown"},
            {"unknown_type",
             accessor("type", "VEC9"),
             "accessors[0]: componentType 5126 of type \"VEC9\" is unknown"},
            {"type_no_text", accessor("type", 3), "accessors[0].type is not a text"},
            {"stride_255",
             [](TriangleFile& f) { f.json["bufferViews"][0]["byteStride"] = 255; },
             "bufferViews[0].byteStride is 255; 4 to 252 in steps of 4 are allowed"},
            {"short_stride",
             [](TriangleFile& f) { f.json["bufferViews"][0]["byteStride"] = 8; },
             "accessors[0]: a stride of 8 is shorter than an element of 12 bytes"},
            {"view_past_its_buffer",
             [](TriangleFile& f) { f.json["bufferViews"][3]["byteLength"] = 9; },
             "bufferViews[3] runs past its buffer: 9 bytes from 96 of 104"},
            {"buffer_out_of_range",
             [](TriangleFile& f) { f.json["bufferViews"][0]["buffer"] = 1; },
             "bufferViews[0].buffer names number 1 of 1"},
            {"buffer_shorter_than_said",
             [](TriangleFile& f) { f.json["buffers"][0]["byteLength"] = 105; },
             "buffers[0] has 104 bytes; its byteLength says 105"},
            {"attribute_out_of_range",
             [](TriangleFile& f) { f.attributes()["NORMAL"] = 4; },
             "meshes[0].primitives[0].NORMAL names number 4 of 4"},
            {"attributes_of_unlike_length",
             [](TriangleFile& f) { f.json["accessors"][1]["count"] = 2; },
             "meshes[0].primitives[0].NORMAL has 2 elements, POSITION 3"},
            {"indices_out_of_range",
             [](TriangleFile& f) { f.primitive()["indices"] = 4; },
             "meshes[0].primitives[0].indices names number 4 of 4"},
            {"material_out_of_range",
             [](TriangleFile& f) { f.primitive()["material"] = 0; },
             "meshes[0].primitives[0].material names number 0 of 0"},
            {"unknown_mode",
             [](TriangleFile& f) { f.primitive()["mode"] = 7; },
             "meshes[0].primitives[0].mode is 7; 0 to 6 are known"},
            {"texture_out_of_range",
             [](TriangleFile& f) {
                 f.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
             },
             "materials[0].normalTexture.index names number 0 of 0"},
            {"needed_extension",
             [](TriangleFile& f) { f.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
             "it requires the extension \"KHR_draco_mesh_compression\", which is not read"}};
}

void make_sparse(TriangleFile& file, std::uint16_t index, int count) {
    std::string indices;
    append_bytes<std::uint16_t>(indices, {index, 0});
    std::string values;
    append_bytes<float>(values, {0, 7, 0});
    const std::size_t index_view = file.add_view(indices);
    const std::size_t value_view = file.add_view(values);
    file.json["accessors"][0]["sparse"] = {
        {"count", count},
        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
        {"values", {{"bufferView", value_view}}}};
}

std::vector<Spoiled> sparse_faults() {
    return {{"sparse_index",
             [](TriangleFile& f) { make_sparse(f, 3, 1); },
             "accessors[0].sparse: index 3 is out of range; the accessor has 3 elements"},
            {"sparse_count",
             [](TriangleFile& f) { make_sparse(f, 2, 4); },
             "accessors[0].sparse.count is 4; 1 to 3 fit"},
            {"sparse_values_past_their_view",
             [](TriangleFile& f) { make_sparse(f, 2, 2); },
             "accessors[0].sparse runs past its bufferView"},
            {"sparse_without_values",
             [](TriangleFile& f) {
                 f.json["accessors"][0]["sparse"] = {{"count", 1}};
             },
             "accessors[0].sparse must have indices and values"}};
}

std::string name_of(const ::testing::TestParamInfo<Spoiled>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Nodes, GltfSpoiled, ::testing::ValuesIn(node_faults()), name_of);
INSTANTIATE_TEST_SUITE_P(Accessors, GltfSpoiled, ::testing::ValuesIn(accessor_faults()), name_of);
INSTANTIATE_TEST_SUITE_P(Sparse, GltfSpoiled, ::testing::ValuesIn(sparse_faults()), name_of);

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
