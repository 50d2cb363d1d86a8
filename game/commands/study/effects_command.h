// `plumbline study --effects`: what each effect of a scene costs.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/effect_findings.h"

#include <filesystem>
#include <optional>

namespace plumbline::game {

/// The effects of the image, for which it needs OpenGL, and those of the steps and the sound. When
/// interrupted: those measured by then. Refused: a scene that does not load.
Result<study::EffectFindings> study_effects(const std::filesystem::path& scene,
                                            std::optional<double> seconds);

}  // namespace plumbline::game
