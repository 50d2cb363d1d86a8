#include "engine/scene/formats/toml_tree.h"

#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace plumbline::scene {
using FileName = std::shared_ptr<const std::string>;

namespace {

SourceLocation location_of(const toml::source_region& region, const FileName& file) {
    return {.file = file,
            .line = static_cast<int>(region.begin.line),
            .column = static_cast<int>(region.begin.column)};
}

// The pre-scan limits how deep this can go.
TomlNode copy_of(const toml::node& node, const FileName& file) {
    TomlNode copy;
    copy.location = location_of(node.source(), file);
    if (const toml::table* table = node.as_table()) {
        TomlTable entries;
        entries.reserve(table->size());
        for (const auto& [key, value] : *table) {
            entries.push_back(
                {std::string(key.str()), location_of(key.source(), file), copy_of(value, file)});
        }
        std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
            return std::tie(a.key_location.line, a.key_location.column) <
                   std::tie(b.key_location.line, b.key_location.column);
        });
        copy.value = std::move(entries);
    } else if (const toml::array* array = node.as_array()) {
        TomlArray items;
        items.reserve(array->size());
        for (const toml::node& item : *array) items.push_back(copy_of(item, file));
        copy.value = std::move(items);
    } else if (const auto* text = node.as_string()) {
        copy.value = text->get();
    } else if (const auto* integer = node.as_integer()) {
        copy.value = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        copy.value = number->get();
    } else if (const auto* flag = node.as_boolean()) {
        copy.value = flag->get();
    } else {
        copy.value = TomlDate{};
    }
    return copy;
}

bool holds_tables(const TomlNode& node) {
    const TomlArray* items = node.array();
    return items != nullptr && !items->empty() && items->front().table() != nullptr;
}

}  // namespace

const TomlNode* find_key(const TomlTable& table, std::string_view key) {
    const auto found = std::ranges::find(table, key, &TomlEntry::key);
    return found == table.end() ? nullptr : &found->node;
}

TomlNode laid_over(TomlNode below, const TomlNode& above) {
    auto& entries = std::get<TomlTable>(below.value);
    below.location = above.location;
    for (const TomlEntry& entry : *above.table()) {
        const auto known = std::ranges::find(entries, entry.key, &TomlEntry::key);
        if (known == entries.end()) {
            entries.push_back(entry);
        } else if (known->node.table() != nullptr && entry.node.table() != nullptr) {
            known->node = laid_over(std::move(known->node), entry.node);
        } else if (holds_tables(known->node) && holds_tables(entry.node)) {
            auto& items = std::get<TomlArray>(known->node.value);
            items.insert(items.end(), entry.node.array()->begin(), entry.node.array()->end());
        } else {
            *known = entry;
        }
    }
    return below;
}

std::variant<TomlNode, TextFault> parse_toml(std::string_view text, const FileName& file) {
    if (auto fault = prescan_toml(text)) return *fault;
    // The packaged parser throws; its exceptions end here.
    try {
        return copy_of(toml::parse(text), file);
    } catch (const toml::parse_error& error) {
        return TextFault{std::string(error.description()),
                         static_cast<int>(error.source().begin.line),
                         static_cast<int>(error.source().begin.column)};
    }
}

}  // namespace plumbline::scene
