#include "engine/scene/formats/renamed_keys.h"

#include <fmt/format.h>

#include <array>

namespace plumbline::scene {
namespace {

constexpr auto kRenamed = std::to_array<RenamedKey>({
    {"joint", "kind", "ball", "ball_and_socket"},
    {"hard_case.event", "", "spin_radps", "angular_velocity_radps"},
    {"hard_case.event", "", "for_s", "duration_s"},
    {"hard_case.pass", "measure", "joint_gap_m", "joint_error_m"},
    {"hard_case.pass", "measure", "joint_way_m", "joint_displacement_m"},
    {"hard_case.pass", "measure", "speed_across_mps", "horizontal_speed_mps"},
    {"hard_case.known_red", "rule", "joint_gap_m", "joint_error_m"},
    {"hard_case.known_red", "rule", "joint_way_m", "joint_displacement_m"},
    {"hard_case.known_red", "rule", "speed_across_mps", "horizontal_speed_mps"},
});

/// "joint_way_m of hook" begins with the word "joint_way_m".
bool begins_with_word(std::string_view text, std::string_view word) {
    return text.starts_with(word) && (text.size() == word.size() || text[word.size()] == ' ');
}

void rename_in(TomlNode& node, const std::string& path, FaultList& faults) {
    if (auto* items = std::get_if<TomlArray>(&node.value)) {
        for (TomlNode& item : *items) rename_in(item, path, faults);
        return;
    }
    auto* table = std::get_if<TomlTable>(&node.value);
    if (table == nullptr) return;
    for (TomlEntry& entry : *table) {
        for (const RenamedKey& renamed : kRenamed) {
            if (renamed.table != path) continue;
            auto* text = std::get_if<std::string>(&entry.node.value);
            const bool is_key = renamed.key.empty() && entry.key == renamed.before &&
                                find_key(*table, renamed.now) == nullptr;
            const bool is_word = !renamed.key.empty() && entry.key == renamed.key &&
                                 text != nullptr && begins_with_word(*text, renamed.before);
            if (!is_key && !is_word) continue;
            faults.warning(is_key ? entry.key_location : entry.node.location,
                           path + "." + entry.key,
                           fmt::format("\"{}\" is called \"{}\" now", renamed.before, renamed.now));
            if (is_key) {
                entry.key = renamed.now;
            } else {
                text->replace(0, renamed.before.size(), renamed.now);
            }
            break;
        }
        rename_in(entry.node, path.empty() ? entry.key : path + "." + entry.key, faults);
    }
}

}  // namespace

std::span<const RenamedKey> renamed_keys() {
    return kRenamed;
}

void rename_keys(TomlNode& root, FaultList& faults) {
    rename_in(root, {}, faults);
}

}  // namespace plumbline::scene
