// What the readers of JSON scenes share. Internal to the scene module.
#pragma once

#include "engine/assets/mesh_data.h"
#include "engine/assets/mesh_files/ply_import.h"
#include "engine/core/math.h"
#include "engine/scene/formats/scene_reader.h"

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

/// Where faults of one JSON file go. JSON values do not know their lines: the path tells them apart.
struct JsonFaults {
    FaultList& list;
    const SourceLocation& file;

    /// Says it; nothing, for who then returns nothing.
    std::nullopt_t error(std::string path, std::string message) const {
        list.error(file, std::move(path), std::move(message));
        return std::nullopt;
    }
    template <class... Parts>
    std::nullopt_t error(std::string path,
                         fmt::format_string<Parts...> message,
                         Parts&&... parts) const {
        return error(std::move(path), fmt::format(message, std::forward<Parts>(parts)...));
    }
};

// --- json_scene_values.cpp
/// The member, or null; null also where `object` is none.
const nlohmann::json* member_of(const nlohmann::json& object, std::string_view key);
/// Three numbers under a key.
std::optional<glm::dvec3> json_vector(const nlohmann::json& value,
                                      const std::string& path,
                                      const JsonFaults& faults);
/// Finite numbers; `count` 0: any number of them.
std::optional<std::vector<double>> json_numbers(const nlohmann::json& value,
                                                std::size_t count,
                                                const std::string& path,
                                                const JsonFaults& faults);
/// A number above 0; `fallback` where it is absent or wrong.
double json_positive(const nlohmann::json& object,
                     std::string_view key,
                     double fallback,
                     const std::string& path,
                     const JsonFaults& faults);
struct JsonTransform {
    glm::dmat4 matrix{1.0};
    std::optional<Vec3d> up{};  ///< of its last lookat
};
/// The elements in their order, the first one acting first.
JsonTransform json_transform(const nlohmann::json& object,
                             const std::string& path,
                             const JsonFaults& faults);

// --- json_scene_mesh.cpp
/// Triangles before their transform.
struct JsonMesh {
    assets::ExactPly triangles;
    std::uint64_t hash{0};  ///< of what they were read from
};
/// The arrays of an object without a file.
std::optional<JsonMesh> json_inline_mesh(const nlohmann::json& object,
                                         const std::string& path,
                                         const JsonFaults& faults);
/// Turned and scaled. Without normals in the source every triangle is flat. Colours are divided by
/// `brightest`, which is 1 or more.
assets::MeshData json_mesh_data(const assets::ExactPly& source,
                                const glm::dmat3& linear,
                                float brightest);
float brightest_of(const assets::ExactPly& mesh);

}  // namespace plumbline::scene
