// `plumbline study --picture SCENE`: what the image's accuracy costs.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/image_findings.h"
#include "engine/study/image/light_image.h"

#include <filesystem>
#include <optional>

namespace plumbline::game {

struct ImageStudy {
    study::ImageFindings findings;
    study::LightImage reference;
    bool complete{true};  ///< false: interrupted; rows not measured by then are missing
};

/// Draws the scene as it is after `seconds` (not given: 2) from its own camera. No usable GL: exit code 3.
Result<ImageStudy> study_image(const std::filesystem::path& scene, std::optional<double> seconds);

}  // namespace plumbline::game
