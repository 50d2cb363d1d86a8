// What each effect of a scene costs: the same seconds of it with and without, in turns.
//
// Here the effects of the steps and of the sound. Those of the image need a GL context, which the
// game has (game/commands/effects_command.h); both fill EffectCost.
#pragma once

#include "engine/core/result.h"
#include "engine/effects/effect_table.h"
#include "engine/study/findings/difference.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

struct EffectCost {
    std::string name{};
    std::string caller{};  ///< the first one that called for it
    effects::Domain domain{effects::Domain::Step};
    Difference step_ms{};   ///< CPU of a step, by switching it off
    Difference frame_ms{};  ///< CPU of a frame's sound or image, likewise
    std::uint64_t calls{0};
    std::uint64_t bytes_cpu{0};
    std::uint64_t bytes_gpu{0};
};

struct EffectsRun {
    std::filesystem::path scene{};
    double seconds{2};
    int pairs{6};
};
/// In worker processes, at the scene's own accuracy, played by nobody; one line per effect of the
/// steps or the sound that something called for. Stops early when interrupted.
Result<std::vector<EffectCost>> measure_effects(const EffectsRun& run, int workers);

/// For people; `seconds` and how it was measured are said above the table.
std::string effects_text(const EffectsRun& run, std::span<const EffectCost> costs);

/// The kind "effect".
std::string run_effect_job(const std::string& body);

}  // namespace plumbline::study
