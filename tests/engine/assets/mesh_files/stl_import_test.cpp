// STL files, text or binary.
#include "engine/assets/model/model_readers_impl.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

constexpr std::string_view kTextStl =
    "solid plate\nfacet normal 9 9 9\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 0 2\n"
    "endloop\nendfacet\nendsolid\n";

std::string binary_stl(std::uint32_t promised) {
    std::string bytes = "solid is no proof of text";
    bytes.resize(80);
    append_bytes<std::uint32_t>(bytes, {promised});
    append_bytes<float>(bytes, {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    append_bytes<std::uint16_t>(bytes, {0});
    return bytes;
}

TEST(StlImport, refuses_what_it_cannot_be_sure_of) {
    const auto error_of = [](std::string_view from, std::string_view to) {
        std::string text(kTextStl);
        text.replace(text.find(from), from.size(), to);
        return import_bytes(text, "m.stl").error();
    };
    for (const char* number : {"nan", "inf", "1e999", "four", ""}) {
        EXPECT_TRUE(contains(error_of("vertex 4", std::string("vertex ") + number),
                             "line 5: a vertex must be three numbers"))
            << number;
    }
    EXPECT_TRUE(contains(error_of("endloop", "vertex 1 1 1"), "a facet has three vertices"));
    EXPECT_TRUE(contains(error_of("vertex 0 0 2", "vertex 8 0 0"), "it holds no triangles"));
    EXPECT_TRUE(contains(error_of("vertex 4", "vertex 9e9"), "it holds no triangles"));
    std::string wild = binary_stl(0xFFFFFFFF);
    wild[0] = 'x';
    EXPECT_TRUE(contains(import_bytes(wild, "m.stl").error(),
                         "it says 4294967295 triangles and has room for 1"));
    std::string not_finite = binary_stl(1);
    for (std::size_t i = 96; i < 100; ++i) not_finite[i] = '\xFF';  // a NaN
    EXPECT_TRUE(contains(import_bytes(not_finite, "m.stl").error(), "it holds no triangles"));
}

TEST(StlImport, keeps_facets_flat_and_turns_z_up) {
    const Import import = import_bytes(kTextStl, "m.stl");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices.size(), 3U);
    EXPECT_EQ(import.mesh().bounds.max, Vec3f(4, 2, 0));
    EXPECT_EQ(import.mesh().vertices[0].normal_body, Vec3f(0, 0, 1)) << "by winding";
}

TEST(StlImport, knows_binary_files_by_their_length) {
    const Import import = import_bytes(binary_stl(1), "m.stl");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 3U);
    std::string other = binary_stl(2);
    other[0] = 'x';
    EXPECT_TRUE(
        contains(import_bytes(other, "m.stl").error(), "it says 2 triangles and has room for 1"));
    EXPECT_TRUE(contains(import_bytes("solid x\nfacet\n", "m.stl").error(), "breaks off before"));
}

TEST(StlImport, of_a_cut_file_does_no_more_than_refuse) {
    for (const std::string& bytes : {std::string(kTextStl), binary_stl(1)}) {
        for (std::size_t length = 0; length + 1 < bytes.size(); ++length) {
            const Import import = import_bytes(bytes.substr(0, length), "m.stl");
            EXPECT_FALSE(import.ok()) << length;
        }
    }
}

TEST(StlImport, reads_several_facets_and_numbers_too_small_for_a_float) {
    const Result<ModelData> model = read_stl(
        "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 1e-60 0\nvertex 0 1 "
        "0\nendloop\nendfacet\n"
        "facet\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid",
        "m.stl");
    ASSERT_TRUE(model.ok()) << model.error().message;
    const ModelMesh& mesh = model->meshes[0];
    ASSERT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.vertices[1].position_body, Vec3f(1, 0, 0));
    EXPECT_EQ(mesh.vertices[0].normal_body, Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.vertices[3].normal_body, Vec3f(1, 0, 0));
}

}  // namespace
}  // namespace plumbline::assets::test
