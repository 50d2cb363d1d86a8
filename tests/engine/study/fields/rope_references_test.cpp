// Ropes are within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class RopeReference : public EachReference {};

TEST_P(RopeReference, IsKeptAtEveryFidelity) {
    expect_kept(rope_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         RopeReference,
                         testing::Range(std::size_t{0}, rope_references().size()),
                         [](const auto& tested) { return id_of(rope_references()[tested.param]); });

}  // namespace
}  // namespace plumbline::study
