// Which rows of the accuracy families are not reached, how far they get, and why.
#include "tests/scenarios/families/rows.h"

#include <array>

namespace plumbline::study {
namespace {

constexpr auto kKnownRed = std::to_array<KnownRed>({
    {"Bounce.A20DroppedBallsReachTheSquareOfRestitution",
     "A20 ball e=0.3 H=1 S=1 apex 3",
     0.09,
     0.09,
     "an apex of 0.7 mm: less than the ball falls in a sub-step from rest"},
    {"Bounce.A20DroppedBallsReachTheSquareOfRestitution",
     "A20 ball e=0.3 H=1 S=4 apex 4",
     0.26,
     0.26,
     "an apex of 0.07 mm: less than the ball falls in a sub-step from rest"},
    {"Bounce.A20DroppedBallsReachTheSquareOfRestitution",
     "A20 ball e=0.3 H=5 balanced apex 4",
     0.46,
     0.46,
     "an apex of 0.3 mm: less than the ball falls in a sub-step from rest"},
    {"Bounce.A20DroppedBallsReachTheSquareOfRestitution",
     "A20 ball e=0.3 H=5 S=4 apex 4",
     0.71,
     0.71,
     "an apex of 0.3 mm: less than the ball falls in a sub-step from rest"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 flip time s balanced",
     0.18,
     std::nullopt,
     "in an island spin is float between sub-steps: 1e-7 of energy moves the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 flip time s S=1",
     0.035,
     std::nullopt,
     "in an island spin is float between sub-steps: 1e-7 of energy moves the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 flip time s S=4",
     0.26,
     std::nullopt,
     "in an island spin is float between sub-steps: 1e-7 of energy moves the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 flip time s S=16",
     0.37,
     std::nullopt,
     "in an island spin is float between sub-steps: 1e-7 of energy moves the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 spin at 10 s balanced",
     0.12,
     std::nullopt,
     "as the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 spin at 10 s S=4",
     0.04,
     std::nullopt,
     "as the flip"},
    {"Tops.A05ABoxOfThreeLengthsFlipsOnTime",
     "A05 spin at 10 s S=16",
     0.36,
     std::nullopt,
     "as the flip"},
    {"Invariance.A43TheWorldMayBeLargerOrSmaller",
     "A43 0.01 times as long, tower of five",
     0.0015,
     0.0015,
     "sags by gravity times the sub-step squared, whatever its size"},
    {"Sliding.H76ABoxOnATurningPlateSlipsWhenItMust",
     "H76 rate of slip S=1",
     0.45,
     0.45,
     "one sub-step: the path's curve is friction's error of the step before"},
    {"Support.A36BlocksLeanOutAsFarAsTheSeriesSays",
     "A36 4 blocks, share of the reach that falls",
     0.0148,
     0.0148,
     "the velocity that the first sub-step gives tips what has less to spare"},
    {"Support.A36BlocksLeanOutAsFarAsTheSeriesSays",
     "A36 6 blocks, share of the reach that falls",
     0.0236,
     0.0236,
     "the velocity that the first sub-step gives tips what has less to spare"},
});

}  // namespace

std::span<const KnownRed> known_red() {
    return kKnownRed;
}

}  // namespace plumbline::study
