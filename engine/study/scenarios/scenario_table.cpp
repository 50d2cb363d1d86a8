#include "engine/study/scenarios/scenario.h"

#include <algorithm>

namespace plumbline::study {

const std::vector<Scenario>& scenarios() {
    static const std::vector<Scenario> all = [] {
        std::vector<Scenario> made;
        add_flight(made);
        add_tops(made);
        add_pendulums(made);
        add_chains(made);
        add_bounces(made);
        add_impacts(made);
        add_sliding(made);
        add_rolling(made);
        add_supports(made);
        add_leaving(made);
        add_invariances(made);
        add_peer_scenes(made);
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
