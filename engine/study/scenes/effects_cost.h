// Measures what each effect of a scene costs: runs of the same seconds with and without it, in turns.
//
// This file measures effects of the steps and of the sound. Effects of the image need a GL context:
// game/commands/effects_command.h measures them.
#pragma once

#include "engine/core/result.h"
#include "engine/effects/effect_table.h"
#include "engine/study/findings/effect_findings.h"
#include "engine/study/words.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::study {

struct EffectsRun {
    std::filesystem::path scene{};
    double seconds{2};
    int pairs{6};
};
/// One row for each effect of the steps or the sound that something calls for. Runs in worker
/// processes, at the scene's own accuracy and without a player. When interrupted, it returns the rows
/// measured by then.
Result<std::vector<EffectCost>> measure_effects(const EffectsRun& run, int workers);

template <>
inline constexpr std::array<std::string_view, 3> kWords<effects::Domain>{"step", "image", "sound"};

/// The kind "effect".
Result<std::string> run_effect_job(const std::string& body);

}  // namespace plumbline::study
