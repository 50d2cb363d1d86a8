// Which rows are not reached, how far they get, and why.
#include "tests/scenarios/families/rows.h"

#include <array>

namespace plumbline::physics {
namespace {

constexpr auto kKnownRed = std::to_array<KnownRed>({
    {"A20 ball e=0.3 H=1 S=1 apex 3",
     0.09,
     0.09,
     "0.7 mm: less than the ball falls in a sub-step from rest"},
    {"A20 ball e=0.3 H=1 S=4 apex 4",
     0.26,
     0.26,
     "0.07 mm: less than the ball falls in a sub-step from rest"},
    {"A20 ball e=0.3 H=5 balanced apex 4",
     0.24,
     0.24,
     "0.3 mm: less than the ball falls in a sub-step from rest"},
    {"A05 flip time s",
     0.4,
     0.02,
     "in an island spin is float between sub-steps: 1e-7 of energy moves the flip"},
    {"A05 spin at 10 s", 0.4, 0.01, "as the flip"},
    {"A43 0.01 times as long, tower of 5",
     0.0015,
     0.0015,
     "sags by the sub-step squared over its size"},
    {"A43 0.1 times as long, tower of 5",
     0.0015,
     0.0015,
     "sags by the sub-step squared over its size"},
    {"A29 creep in 60 s m S=1", 1.3e-4, 1.3e-4, "slips in the first sub-step, a 60th of a second"},
    {"H84 creep in 60 s m 30 Hz", 1e-4, 1.2e-4, "slips in the first sub-step, a 60th of a second"},
    {"H76 rate of slip S=1",
     0.45,
     0.45,
     "one sub-step: the path's curve is friction's error of the step before"},
    {"A36 4 blocks at 99 % move m",
     2000.0,
     2000.0,
     "the jolt of the first sub-step tips what has 1 % to spare"},
    {"A36 6 blocks at 99 % move m",
     2000.0,
     2000.0,
     "the jolt of the first sub-step tips what has 1 % to spare"},
    {"H75 lift 60 Hz sinking, off m", 0.05, 0.1, "the stack lands on the lift and rocks"},
    {"H88 tower of 5, sag m",
     0.08,
     0.08,
     "every change of the step's length rebuilds the world, without impulses"},
    {"H05 1000:1, 30 Hz penetration m", 0.035, 0.035, "16 sub-steps at most, at twice the length"},
});

}  // namespace

std::span<const KnownRed> known_red() {
    return kKnownRed;
}

}  // namespace plumbline::physics
