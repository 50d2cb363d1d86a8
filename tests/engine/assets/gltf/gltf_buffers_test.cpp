// glTF buffers, views and accessors: where bytes come from, how they are read, what is refused.
#include "engine/assets/gltf/gltf_reader_impl.h"
#include "tests/engine/assets/fixture.h"
#include "tests/engine/assets/gltf/spoiled.h"

namespace plumbline::assets::test {
namespace {

TEST(GltfBuffers, reads_interleaved_vertices) {
    TriangleFile file;
    std::string vertices;
    append_bytes<float>(vertices, {0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 0, 4, 0, 0, 0, 1});
    const std::size_t view = file.add_view(vertices);
    file.json["bufferViews"][view]["byteStride"] = 24;
    file.json["accessors"][0]["bufferView"] = view;
    file.json["accessors"][1]["bufferView"] = view;
    file.json["accessors"][1]["byteOffset"] = 12;
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(3, 0, 0));
    EXPECT_EQ(import.mesh().vertices[2].position_body, Vec3f(0, 4, 0));
    EXPECT_EQ(import.mesh().vertices[2].normal_body, Vec3f(0, 0, 1));
}

TEST(GltfBuffers, applies_sparse_values) {
    TriangleFile file;
    std::string indices;
    append_bytes<std::uint16_t>(indices, {2, 0});
    std::string values;
    append_bytes<float>(values, {0, 7, 0});
    const std::size_t index_view = file.add_view(indices);
    const std::size_t value_view = file.add_view(values);
    file.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
        {"values", {{"bufferView", value_view}}}};
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[1].position_body, Vec3f(1, 0, 0));
    EXPECT_EQ(import.mesh().vertices[2].position_body, Vec3f(0, 7, 0));
}

TEST(GltfBuffers, opens_buffers_with_escaped_spaces_and_letters_beyond_ascii) {
    for (const auto& [uri, name] : {std::pair{"My%20File.bin", "My File.bin"},
                                    std::pair{"Gr%C3%BCn.bin", "Gr\xC3\xBCn.bin"},
                                    std::pair{"gr\xC3\xBCn.bin", "gr\xC3\xBCn.bin"},
                                    std::pair{"sub/./a.bin", "sub/a.bin"},
                                    std::pair{"a%2Bb.bin", "a+b.bin"}}) {
        TriangleFile file;
        const TempFolder folder;
        folder.write(name, file.bytes);
        file.json["buffers"][0]["uri"] = uri;
        const Import import(folder.write("m.gltf", file.json.dump()));
        EXPECT_TRUE(import.ok()) << uri << ": " << import.error();
    }
}

TEST(GltfBuffers, follows_links_that_stay_inside_the_root) {
    TriangleFile file;
    const TempFolder folder;
    folder.write("shared/a.bin", file.bytes);
    file.json["buffers"][0]["uri"] = "a.bin";
    const fs::path model = folder.write("models/m.gltf", file.json.dump());
    fs::create_symlink("../shared/a.bin", folder.path() / "models/a.bin");
    EXPECT_TRUE(Import(model, folder.path()).ok());
    const Import confined(model, folder.path() / "models");
    EXPECT_TRUE(contains(confined.error(),
                         "buffers[0].uri: \"a.bin\" leads out of the root folder through a link"))
        << confined.error();
}

struct BadUri {
    const char* uri;
    const char* why;
};

TEST(GltfBuffers, of_uris_that_lead_out_of_the_folder) {
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

TEST(GltfBuffers, of_bad_data_uris) {
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

class SpoiledBuffers : public ::testing::TestWithParam<Spoiled> {};

TEST_P(SpoiledBuffers, are_refused) {
    expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Accessors,
                         SpoiledBuffers,
                         ::testing::ValuesIn(accessor_faults()),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Sparse, SpoiledBuffers, ::testing::ValuesIn(sparse_faults()), name_of);

TEST(GltfBuffers, give_zeros_to_an_accessor_without_a_view) {
    TriangleFile file;
    file.json["accessors"][1].erase("bufferView");
    const Import import = import_bytes(file.gltf());
    ASSERT_TRUE(import.ok()) << import.error();
    // Normals of zero are made from the triangle.
    EXPECT_EQ(import.mesh().vertices[1].normal_body, Vec3f(0, 0, 1));
    EXPECT_EQ(import.model.value().meshes[0].vertices[1].normal_body, Vec3f(0, 0, 0));
}

TEST(GltfBuffers, stand_behind_a_uri_or_first_in_the_glb_and_nowhere_else) {
    TriangleFile file;
    file.json["buffers"].push_back({{"byteLength", 4}});
    expect_refused(import_bytes(file.glb(), "m.glb"),
                   "buffers[1] has neither a URI nor the GLB's binary chunk");
    file.json["buffers"].erase(1);
    expect_refused(import_bytes(file.json.dump()),
                   "buffers[0] has neither a URI nor the GLB's binary chunk");
    file.json["buffers"][0]["byteLength"] = 0;
    expect_refused(import_bytes(file.glb(), "m.glb"), "buffers[0].byteLength is missing or 0");
}

/// The numbers of one accessor over those bytes.
std::vector<float> numbers_of_bytes(std::string bytes, GltfAccessor accessor) {
    const Json document = Json::object();
    const std::string name = "m";
    ModelReferences references("m.gltf", ".");
    GltfReader reader{
        .root = {.json = document, .where = {}}, .name = name, .references = references};
    accessor.view = add_buffer(reader, std::move(bytes));
    return floats_of(reader, accessor);
}

TEST(GltfBuffers, scale_normalized_numbers_by_their_range_and_keep_others_whole) {
    const std::string bytes("\x80\x81\x7F\xFF", 4);
    using Floats = std::vector<float>;
    EXPECT_EQ(numbers_of_bytes(
                  bytes, {.count = 4, .component = 5120, .type = "SCALAR", .normalized = true}),
              (Floats{-1, -1, 1, -1.0F / 127}));  // -128 is -1 too
    EXPECT_EQ(numbers_of_bytes(bytes, {.count = 4, .component = 5120, .type = "SCALAR"}),
              (Floats{-128, -127, 127, -1}));
    EXPECT_EQ(numbers_of_bytes(bytes, {.count = 2, .component = 5121, .type = "VEC2"}),
              (Floats{128, 129, 127, 255}));
    EXPECT_EQ(numbers_of_bytes(bytes, {.count = 1, .component = 5122, .type = "VEC2"}),
              (Floats{static_cast<float>(0x8180 - 0x10000), static_cast<float>(0xFF7F - 0x10000)}));
    EXPECT_EQ(
        numbers_of_bytes(
            bytes,
            {.offset = 2, .count = 1, .component = 5123, .type = "SCALAR", .normalized = true}),
        (Floats{static_cast<float>(0xFF7F) * (1.0F / 65'535.0F)}));
    EXPECT_EQ(numbers_of_bytes(bytes, {.count = 1, .component = 5125, .type = "SCALAR"}),
              (Floats{static_cast<float>(0xFF7F8180)}));
}

}  // namespace
}  // namespace plumbline::assets::test
