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

struct ImageStudyOptions {
    std::filesystem::path scene{};
    std::optional<double> seconds{};  ///< simulated before; not given: 2
    std::string camera{};             ///< parse_camera(); empty: the scene's own
    bool levels_only{false};          ///< low, medium and high, without what they consist of
};
/// No usable GL: exit code 3.
Result<ImageStudy> study_image(const ImageStudyOptions& options);

}  // namespace plumbline::game
