// The glTF 2 reader, stage by stage: each reads a part of the document, refuses what is unsafe, and
// adds the rest to `model`. Private to engine/assets.
#pragma once

#include "engine/assets/model/model_readers_impl.h"
#include "engine/core/limits.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets {

using Json = nlohmann::json;

/// The two parts of a model file, .glb or .gltf.
struct GltfParts {
    std::string_view json;
    std::optional<std::string_view> binary;
};

struct GltfView {
    std::size_t buffer{0};
    std::size_t offset{0};
    std::size_t size{0};
    std::size_t stride{0};  ///< 0: packed
};

struct GltfAccessor {
    std::optional<std::size_t> view;
    std::size_t offset{0};
    std::size_t count{0};
    unsigned component{0};  ///< GL's number: 5120 to 5126
    std::string type;       ///< "VEC3"
    bool normalized{false};
    bool sparse{false};
};

/// What of a material concerns the meshes that wear it: which texture coordinates its base colour
/// map takes, and how they lie (KHR_texture_transform).
struct GltfTexturePlace {
    std::size_t set{0};
    Vec2f offset{0.0F};
    float rotation_rad{0.0F};
    Vec2f scale{1.0F};
};

/// What the stages share. The first fault ends the reading: stages return when `failed()`.
struct GltfReader {
    const Json& document;
    const std::string& name;  ///< of the model file, for messages
    ModelReferences& references;

    std::string fault{};
    ModelData model{};
    std::vector<std::string> buffers{};
    std::size_t buffer_bytes{0};                       ///< of all of them
    std::size_t numbers_left{limits::kVertices * 12};  ///< that may still be read from accessors
    std::vector<GltfView> views{};
    std::vector<GltfAccessor> accessors{};
    std::vector<GltfTexturePlace> texture_places{};           ///< by material
    std::vector<std::vector<std::uint32_t>> mesh_parts{};     ///< by mesh: ModelData::meshes
    std::vector<std::vector<float>> mesh_weights{};           ///< by mesh: of its targets
    std::vector<std::optional<std::uint32_t>> node_places{};  ///< by node: ModelData::nodes

    bool failed() const { return !fault.empty(); }
    template <class... Args>
    void fail(fmt::format_string<Args...> format, Args&&... args) {
        if (fault.empty()) fault = fmt::format(format, std::forward<Args>(args)...);
    }

    /// The array of that name; an empty one when it is absent or (a fault) something else.
    const Json& array(const Json& object, const char* key, std::string_view where);
    /// Elements must be objects.
    const Json& objects(const char* key, std::size_t limit);
    /// A whole number, 0 or more; nothing when absent or (a fault) something else.
    std::optional<std::size_t> whole(const Json& object, const char* key, std::string_view where);
    /// As above, and below `count`, the number of `what` that there are.
    std::optional<std::size_t> index(const Json& object,
                                     const char* key,
                                     std::string_view where,
                                     std::size_t count);
    std::string text(const Json& object, const char* key, std::string_view where);
    float number(const Json& object, const char* key, std::string_view where, float fallback);
    /// Exactly `size` numbers that floats can hold; empty when absent or (a fault) something else.
    std::vector<float> numbers(const Json& object,
                               const char* key,
                               std::string_view where,
                               std::size_t size);
};

/// GLB or plain text, told by the content.
Result<GltfParts> split_gltf(std::string_view bytes, const std::string& name);
/// Bracket depth first, without a stack; then the parser, refusing keys that come twice.
Result<Json> parse_json(std::string_view text, const std::string& name);

void read_buffers(GltfReader& reader, std::optional<std::string_view> binary);
void read_views(GltfReader& reader);
void read_accessors(GltfReader& reader);
void read_materials(GltfReader& reader);
void read_meshes(GltfReader& reader);
void read_nodes(GltfReader& reader);
void read_skins(GltfReader& reader);
void read_animations(GltfReader& reader);

/// Adds bytes of our own making as a buffer and a view over all of it; the view's number.
std::size_t add_buffer(GltfReader& reader, std::string bytes);
/// Bytes of one element: component size times component count; 0 for a type unknown.
std::size_t element_bytes(const GltfAccessor& accessor);
/// Numbers in one element: 3 for VEC3.
std::size_t component_count(std::string_view type);
/// An unsigned integer of 1, 2 or 4 bytes, as components 5121, 5123, 5125 are stored.
std::uint32_t unsigned_at(const std::string& bytes, std::size_t place, unsigned component);
/// All numbers of an accessor in order; whole ones as they are, or as shares of their range when
/// the accessor is normalized.
/// The error is for files that use their accessors for more than fits into memory.
std::vector<float> floats_of(GltfReader& reader, const GltfAccessor& accessor);
/// The bytes behind a data URI; a fault leaves them empty.
std::string data_uri_bytes(GltfReader& reader, std::string_view uri, const std::string& where);

}  // namespace plumbline::assets
