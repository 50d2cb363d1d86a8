#include "engine/study/scenarios/scenario.h"

#include <algorithm>
#include <array>

namespace plumbline::study {
namespace {

constexpr std::array<LeftOut, 5> kLeftOut{
    {{"A05 sign flips",
      "told by the spin and the orientation at 10 s, at a moment that steps divide"},
     {"A35 planar logs", "the balls ask the same of friction, in three dimensions"},
     {"A38 rod on a rough pivot edge",
      "an edge that holds in both directions is a hinge: A10. On a floor it slips or lifts off "
      "first"},
     {"floating cube, wind", "there is no water and no wind"},
     {"braking, suspension, conveyor", "there are no vehicles and no conveyor belts"}}};

}  // namespace

std::span<const LeftOut> left_out() {
    return kLeftOut;
}

const std::vector<Scenario>& scenarios() {
    static const std::vector<Scenario> all = [] {
        std::vector<Scenario> made;
        for (const auto family : {flight_family,
                                  tops_family,
                                  pendulums_family,
                                  chains_family,
                                  bounces_family,
                                  impacts_family,
                                  sliding_family,
                                  rolling_family,
                                  supports_family,
                                  leaving_family,
                                  invariances_family,
                                  peer_scenes_family}) {
            const std::vector<Scenario> own = family();
            made.insert(made.end(), own.begin(), own.end());
        }
        std::ranges::stable_sort(
            made, {}, [](const Scenario& each) { return each.id.substr(0, 3); });
        return made;
    }();
    return all;
}

const Scenario* scenario_of(const std::string& id) {
    const auto found = std::ranges::find(scenarios(), id, &Scenario::id);
    return found != scenarios().end() ? &*found : nullptr;
}

}  // namespace plumbline::study
