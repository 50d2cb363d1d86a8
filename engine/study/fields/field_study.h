// How wrong each effect that bodies feel is at each fidelity, and what that costs.
#pragma once

#include "engine/study/findings/effect_findings.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline::study {

/// All references at draft, balanced and precise. `shown` is called with the share that is done; interrupted: those measured
/// by then.
std::vector<EffectError> measure_references(const std::function<void(double share)>& shown = {});

/// A table for people.
std::string references_text(const std::vector<EffectError>& errors);

}  // namespace plumbline::study
