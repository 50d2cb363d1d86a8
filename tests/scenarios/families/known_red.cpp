// Which rows are not reached, how far they get, and why.
#include "tests/scenarios/families/rows.h"

#include <array>

namespace plumbline::physics {
namespace {

constexpr std::array<KnownRed, 0> kKnownRed{};

}  // namespace

std::span<const KnownRed> known_red() {
    return kKnownRed;
}

}  // namespace plumbline::physics
