// What each effect of a scene costs, as plain data: the same seconds with and without it, in turns.
#pragma once

#include "engine/study/findings/difference.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::study {

/// One fidelity of an effect that has three, with all else at the scene's own.
struct FidelityCost {
    std::string fidelity{};  ///< "draft", "balanced", "precise"
    double step_ms{0};       ///< CPU of a step with all that it takes, least of the runs
    double largest_m{0};     ///< how far bodies are from where they are at "precise", at the end
    double mean_m{0};
};

struct EffectCost {
    std::string name{};
    std::string caller{};   ///< the first one that called for it
    std::string domain{};   ///< "step", "image", "sound"
    Difference step_ms{};   ///< CPU of a step that switching it off saves
    Difference frame_ms{};  ///< CPU of a frame's sound or image, likewise
    std::uint64_t calls{0};
    std::uint64_t bytes_cpu{0};
    std::uint64_t bytes_gpu{0};
    std::vector<FidelityCost> fidelities{};  ///< empty: it has but one
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

/// How far an effect is from what a reference says, at one fidelity.
struct EffectError {
    std::string effect{};
    std::string reference{};
    std::string formula{};
    std::string fidelity{};  ///< "draft", "balanced", "precise"
    double error{0};         ///< relative
    double cpu_ms_per_s{0};  ///< CPU of all steps for a simulated second
    double tolerance{0};     ///< that a test holds `error` to

    bool is_within() const { return error <= tolerance; }
};

/// A table for people.
std::string effects_text(const EffectFindings& findings);

}  // namespace plumbline::study
