// Vehicles are within what their references allow.
#include "tests/engine/study/fields/each_reference.h"

namespace plumbline::study {
namespace {

class VehicleReference : public EachReference {};

TEST_P(VehicleReference, IsKeptAtEveryFidelity) {
    expect_kept(vehicle_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         VehicleReference,
                         testing::Range(std::size_t{0}, vehicle_references().size()),
                         [](const auto& tested) {
                             return id_of(vehicle_references()[tested.param]);
                         });

}  // namespace
}  // namespace plumbline::study
