// Steps the variants of one scene in turns and times them.
#pragma once

#include "tests/benchmarks/peer_scenes_meters.h"
#include "tests/benchmarks/peer_scenes_world.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::bench {

struct Variant {
    std::string engine;  ///< "bullet32" (bare) or a solver of ours
    bool bare{false};
    bool drop_in{false};  ///< the bare program with our world in it
    OurSettings settings{};
};

struct RunSettings {
    int rounds{3};
    double seconds{0};  ///< 0: as the scene's case says
    bool sleep{false};
    bool phases{false};
};

/// Milliseconds a frame of 1/60 s.
struct Phases {
    double broad{0};
    double narrow{0};
    double solve{0};
    double integrate{0};
    double other{0};
};

/// Sub-steps that islands got, of the steps that were looked at.
struct SubstepsGiven {
    double mean{0};  ///< over bodies
    int most{0};
};

struct VariantResult {
    Variant variant;
    double ms_per_frame{0};         ///< CPU of all threads, median of the rounds
    double wall_ms_per_frame{0};    ///< likewise, on the clock
    std::optional<double> ratio{};  ///< to bare, median of the rounds
    double ratio_min{0};
    double ratio_max{0};
    std::optional<SubstepsGiven> given{};
    std::optional<Phases> phases{};  ///< of the last round
    std::vector<Metric> metrics;     ///< of the first round
};

/// In each round every variant is built afresh and all of them step through the scene together, a
/// second of simulated time at a turn. Only steps are timed. Bodies are looked
/// at in the first round only, between timed stretches; with `sleep` in every round.
Result<std::vector<VariantResult>> run_scene(const PeerScene& scene,
                                             const SceneCase& the_case,
                                             const std::vector<Variant>& variants,
                                             const RunSettings& settings);

}  // namespace plumbline::bench
