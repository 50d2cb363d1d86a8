#include "engine/input/tuning_keys.h"

#include <algorithm>
#include <array>

namespace plumbline::input {
namespace {

constexpr auto kKeys = std::to_array<TuningKey>({
    {"mouse_deg_per_count", &Tuning::mouse_deg_per_count, nullptr, 0.001, 2.0},
    {"invert_y", nullptr, &Tuning::invert_y},
    {"pad_look_deg_per_sec", &Tuning::pad_look_deg_per_s, nullptr, 10.0, 1'000.0},
    {"pad_inner_dead_zone", &Tuning::pad_inner_dead_zone, nullptr, 0.0, 0.6},
    {"pad_outer_dead_zone", &Tuning::pad_outer_dead_zone, nullptr, 0.0, 0.3},
    {"pad_curve", &Tuning::pad_curve, nullptr, 0.25, 5.0},
    {"trigger_threshold", &Tuning::trigger_threshold, nullptr, 0.05, 0.95},
    {"free_pointer", nullptr, &Tuning::free_pointer},
});

}  // namespace

std::span<const TuningKey> tuning_keys() {
    return kKeys;
}

std::span<const std::string_view> tuning_key_names() {
    static const std::vector<std::string_view> kNames = [] {
        std::vector<std::string_view> names;
        for (const TuningKey& key : kKeys) names.push_back(key.name);
        return names;
    }();
    return kNames;
}

const TuningKey* find_tuning_key(std::string_view name) {
    const auto* const found = std::ranges::find(kKeys, name, &TuningKey::name);
    return found == kKeys.end() ? nullptr : found;
}

}  // namespace plumbline::input
