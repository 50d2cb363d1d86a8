// Soft bodies are within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class SoftReference : public EachReference {};

TEST_P(SoftReference, IsKeptAtEveryFidelity) {
    expect_kept(soft_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         SoftReference,
                         testing::Range(std::size_t{0}, soft_references().size()),
                         [](const auto& tested) { return id_of(soft_references()[tested.param]); });

}  // namespace
}  // namespace plumbline::study
