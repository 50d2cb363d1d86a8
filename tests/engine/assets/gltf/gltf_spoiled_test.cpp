// glTF files that are sound but for one number.
#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <functional>

namespace plumbline::assets::test {
namespace {

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

}  // namespace
}  // namespace plumbline::assets::test
