// PLY and STL by our own readers, OBJ with colours: counts, colours and places known beforehand, and
// every file cut at every length.

#include "engine/assets/foreign/foreign_import.h"
#include "engine/assets/foreign/model_wire.h"
#include "engine/assets/model/model_pose.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

/// What 8 bits of sRGB are in linear light.
float linear(int byte) {
    const double share = byte / 255.0;
    return static_cast<float>(share <= 0.04045 ? share / 12.92
                                               : std::pow((share + 0.055) / 1.055, 2.4));
}

constexpr std::string_view kTextPly =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\n"
    "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 255 0 0\n2 0 0 0 255 0\n2 0 1 0 0 128\n0 0 1 255 255 255\n4 0 1 2 3\n";

std::string binary_ply(std::endian order) {
    std::string bytes = "ply\nformat binary_";
    bytes += order == std::endian::little ? "little" : "big";
    bytes +=
        "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar uint vertex_index\nproperty short flags\n"
        "end_header\n";
    const auto put = [&](auto value) {
        char raw[sizeof(value)];
        std::memcpy(raw, &value, sizeof(value));
        if (order != std::endian::native) std::reverse(raw, raw + sizeof(value));
        bytes.append(raw, sizeof(value));
    };
    for (const auto& corner : {std::array{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 0.0, 5.0}}) {
        put(corner[0]);
        put(static_cast<float>(corner[1]));
        put(static_cast<float>(corner[2]));
    }
    put(std::uint8_t{3});
    for (const std::uint32_t index : {0U, 1U, 2U}) put(index);
    put(std::int16_t{7});
    return bytes;
}

TEST(PlyImport, splits_polygons_turns_z_up_and_shows_colours_in_linear_light) {
    const Import import = import_bytes(kTextPly, "m.ply");
    ASSERT_TRUE(import.ok()) << import.error();
    const MeshData& mesh = import.mesh();
    EXPECT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.bounds.max, Vec3f(2, 1, 0));
    EXPECT_EQ(mesh.vertices[0].color, Vec3f(1, 0, 0));
    EXPECT_NEAR(mesh.vertices[2].color.z, linear(128), 1e-6);
    EXPECT_TRUE(import.materials()[0].vertex_colors);
    // Normals are made: the file's -y is our +z.
    EXPECT_NEAR(glm::length(mesh.vertices[0].normal_body - Vec3f(0, 0, 1)), 0, 1e-6);
}

TEST(PlyImport, reads_both_byte_orders_alike) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const Import import = import_bytes(binary_ply(order), "m.PLY");
        ASSERT_TRUE(import.ok()) << import.error();
        EXPECT_EQ(import.mesh().vertices.size(), 3U);
        EXPECT_EQ(import.mesh().bounds.max, Vec3f(3, 5, 0));
    }
}

TEST(PlyImport, refuses_what_it_cannot_be_sure_of) {
    const auto error_of = [](std::string text, std::string_view from, std::string_view to) {
        const std::size_t place = text.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        return import_bytes(text.replace(place, from.size(), to), "m.ply").error();
    };
    const std::string good(kTextPly);
    EXPECT_TRUE(contains(error_of(good, "ply\n", "plo\n"), "its content is not PLY"));
    EXPECT_TRUE(contains(error_of(good, "vertex 4", "vertex 4000000000"), "are too many"));
    EXPECT_TRUE(contains(error_of(good, "vertex 4", "vertex 900"),
                         "its header promises 10802 bytes or more; 70 follow"));
    EXPECT_TRUE(contains(error_of(good, "float z", "float w"), "its vertices have no x, y and z"));
    EXPECT_TRUE(contains(error_of(good, "2 0 1 0", "2 0 nan 0"), "vertex 2 is not finite"));
    EXPECT_TRUE(contains(error_of(good, "2 0 1 0", "2 0 x 0"),
                         "it breaks off, or holds what is no number, in its element vertex"));
    EXPECT_TRUE(contains(error_of(good, "4 0 1 2 3", "4 0 1 2 9"), "it holds no triangles"));
    EXPECT_TRUE(contains(error_of(good, "ascii", "base64"), "its format \"base64\" is unknown"));
}

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

TEST(ObjImport, shows_colours_behind_the_places) {
    const Import import =
        import_bytes("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0 0 0 1\nf 1 2 3\n", "m.obj");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().vertices[0].color, Vec3f(1, 0, 0));
    EXPECT_NEAR(import.mesh().vertices[1].color.y, 0.21404F, 1e-4);
    EXPECT_TRUE(import.materials()[0].vertex_colors);
}

/// Two crossed triangles with a name, a material and a keyed node, as Collada writes them.
constexpr std::string_view kCollada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="red-fx"><profile_COMMON><technique sid="common"><lambert>
<diffuse><color>0.5 0 0 1</color></diffuse></lambert></technique></profile_COMMON></effect>
</library_effects>
<library_materials><material id="red" name="red"><instance_effect url="#red-fx"/></material>
</library_materials>
<library_geometries><geometry id="g" name="plate"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 100 0 0 0 0 200</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="m"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p>
</triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="arm">
<instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#red"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

TEST(ForeignImport, takes_units_up_axis_names_and_materials_from_a_collada_file) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    ASSERT_EQ(model->meshes.size(), 1U);
    EXPECT_EQ(model->meshes[0].vertices.size(), 3U);
    EXPECT_NEAR(model->materials[model->meshes[0].material].base_color.x, 0.5, 1e-6);
    const MeshData mesh = merged_mesh(*model, rest_pose(*model), "m.dae");
    // Centimetres, z up: 1 m wide, 2 m high.
    EXPECT_NEAR(glm::length(mesh.bounds.max - Vec3f(1, 2, 0)), 0, 1e-4)
        << mesh.bounds.max.x << ' ' << mesh.bounds.max.y << ' ' << mesh.bounds.max.z;
}

TEST(ForeignImport, hands_a_model_over_as_bytes_without_loss) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    const std::string bytes = bytes_of(*model);
    const Result<ModelData> again = model_of_bytes(bytes);
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(bytes_of(*again), bytes);
    EXPECT_EQ(again->nodes.size(), model->nodes.size());
}

TEST(ForeignImport, refuses_an_answer_that_is_cut_or_lies) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    const std::string bytes = bytes_of(*model);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_FALSE(model_of_bytes(std::string_view(bytes).substr(0, length)).ok()) << length;
    }
    ModelData lying = *model;
    lying.meshes[0].indices[1] = 3;
    const Result<ModelData> refused = model_of_bytes(bytes_of(lying));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message, "mesh 0 names vertices that it lacks");
}

// EXPERIENCE G25: a file may be cut while it is read.
TEST(CutFiles, never_do_more_than_be_refused) {
    const std::vector<std::pair<const char*, std::string>> files{
        {"m.ply", std::string(kTextPly)},
        {"m.ply", binary_ply(std::endian::little)},
        {"m.stl", binary_stl(1)},
        {"m.stl", std::string(kTextStl)},
        {"m.glb", TriangleFile{}.glb()}};
    const TempFolder folder;
    for (const auto& [name, bytes] : files) {
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const Import import(folder.write(name, std::string_view(bytes).substr(0, length)));
            // Text may lose its last line end and still be whole.
            if (length + 1 == bytes.size()) continue;
            EXPECT_FALSE(import.ok()) << name << ' ' << length;
        }
    }
}

}  // namespace
}  // namespace plumbline::assets::test
