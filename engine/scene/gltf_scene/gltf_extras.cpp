// What our exporter puts beside what glTF can say: tables of a scene file, as JSON.
#include "engine/assets/model_import.h"
#include "engine/scene/gltf_scene/gltf_export.h"
#include "engine/scene/gltf_scene/gltf_scene_impl.h"
#include "engine/scene/sections/scene_parts.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace plumbline::scene {
namespace {

using Json = nlohmann::json;

TomlNode node_of(const Json& json, const SourceLocation& location) {
    TomlNode node{.location = location};
    switch (json.type()) {
        case Json::value_t::object: {
            TomlTable table;
            for (const auto& [key, value] : json.items())
                table.push_back(
                    {.key = key, .key_location = location, .node = node_of(value, location)});
            node.value = std::move(table);
            break;
        }
        case Json::value_t::array: {
            TomlArray array;
            for (const Json& value : json) array.push_back(node_of(value, location));
            node.value = std::move(array);
            break;
        }
        case Json::value_t::string:
            node.value = json.get<std::string>();
            break;
        case Json::value_t::boolean:
            node.value = json.get<bool>();
            break;
        case Json::value_t::number_integer:
        case Json::value_t::number_unsigned:
            node.value = json.get<std::int64_t>();
            break;
        case Json::value_t::number_float:
            node.value = json.get<double>();
            break;
        default:
            node.value = TomlDate{};  // null: no key takes it
    }
    return node;
}

/// Dates, which no key takes, become null.
Json json_of(const TomlNode& node) {
    if (const auto* table = node.table()) {
        Json object = Json::object();
        for (const TomlEntry& entry : *table) object[entry.key] = json_of(entry.node);
        return object;
    }
    if (const auto* array = node.array()) {
        Json list = Json::array();
        for (const TomlNode& each : *array) list.push_back(json_of(each));
        return list;
    }
    if (const auto* text = node.text()) return *text;
    if (const auto* flag = std::get_if<bool>(&node.value)) return *flag;
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return *whole;
    if (const auto* number = std::get_if<double>(&node.value)) return *number;
    return nullptr;
}

constexpr std::array<std::string_view, 14> kSurroundings{"world",
                                                         "accuracy",
                                                         "player",
                                                         "camera",
                                                         "sun",
                                                         "sky",
                                                         "time",
                                                         "ambient",
                                                         "fog",
                                                         "flashlight",
                                                         "post",
                                                         "sound",
                                                         "scene",
                                                         "effects"};

}  // namespace

Result<std::string> surroundings_of(const std::filesystem::path& file,
                                    const std::filesystem::path& assets_folder) {
    if (assets::is_model_file(file)) {
        const Result<assets::ModelData> model =
            assets::import_model(file, file.has_parent_path() ? file.parent_path() : ".");
        if (!model) return model.error();
        return model->extras;
    }
    if (file.extension() != ".toml") return std::string{};
    const Result<TomlNode> tables = tables_of_scene(file, assets_folder);
    if (!tables) return tables.error();
    Json kept = Json::object();
    for (const std::string_view key : kSurroundings) {
        if (const TomlNode* table = find_key(*tables->table(), key)) kept[key] = json_of(*table);
    }
    if (kept.contains("scene")) {
        for (const char* key : {"include", "base", "without"}) kept["scene"].erase(key);
    }
    return kept.dump();
}

std::optional<TomlNode> table_of_extras(const std::string& json,
                                        const SourceLocation& location,
                                        FaultList& faults) {
    try {
        const Json tables = Json::parse(json);
        if (tables.is_object()) return node_of(tables, location);
        faults.error(location, "extras.plumbline", "expected an object");
    } catch (const std::exception& fault) {
        faults.error(location, "extras.plumbline", fault.what());
    }
    return {};
}

}  // namespace plumbline::scene
