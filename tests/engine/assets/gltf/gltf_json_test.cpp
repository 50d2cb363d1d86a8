// The two containers of glTF, and JSON before it is looked at.
#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

TEST(GltfJson, accepts_a_byte_order_mark) {
    EXPECT_TRUE(import_bytes("\xEF\xBB\xBF" + TriangleFile{}.gltf()).ok());
}

TEST(GltfJson, ignores_bytes_after_a_glb_with_a_warning) {
    const Import import = import_bytes(TriangleFile{}.glb() + "tail", "m.glb");
    EXPECT_TRUE(import.ok());
    EXPECT_TRUE(contains(import.log, "4 bytes after the GLB's end are ignored")) << import.log;
}

TEST(GltfJson, of_other_content_under_its_name) {
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

TEST(GltfJson, of_keys_that_come_twice) {
    expect_refused(import_bytes(R"({"asset":{"version":"2.0","version":"2.0"}})"),
                   "its JSON has the key \"version\" twice");
}

TEST(GltfJson, of_numbers_that_json_does_not_have) {
    expect_refused(import_bytes(R"({"asset":{"version":"2.0"},"extras":NaN})"), "its JSON is bad");
    expect_refused(import_bytes(R"({"asset":{"version":"2.0"},"extras":1e999})"),
                   "its JSON is bad");
}

TEST(GltfJson, of_200000_brackets) {
    const std::string many(100'000, '[');
    const std::string text = R"({"asset":{"version":"2.0"},"extras":)" + many;
    expect_refused(import_bytes(text), "its JSON nests deeper than 64");
    expect_refused(import_bytes(text + std::string(100'000, ']') + "}"),
                   "its JSON nests deeper than 64");
}

TEST(GltfJson, of_json_nesting_one_above_the_limit_but_not_at_it) {
    for (const std::size_t depth : {limits::kModelJsonDepth, limits::kModelJsonDepth + 1}) {
        TriangleFile file;
        std::string text = file.gltf();
        text.pop_back();  // the last bracket
        text += R"(,"extras":)" + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}";
        EXPECT_EQ(import_bytes(text).ok(), depth == limits::kModelJsonDepth);
    }
}

TEST(GltfJson, counts_no_brackets_within_texts) {
    TriangleFile file;
    file.json["extras"] = std::string(1000, '[') + "\\\"";
    EXPECT_TRUE(import_bytes(file.gltf()).ok());
}

TEST(GltfJson, of_json_over_its_limit_as_a_100_mib_data_uri_is) {
    TriangleFile file;
    file.json["extras"] = "";
    const std::size_t padding = limits::kModelJsonBytes - file.gltf().size();
    file.json["extras"] = std::string(padding, 'x');
    EXPECT_TRUE(import_bytes(file.gltf()).ok());
    file.json["extras"] = std::string(padding + 1, 'x');
    expect_refused(file, "its JSON has 33554433 bytes; at most 33554432 are read");
}

TEST(GltfJson, of_glb_headers_that_lie) {
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

TEST(GltfJson, survives_every_truncation_of_a_glb) {
    const std::string good = TriangleFile{}.glb();
    const TempFolder folder;
    for (std::size_t size = 0; size < good.size(); ++size) {
        const Import import(folder.write("m.glb", std::string_view(good).substr(0, size)));
        EXPECT_FALSE(import.ok()) << size;
    }
}

TEST(GltfJson, survives_every_flipped_byte_of_the_json) {
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

TEST(GltfJson, finds_the_two_parts_of_a_glb) {
    const std::string bytes = TriangleFile::glb_of("{}", "abc");
    const GltfParts parts = split_gltf(bytes, "m.glb");
    EXPECT_EQ(parts.json, "{}  ");
    EXPECT_EQ(parts.binary, std::string_view("abc\0", 4));
    // A second binary chunk is no GLB; a chunk of another kind is read over.
    std::string more = bytes + std::string("\0\0\0\0BIN\0", 8);
    const auto length = static_cast<char>(more.size());
    more[8] = length;
    expect_refused(import_bytes(more, "m.glb"), "the GLB's chunks are not JSON first, then binary");
    more.replace(more.size() - 4, 4, "ABCD");
    EXPECT_EQ(split_gltf(more, "m.glb").binary, std::string_view("abc\0", 4));
}

/// What is said of an object that cannot be read.
template <class Read>
std::string fault_of_reading(const char* text, const Read& read) {
    const Json document = Json::parse(text);
    try {
        read(GltfObject{.json = document, .where = "o"});
    } catch (const ModelFault& fault) {
        return fault.words;
    }
    return {};
}

TEST(GltfJson, gives_numbers_only_where_they_are_what_was_asked_for) {
    const Json document = Json::parse(R"({"n": 3, "list": [1, 2.5], "t": "x", "x": 0.5})");
    const GltfObject good{.json = document, .where = "o"};
    EXPECT_EQ(good.whole("n"), 3U);
    EXPECT_EQ(good.whole("none"), std::nullopt);
    EXPECT_EQ(good.index("n", 4), 3U);
    EXPECT_EQ(good.number("x", 9.0F), 0.5F);
    EXPECT_EQ(good.number("none", 9.0F), 9.0F);
    EXPECT_EQ(good.numbers("list", 2), (std::vector<float>{1, 2.5F}));
    EXPECT_EQ(good.text("t"), "x");

    const auto whole = [](const GltfObject& o) { o.whole("n"); };
    EXPECT_EQ(fault_of_reading(R"({"n": -1})", whole),
              "o.n is -1; it must be a whole number, 0 or more");
    const auto index = [](const GltfObject& o) { o.index("n", 3); };
    EXPECT_EQ(fault_of_reading(R"({"n": 3})", index), "o.n names number 3 of 3");
    const auto number = [](const GltfObject& o) { o.number("n", 0); };
    EXPECT_EQ(fault_of_reading(R"({"n": 1e39})", number), "o.n is not a number that fits");
    const auto numbers = [](const GltfObject& o) { o.numbers("n", 2); };
    for (const char* list : {R"({"n": [1]})", R"({"n": [1, 2, 3]})", R"({"n": [1, "2"]})"}) {
        EXPECT_EQ(fault_of_reading(list, numbers), "o.n must be 2 numbers") << list;
    }
    EXPECT_EQ(fault_of_reading(R"({"n": 7})", numbers), "o.n is not an array");
    const auto objects = [](const GltfObject& o) {
        const std::string name = "m";
        ModelReferences references("m.gltf", ".");
        const GltfReader reader{
            .root = {.json = o.json, .where = {}}, .name = name, .references = references};
        static_cast<void>(reader.objects("n", 2));
    };
    EXPECT_EQ(fault_of_reading(R"({"n": [{}, 1]})", objects), "n[1] is not an object");
    EXPECT_EQ(fault_of_reading(R"({"n": [{}, {}, {}]})", objects),
              "it has 3 n; at most 2 are read");
}

}  // namespace
}  // namespace plumbline::assets::test
