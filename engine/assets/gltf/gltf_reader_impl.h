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

/// An object of the document, and what messages call it: "nodes[3]". What is not as it is asked for is a
/// fault.
struct GltfObject {
    const Json& json;
    std::string where;

    /// The array of that name; an empty one when it is absent.
    const Json& array(const char* key) const;
    /// Its elements, at most `limit` of them.
    std::vector<GltfObject> objects(const char* key, std::size_t limit) const;
    /// The object of that name, called as this one is; nothing when it is absent.
    std::optional<GltfObject> object(const char* key) const;
    /// A whole number, 0 or more; nothing when absent.
    std::optional<std::size_t> whole(const char* key) const;
    /// As above, and below `count`, the number of what there is.
    std::optional<std::size_t> index(const char* key, std::size_t count) const;
    std::string text(const char* key) const;
    float number(const char* key, float fallback) const;
    /// Exactly `size` numbers that floats can hold; empty when absent.
    std::vector<float> numbers(const char* key, std::size_t size) const;
    /// The same at full precision.
    std::vector<double> reals(const char* key, std::size_t size) const;
    std::optional<double> real(const char* key) const;
};
/// An element of the list that messages call `where`.
GltfObject object_at(const Json& list, std::size_t i, const std::string& where);

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
};

/// The bytes that an accessor's elements lie in: the first one's place, and how far the next ones are.
struct GltfElements {
    const std::string& bytes;
    std::size_t first{0};
    std::size_t stride{0};

    std::size_t place(std::size_t i) const { return first + i * stride; }
};

/// What of a material concerns the meshes that wear it: which texture coordinates its base colour
/// map takes, and how they lie (KHR_texture_transform).
struct GltfTexturePlace {
    std::size_t set{0};
    Vec2f offset{0.0F};
    float rotation_rad{0.0F};
    Vec2f scale{1.0F};
};

/// What the stages share.
struct GltfReader {
    GltfObject root;
    const std::string& name;  ///< of the model file, for messages
    ModelReferences& references;

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

    /// The elements of an array of the document, at most `limit` of them.
    std::vector<GltfObject> objects(const char* key, std::size_t limit) const;
};

/// GLB or plain text, told by the content.
GltfParts split_gltf(std::string_view bytes, const std::string& name);
/// Bracket depth first, without a stack; then the parser, refusing keys that come twice.
Json parse_json(std::string_view text);

void read_buffers(GltfReader& reader, std::optional<std::string_view> binary);
void read_views(GltfReader& reader);
void read_accessors(GltfReader& reader);
void read_materials(GltfReader& reader);
void read_meshes(GltfReader& reader);
void read_nodes(GltfReader& reader);
void read_skins(GltfReader& reader);
void read_animations(GltfReader& reader);
void read_physics(GltfReader& reader);

/// The JSON of `extras.plumbline`; empty where there is none.
std::string own_extras(const GltfObject& owner);
/// What hangs on a node of the document, in the scene or not, in the frame of that node. After read_nodes().
std::vector<ColliderMesh> meshes_below(const GltfReader& reader, std::size_t node);

/// Adds bytes of our own making as a buffer and a view over all of it; the view's number.
std::size_t add_buffer(GltfReader& reader, std::string bytes);
/// Bytes of one element: component size times component count; 0 for a type unknown.
std::size_t element_bytes(const GltfAccessor& accessor);
/// Numbers in one element: 3 for VEC3.
std::size_t component_count(std::string_view type);
GltfElements elements_of(const GltfReader& reader, const GltfAccessor& accessor);
/// Whether a component is an unsigned integer: 5121, 5123 or 5125.
bool is_whole(std::size_t component);
/// Such a one, of 1, 2 or 4 bytes, as it is stored.
std::uint32_t unsigned_at(const std::string& bytes, std::size_t place, unsigned component);
/// All numbers of an accessor in order; whole ones as they are, or as shares of their range when
/// the accessor is normalized.
/// The error is for files that use their accessors for more than fits into memory.
std::vector<float> floats_of(GltfReader& reader, const GltfAccessor& accessor);
/// The bytes behind a data URI.
std::string data_uri_bytes(std::string_view uri, const std::string& where);
/// A URI without its escapes; `where` is whose it is.
std::string decoded_uri(const std::string& uri, const std::string& where);
/// Where such a file is.
std::filesystem::path resolved(GltfReader& reader,
                               const std::string& reference,
                               const std::string& where);

}  // namespace plumbline::assets
