// Cloth is within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class ClothReference : public EachReference {};

TEST_P(ClothReference, IsKeptAtEveryFidelity) {
    expect_kept(cloth_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         ClothReference,
                         testing::Range(std::size_t{0}, cloth_references().size()),
                         [](const auto& tested) {
                             return id_of(cloth_references()[tested.param]);
                         });

}  // namespace
}  // namespace plumbline::study
