#include "engine/assets/byte_reader.h"
#include "engine/assets/gltf/gltf_reader_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/core/text/json_depth.h"

#include <exception>

namespace plumbline::assets {
namespace {

GltfParts split_glb(std::string_view bytes, const std::string& name) {
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
    constexpr std::uint32_t kBinaryChunk = 0x004E4942;
    if (bytes.size() < kHeader + kChunkHeader) fail("the GLB breaks off");
    if (little_u32(bytes, 4) != 2) {
        fail("it is GLB version {}; 2 is read", little_u32(bytes, 4));
    }
    const std::size_t length = little_u32(bytes, 8);
    if (length > bytes.size() || length < kHeader + kChunkHeader) {
        fail("the GLB header says {} bytes, the file has {}", length, bytes.size());
    }
    if (length < bytes.size()) {
        log_warning(
            "model {}: {} bytes after the GLB's end are ignored", name, bytes.size() - length);
        bytes = bytes.substr(0, length);
    }
    GltfParts parts{};
    std::size_t place = kHeader;
    for (std::size_t chunk = 0; place < bytes.size(); ++chunk) {
        if (bytes.size() - place < kChunkHeader) {
            fail("chunk {} of the GLB breaks off", chunk);
        }
        const std::size_t size = little_u32(bytes, place);
        const std::uint32_t kind = little_u32(bytes, place + 4);
        place += kChunkHeader;
        if (size > bytes.size() - place) {
            fail("chunk {} of the GLB says {} bytes, {} are left",
                 chunk,
                 size,
                 bytes.size() - place);
        }
        if ((kind == kJsonChunk) != (chunk == 0) || (kind == kBinaryChunk && chunk != 1)) {
            fail("the GLB's chunks are not JSON first, then binary");
        }
        if (chunk == 0) parts.json = bytes.substr(place, size);
        if (kind == kBinaryChunk) parts.binary = bytes.substr(place, size);
        place += size;
    }
    return parts;
}

/// Stops at a key that its object has already. A pass of its own: the parser's callbacks, which
/// could do this while it builds, walk all earlier siblings after every value.
class KeyWatch final : public nlohmann::json_sax<Json> {
public:
    std::string repeated;

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool start_array(std::size_t /*size*/) override { return true; }
    bool end_array() override { return true; }
    bool start_object(std::size_t /*size*/) override {
        keys_.emplace_back();
        return true;
    }
    bool end_object() override {
        keys_.pop_back();
        return true;
    }
    bool key(string_t& key) override {
        if (keys_.back().insert(key).second) return true;
        repeated = key;
        return false;
    }
    bool parse_error(std::size_t /*place*/,
                     const std::string& /*token*/,
                     const Json::exception& /*fault*/) override {
        return false;  // the pass that builds the document reports it
    }

private:
    std::vector<std::set<std::string>> keys_;
};

/// The parser's own words without its prefix "[json.exception.…] ".
std::string_view plain_words(std::string_view what) {
    const std::size_t bracket = what.find("] ");
    return bracket == std::string_view::npos ? what : what.substr(bracket + 2);
}

}  // namespace

GltfParts split_gltf(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("glTF")) return split_glb(bytes, name);
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || bytes[first] != '{') {
        fail("its content is not glTF: neither JSON nor a GLB");
    }
    return {.json = bytes, .binary = {}};
}

Json parse_json(std::string_view text) {
    if (text.size() > limits::kModelJsonBytes) {
        fail("its JSON has {} bytes; at most {} are read", text.size(), limits::kModelJsonBytes);
    }
    if (json_depth(text) > limits::kModelJsonDepth) {
        fail("its JSON nests deeper than {}", limits::kModelJsonDepth);
    }
    try {
        KeyWatch watch;
        if (!Json::sax_parse(text.begin(), text.end(), &watch) && !watch.repeated.empty()) {
            fail("its JSON has the key \"{}\" twice", watch.repeated);
        }
        Json document = Json::parse(text.begin(), text.end());
        if (!document.is_object()) fail("its JSON is not an object");
        return document;
    } catch (const std::exception& thrown) {
        fail("its JSON is bad: {}", plain_words(thrown.what()));
    }
}

GltfObject object_at(const Json& list, std::size_t i, const std::string& where) {
    GltfObject object{.json = list[i], .where = fmt::format("{}[{}]", where, i)};
    if (!object.json.is_object()) fail("{} is not an object", object.where);
    return object;
}

const Json& GltfObject::array(const char* key) const {
    static const Json kEmpty = Json::array();
    const auto found = json.find(key);
    if (found == json.end()) return kEmpty;
    if (!found->is_array()) fail("{}{}{} is not an array", where, where.empty() ? "" : ".", key);
    return *found;
}

std::optional<GltfObject> GltfObject::object(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) return std::nullopt;
    if (!found->is_object()) fail("{}.{} is not an object", where, key);
    return GltfObject{.json = *found, .where = where};
}

std::optional<std::size_t> GltfObject::whole(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) return std::nullopt;
    if (found->is_number_unsigned()) return found->get<std::size_t>();
    fail("{}.{} is {}; it must be a whole number, 0 or more", where, key, found->dump());
}

std::optional<std::size_t> GltfObject::index(const char* key, std::size_t count) const {
    const std::optional<std::size_t> value = whole(key);
    if (value && *value >= count) fail("{}.{} names number {} of {}", where, key, *value, count);
    return value;
}

std::string GltfObject::text(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) return {};
    if (found->is_string()) return found->get<std::string>();
    fail("{}.{} is not a text", where, key);
}

float GltfObject::number(const char* key, float fallback) const {
    const auto found = json.find(key);
    if (found == json.end()) return fallback;
    if (found->is_number()) {
        const auto value = static_cast<float>(found->get<double>());
        if (std::isfinite(value)) return value;
    }
    fail("{}.{} is not a number that fits", where, key);
}

std::vector<float> GltfObject::numbers(const char* key, std::size_t size) const {
    if (!json.contains(key)) return {};
    const Json& list = array(key);
    std::vector<float> values;
    for (const Json& value : list) {
        if (!value.is_number()) break;
        values.push_back(static_cast<float>(value.get<double>()));
        if (!std::isfinite(values.back())) break;
    }
    if (list.size() == size && values.size() == size && std::isfinite(values.back())) return values;
    fail("{}.{} must be {} numbers", where, key, size);
}

std::vector<double> GltfObject::reals(const char* key, std::size_t size) const {
    if (!json.contains(key)) return {};
    std::vector<double> values;
    for (const Json& value : array(key)) {
        if (!value.is_number()) break;
        values.push_back(value.get<double>());
    }
    if (array(key).size() == size && values.size() == size) return values;
    fail("{}.{} must be {} numbers", where, key, size);
}

std::optional<double> GltfObject::real(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) return std::nullopt;
    if (found->is_number()) return found->get<double>();
    fail("{}.{} is not a number", where, key);
}

std::vector<GltfObject> GltfObject::objects(const char* key, std::size_t limit) const {
    const Json& list = array(key);
    const std::string called = where.empty() ? key : fmt::format("{}.{}", where, key);
    if (list.size() > limit) fail("it has {} {}; at most {} are read", list.size(), called, limit);
    std::vector<GltfObject> objects;
    for (std::size_t i = 0; i < list.size(); ++i) objects.push_back(object_at(list, i, called));
    return objects;
}

std::vector<GltfObject> GltfReader::objects(const char* key, std::size_t limit) const {
    return root.objects(key, limit);
}

}  // namespace plumbline::assets
