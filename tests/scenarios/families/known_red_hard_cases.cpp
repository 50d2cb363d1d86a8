// Which rows of the hard cases are not reached, how far they get, and why.
#include "tests/scenarios/families/rows.h"

#include <array>

namespace plumbline::study {
namespace {

constexpr auto kKnownRed = std::to_array<KnownRed>({
    {"Shipped/GalleryCases.HoldTheirOwnRules/H17At30Hz",
     "H17 30 Hz: penetration_m at most 0.005",
     1.79,
     1.79,
     "the last dominoes as they land, in steps of twice the length"},
    {"Shipped/GalleryCases.HoldTheirOwnRules/H17At60Hz",
     "H17 60 Hz: penetration_m at most 0.005",
     std::nullopt,
     0.82,
     "as the scene says of float32"},
    {"Shipped/GalleryCases.HoldTheirOwnRules/H44At60Hz",
     "H44 60 Hz: braked_share at most 0.01",
     std::nullopt,
     5.63,
     "as the scene says of float32"},
});

}  // namespace

std::span<const KnownRed> known_red() {
    return kKnownRed;
}

}  // namespace plumbline::study
