// What the head of a PLY file promises.
#include "engine/assets/mesh_files/ply_header_impl.h"
#include "engine/assets/model/model_readers_impl.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plumbline::assets::test {
namespace {

std::string fault_of(std::string_view bytes) {
    try {
        read_ply_header(bytes);
    } catch (const ModelFault& fault) {
        return fault.words;
    }
    return {};
}

std::string fault_of_header(std::string_view lines) {
    return fault_of(fmt::format("ply\nformat ascii 1.0\n{}end_header\n", lines));
}

TEST(PlyHeader, names_elements_properties_and_where_the_body_begins) {
    PlyHeader header = read_ply_header(
        "ply\r\nformat binary_big_endian 1.0\r\ncomment property none\r\n"
        "element vertex 2\r\nproperty float32 x\r\nproperty uint8 red\r\n"
        "element face 3\r\nproperty list uchar int16 vertex_indices\r\n"
        "end_header\r\nBODY\n");
    EXPECT_EQ(header.format, PlyFormat::Big);
    EXPECT_EQ(header.body, "BODY\n");
    ASSERT_EQ(header.elements.size(), 2U);
    EXPECT_EQ(header.elements[0].name, "vertex");
    EXPECT_EQ(header.elements[0].count, 2U);
    ASSERT_EQ(header.elements[0].properties.size(), 2U);
    EXPECT_EQ(header.elements[0].properties[1].name, "red");
    EXPECT_EQ(header.elements[0].properties[1].type->name, "uchar");
    EXPECT_EQ(header.elements[0].properties[1].count, nullptr);
    ASSERT_EQ(header.elements[1].properties.size(), 1U);
    EXPECT_EQ(header.elements[1].properties[0].type->name, "short");
    EXPECT_EQ(header.elements[1].properties[0].count->name, "uchar");
    // A vertex takes 5 bytes, a face at least its count.
    EXPECT_EQ(least_bytes_of(header), 2U * 5 + 3U * 1);
    header.format = PlyFormat::Text;
    EXPECT_EQ(least_bytes_of(header), 2U * 4 + 3U * 2) << "a digit and a blank a number";
}

TEST(PlyHeader, is_refused_with_what_is_wrong_in_it) {
    EXPECT_EQ(fault_of(""), "its content is not PLY");
    EXPECT_EQ(fault_of("plyx\n"), "its content is not PLY");
    EXPECT_EQ(fault_of("ply\nend_header\n"), "its header names no format");
    EXPECT_EQ(fault_of("ply\nformat ascii 1.0\n"), "its header breaks off");
    EXPECT_EQ(fault_of("ply\nformat ebcdic 1.0\n"), "its format \"ebcdic\" is unknown");
    EXPECT_EQ(fault_of_header("property float x\n"), "a property stands before any element");
    EXPECT_EQ(fault_of_header("element vertex\n"), "element vertex has no count");
    EXPECT_EQ(fault_of_header("element vertex -1\n"), "element vertex has no count");
    EXPECT_EQ(fault_of_header("element vertex 3x\n"), "element vertex has no count");
    EXPECT_EQ(fault_of_header("element vertex 30000001\n"), "30000001 vertex are too many");
    EXPECT_EQ(fault_of_header("element v 1\nproperty real x\n"), "the type \"real\" is unknown");
    EXPECT_EQ(fault_of_header("element v 1\nproperty list real int x\n"),
              "a list's length has an unknown type");
    EXPECT_EQ(fault_of_header("element v 1\nproperty list uchar real x\n"),
              "the type \"real\" is unknown");
}

TEST(PlyHeader, holds_64_elements_of_256_properties_and_no_more) {
    std::string elements;
    std::string properties = "element v 1\n";
    for (int i = 0; i < 64; ++i) elements += "element e 1\n";
    for (int i = 0; i < 256; ++i) properties += "property float x\n";
    EXPECT_EQ(fault_of_header(elements), "");
    EXPECT_EQ(fault_of_header(elements + "element e 1\n"), "it has too many elements");
    EXPECT_EQ(fault_of_header(properties), "");
    EXPECT_EQ(fault_of_header(properties + "property float x\n"), "it has too many properties");
}

}  // namespace
}  // namespace plumbline::assets::test
