// Drag, wind and lift are within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class AirReference : public EachReference {};

TEST_P(AirReference, IsKeptAtEveryFidelity) {
    expect_kept(air_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         AirReference,
                         testing::Range(std::size_t{0}, air_references().size()),
                         [](const auto& tested) { return id_of(air_references()[tested.param]); });

}  // namespace
}  // namespace plumbline::study
