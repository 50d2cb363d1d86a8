// What breaks does so within what its references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class FractureReference : public EachReference {};

TEST_P(FractureReference, IsKeptAtEveryFidelity) {
    expect_kept(fracture_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         FractureReference,
                         testing::Range(std::size_t{0}, fracture_references().size()),
                         [](const auto& tested) {
                             return id_of(fracture_references()[tested.param]);
                         });

}  // namespace
}  // namespace plumbline::study
