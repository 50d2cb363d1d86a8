// Model files made in code, folders that clean up after themselves, and what a run logged.
#pragma once

#include "engine/assets/model_import.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets::test {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// A folder of its own below the build folder, removed at the end.
class TempFolder {
public:
    TempFolder() {
        std::string pattern = (fs::temp_directory_path() / "plumbline-assets-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~TempFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const fs::path& path() const { return path_; }
    fs::path write(const fs::path& name, std::string_view bytes) const {
        const fs::path file = path_ / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }

private:
    fs::path path_;
};

template <class T>
void append_bytes(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) {
        char raw[sizeof(T)];
        std::memcpy(raw, &value, sizeof(T));
        bytes.append(raw, sizeof(T));
    }
}

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8U;
            if (i + k < bytes.size()) bits |= static_cast<std::uint8_t>(bytes[i + k]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : kDigits[(bits >> (18U - 6U * k)) & 63U];
        }
    }
    return text;
}

/// A triangle (0,0,0) (1,0,0) (0,1,0) facing +z: accessor 0 positions, 1 normals, 2 texture
/// coordinates, 3 indices (16 bit); one view each, in one buffer. Tests change it at will.
struct TriangleFile {
    std::string bytes;
    Json json;

    TriangleFile() {
        append_bytes<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
        append_bytes<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1});
        append_bytes<float>(bytes, {0, 1, 1, 1, 0, 0.25F});
        append_bytes<std::uint16_t>(bytes, {0, 1, 2, 0});
        json = {{"asset", {{"version", "2.0"}}},
                {"buffers", {{{"byteLength", bytes.size()}}}},
                {"bufferViews",
                 {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}},
                  {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 36}},
                  {{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 24}},
                  {{"buffer", 0}, {"byteOffset", 96}, {"byteLength", 8}}}},
                {"accessors",
                 {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
                  {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
                  {{"bufferView", 2}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}},
                  {{"bufferView", 3}, {"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}}}},
                {"meshes",
                 {{{"name", "triangle"},
                   {"primitives",
                    {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}},
                      {"indices", 3}}}}}}},
                {"nodes", {{{"mesh", 0}}}},
                {"scenes", {{{"nodes", {0}}}}},
                {"scene", 0}};
    }

    Json& primitive(std::size_t mesh = 0) { return json["meshes"][mesh]["primitives"][0]; }
    Json& attributes() { return primitive()["attributes"]; }

    /// A node goes from x = 0 to 2 m in one second.
    void slide(int node) {
        std::string times;
        std::string places;
        append_bytes<float>(times, {0, 1});
        append_bytes<float>(places, {0, 0, 0, 2, 0, 0});
        animate(node,
                "translation",
                add_accessor(times, 5126, 2, "SCALAR"),
                add_accessor(places, 5126, 2, "VEC3"));
    }
    /// The triangle hangs on a "bone", node 1, that turns by half a turn about y in one second.
    void hang_on_turning_bone() {
        std::string joints;
        std::string weights;
        std::string times;
        std::string turns;
        for (int i = 0; i < 3; ++i) {
            append_bytes<std::uint8_t>(joints, {0, 0, 0, 0});
            append_bytes<float>(weights, {1, 0, 0, 0});
        }
        const float half = std::sqrt(0.5F);
        append_bytes<float>(times, {0, 0.5F, 1});
        append_bytes<float>(turns, {0, 0, 0, 1, 0, half, 0, half, 0, 1, 0, 0});
        attributes()["JOINTS_0"] = add_accessor(joints, 5121, 3, "VEC4");
        attributes()["WEIGHTS_0"] = add_accessor(weights, 5126, 3, "VEC4");
        json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"name", "bone"}}};
        json["scenes"][0]["nodes"] = {0, 1};
        json["skins"] = {{{"joints", {1}}}};
        animate(1,
                "rotation",
                add_accessor(times, 5126, 3, "SCALAR"),
                add_accessor(turns, 5126, 3, "VEC4"));
    }
    /// The file's only animation: one channel from accessors of times and values.
    void animate(int node, const char* path, std::size_t input, std::size_t output) {
        json["animations"] = {
            {{"samplers", {{{"input", input}, {"output", output}}}},
             {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}}};
    }

    /// A view over new bytes at the buffer's end; the view's number.
    std::size_t add_view(std::string_view more) {
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", more.size()}});
        bytes += more;
        json["buffers"][0]["byteLength"] = bytes.size();
        return json["bufferViews"].size() - 1;
    }
    std::size_t add_accessor(std::string_view more, int component, int count, const char* type) {
        const std::size_t view = add_view(more);
        json["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return json["accessors"].size() - 1;
    }

    /// One .gltf with its buffer as a data URI.
    std::string gltf() const {
        Json whole = json;
        whole["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
        return whole.dump();
    }

    std::string glb() const { return glb_of(json.dump(), bytes); }

    static std::string glb_of(std::string text, std::string binary) {
        while (text.size() % 4 != 0) text += ' ';
        while (binary.size() % 4 != 0) binary += '\0';
        std::string file = "glTF";
        append_bytes<std::uint32_t>(
            file,
            {2,
             static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()),
             static_cast<std::uint32_t>(text.size()),
             0x4E4F534A});
        file += text;
        append_bytes<std::uint32_t>(file, {static_cast<std::uint32_t>(binary.size()), 0x004E4942});
        return file + binary;
    }
};

/// The triangle as mesh 0, and as mesh 1 a copy that the caller spoils.
inline TriangleFile two_meshes() {
    TriangleFile file;
    file.json["meshes"].push_back(file.json["meshes"][0]);
    file.json["meshes"][1]["name"] = "spoilt";
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}}};
    file.json["scenes"][0]["nodes"] = {0, 1};
    return file;
}

/// An import whose log lines are kept.
struct Import {
    Result<ModelData> model;
    std::string log;

    explicit Import(const fs::path& file) : Import(file, file.parent_path()) {}
    Import(const fs::path& file, const fs::path& root)
        : model((::testing::internal::CaptureStderr(), import_model(file, root))),
          log(::testing::internal::GetCapturedStderr()) {}

    bool ok() const { return model.ok(); }
    std::string error() const { return model.ok() ? "" : model.error().message; }
    const MeshData& mesh() const { return model.value().mesh; }
    const std::vector<MaterialData>& materials() const { return model.value().materials; }
};

/// Imports bytes under a name in a fresh folder.
inline Import import_bytes(std::string_view bytes, const char* name = "m.gltf") {
    const TempFolder folder;
    return Import(folder.write(name, bytes));
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Refused with exit code 4 and a message that ends in `why`.
inline void expect_refused(const Import& import, std::string_view why) {
    ASSERT_FALSE(import.ok()) << "expected: " << why;
    EXPECT_TRUE(contains(import.error(), why)) << import.error() << "\nexpected: " << why;
    EXPECT_EQ(import.model.error().exit_code, ExitCode::Refused);
    EXPECT_TRUE(import.error().starts_with("model ")) << import.error();
}

inline void expect_refused(const TriangleFile& file, std::string_view why) {
    expect_refused(import_bytes(file.gltf()), why);
}

}  // namespace plumbline::assets::test
