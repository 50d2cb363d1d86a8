// Buoyancy and waves are within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class WaterReference : public EachReference {};

TEST_P(WaterReference, IsKeptAtEveryFidelity) {
    expect_kept(water_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         WaterReference,
                         testing::Range(std::size_t{0}, water_references().size()),
                         [](const auto& tested) {
                             return id_of(water_references()[tested.param]);
                         });

}  // namespace
}  // namespace plumbline::study
