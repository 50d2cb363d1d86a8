// PLY files to models: polygons, byte orders, colours, refusals.
#include "engine/assets/mesh_files/ply_import.h"

#include "engine/assets/model/model_readers_impl.h"
#include "tests/engine/assets/fixture.h"

#include <array>
#include <bit>
#include <cmath>

namespace plumbline::assets::test {
namespace {

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

/// What 8 bits of sRGB are in linear light.
float linear(int byte) {
    const double share = byte / 255.0;
    return static_cast<float>(share <= 0.04045 ? share / 12.92
                                               : std::pow((share + 0.055) / 1.055, 2.4));
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

// EXPERIENCE G25: a file may be cut while it is read.
TEST(PlyImport, of_a_cut_file_does_no_more_than_refuse) {
    for (const std::string& bytes :
         {std::string(kTextPly), binary_ply(std::endian::little), binary_ply(std::endian::big)}) {
        // Text may lose its last line end and still be whole.
        for (std::size_t length = 0; length + 1 < bytes.size(); ++length) {
            EXPECT_FALSE(read_ply(std::string_view(bytes).substr(0, length), "m.ply").ok())
                << length;
        }
    }
}

TEST(PlyImport, leaves_out_faces_that_cannot_be_drawn_and_counts_them) {
    std::string text(kTextPly);
    text.replace(text.find("face 1"), 6, "face 4");
    const Import import = import_bytes(text + "2 0 1\n3 0 1 4\n3 0 1 2\n", "m.ply");
    ASSERT_TRUE(import.ok()) << import.error();
    EXPECT_EQ(import.mesh().indices.size(), 9U);
    EXPECT_TRUE(contains(import.log,
                         "2 faces that name vertices it lacks, or no usable ones, are left out"))
        << import.log;
}

constexpr std::string_view kExactPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty uchar red\nproperty float green\nproperty float "
    "u\n"
    "property float v\nproperty list uchar int tags\nelement hair 1\nproperty int length\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 1 128 2.5 0.25 0.25 2 8 9\n1 0 0 0 0 0 0 0 0\n0 1 0 0 255 1 1 1 0\n7\n3 0 1 2\n";

TEST(PlyImport, takes_exact_files_to_the_letter) {
    const Result<ExactPly> ply = read_exact_ply(kExactPly, "m.ply");
    ASSERT_TRUE(ply.ok()) << ply.error().message;
    EXPECT_TRUE(ply->has_normals);
    EXPECT_TRUE(ply->has_uvs);
    ASSERT_EQ(ply->vertices.size(), 3U);
    const Vertex& first = ply->vertices[0];
    EXPECT_EQ(first.position_body, Vec3f(0, 0, 0)) << "nothing is turned";
    EXPECT_EQ(first.normal_body, Vec3f(1, 0, 0));
    EXPECT_NEAR(first.color.x, std::pow(128.0 / 255.0, 2.2), 1e-7) << "whole numbers are powers";
    EXPECT_EQ(first.color.y, 2.5F) << "floats are light";
    EXPECT_EQ(first.color.z, 1.0F) << "not in the file";
    EXPECT_EQ(first.uv, Vec2f(0.25F, 0.75F));
    EXPECT_EQ(ply->vertices[1].uv, Vec2f(0, 1));
    EXPECT_EQ(ply->indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(PlyImport, refuses_in_exact_files_what_it_leaves_out_of_models) {
    const auto error_of = [](std::string_view from, std::string_view to) {
        std::string text(kExactPly);
        text.replace(text.find(from), from.size(), to);
        const Result<ExactPly> ply = read_exact_ply(text, "m.ply");
        return ply.ok() ? std::string("read") : ply.error().message;
    };
    const std::string refused = "model m.ply is refused: ";
    EXPECT_EQ(error_of("3 0 1 2", "3 0 1 3"),
              refused + "face 0 names a vertex that is not there: it has 3");
    EXPECT_EQ(error_of("3 0 1 2", "2 0 1"), refused + "face 0 has 2 corners");
    EXPECT_EQ(error_of("128 2.5", "128 inf"), refused + "the colour of vertex 0 is not finite");
    EXPECT_EQ(error_of("0 1 0 0 255", "0 1e39 0 0 255"), refused + "vertex 2 is not finite");
    EXPECT_EQ(
        error_of("7\n3", "seven\n3"),
        refused + "it breaks off, or holds what is no number, in its element hair number 0 of 1");
    EXPECT_EQ(error_of("3 0 1 2", "-1 0 1 2"), refused + "a list has an impossible length");
}

// Beyond a double's range a number is not 0 but infinite, or nothing.
TEST(PlyImport, knows_numbers_too_large_and_too_small_for_a_double) {
    const auto with = [](std::string_view number) {
        std::string text(kExactPly);
        text.replace(text.find("1 0 0 0 0 0 0 0 0"), 1, number);
        return read_exact_ply(text, "m.ply");
    };
    for (const char* huge : {"1e999", "-1e999", "1E+999"}) {
        const Result<ExactPly> refused = with(huge);
        ASSERT_FALSE(refused.ok()) << huge;
        EXPECT_EQ(refused.error().message, "model m.ply is refused: vertex 1 is not finite");
    }
    ASSERT_TRUE(with("1e-999").ok());
    EXPECT_EQ(with("1e-999")->vertices[1].position_body, Vec3f(0, 0, 0));
}

}  // namespace
}  // namespace plumbline::assets::test
