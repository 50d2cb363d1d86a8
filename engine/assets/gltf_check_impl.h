// The glTF pre-check, stage by stage: each reads a part of the document, refuses what is unsafe,
// and writes the rest anew into `clean`. Private to engine/assets.
#pragma once

#include "engine/assets/checked_model.h"

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

/// What the stages share. The first fault ends the check: stages return when `failed()`.
struct GltfCheck {
    const Json& document;
    const std::string& name;  ///< of the model file, for messages
    ModelReferences& references;

    std::string fault{};
    Json clean{};
    std::vector<std::string> buffers{};
    std::size_t buffer_bytes{0};  ///< of all of them
    std::vector<GltfView> views{};
    std::vector<GltfAccessor> accessors{};
    std::vector<std::size_t> vertex_counts{};  ///< by mesh, what is kept of it
    std::vector<std::size_t> index_counts{};
    std::vector<MaterialData> materials{};

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

void check_buffers(GltfCheck& check, std::optional<std::string_view> binary);
void check_views(GltfCheck& check);
void check_accessors(GltfCheck& check);
void check_materials(GltfCheck& check);
void check_meshes(GltfCheck& check);
void check_nodes(GltfCheck& check);

/// Adds bytes of our own making as a buffer and a view over all of it; the view's number.
std::size_t add_buffer(GltfCheck& check, std::string bytes);
/// Bytes of one element: component size times component count; 0 for a type unknown.
std::size_t element_bytes(const GltfAccessor& accessor);
/// An unsigned integer of 1, 2 or 4 bytes, as components 5121, 5123, 5125 are stored.
std::uint32_t unsigned_at(const std::string& bytes, std::size_t place, unsigned component);

}  // namespace plumbline::assets
