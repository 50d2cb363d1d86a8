// What ways to draw a scene's image are worth, as plain data: error beside cost.
#pragma once

#include "engine/study/findings/difference.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::study {

/// Of linear light, relative to the mean luminance of the reference: 0.01 is 1 %.
struct ImageError {
    double mean{0};  ///< of the differences' sizes
    double rms{0};   ///< root of the mean square: a few pixels far off count more
};

struct ImageRow {
    std::string name;
    ImageError error;
    double cpu_ms{0};      ///< of a frame, all threads; the least of the passes
    Difference more_ms{};  ///< than the first row, measured in turns
    bool unbeaten{false};  ///< no other row is both cheaper and nearer to the reference
    std::string verdict;
};

/// What a study of one scene's image found.
struct ImageFindings {
    std::string scene;
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    std::uint32_t samples_per_pixel{0};  ///< of the reference
    double mean_luminance{0};            ///< of the reference; 1: the screen's white
    std::vector<ImageRow> rows;          ///< level high first: the others are compared to it
};

/// Fills `unbeaten` and `verdict` of all rows.
void judge(ImageFindings& findings);
/// A table for people.
std::string image_text(const ImageFindings& findings);

}  // namespace plumbline::study
