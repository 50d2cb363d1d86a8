// Which rows of the hard cases are not reached, how far they get, and why.
#include "tests/scenarios/families/rows.h"

#include <array>

namespace plumbline::study {
namespace {

constexpr auto kKnownRed = std::to_array<KnownRed>({
    {"Life.H88UnevenStepsEndWhereEvenOnesDo",
     "H88 tower of 5, speed m/s",
     std::nullopt,
     0.07,
     "contacts give way as sub-steps are long: the tower breathes as their length changes"},
    {"Stack.H05ABoxBearsAThousandfoldOne",
     "H05 1000:1, 30 Hz penetration m",
     0.035,
     0.035,
     "16 sub-steps at most, at twice the length"},
});

}  // namespace

std::span<const KnownRed> known_red() {
    return kKnownRed;
}

}  // namespace plumbline::study
