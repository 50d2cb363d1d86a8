// What each effect of a scene costs, as plain data: the same seconds with and without it, in turns.
#pragma once

#include "engine/study/findings/difference.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::study {

struct EffectCost {
    std::string name{};
    std::string caller{};   ///< the first one that called for it
    std::string domain{};   ///< "step", "image", "sound"
    Difference step_ms{};   ///< CPU of a step that switching it off saves
    Difference frame_ms{};  ///< CPU of a frame's sound or image, likewise
    std::uint64_t calls{0};
    std::uint64_t bytes_cpu{0};
    std::uint64_t bytes_gpu{0};
};

/// What a study of one scene's effects found.
struct EffectFindings {
    std::string scene{};
    double seconds{0};  ///< of the scene in each run
    int pairs{0};
    std::uint32_t width_px{0};  ///< of the image; 0: none was drawn
    std::uint32_t height_px{0};
    std::vector<EffectCost> rows{};
};

/// A table for people.
std::string effects_text(const EffectFindings& findings);

}  // namespace plumbline::study
