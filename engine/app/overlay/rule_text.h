// A rule of a hard case as people read it: "drift 0.00 of 10 mm".
#pragma once

#include "engine/study/gallery/hard_case_judge.h"

#include <string>

namespace plumbline::app {

/// The measure's name, its worst value so far and what is allowed, in a unit that suits the limit.
/// Before the rule's time has come: what is allowed, and from when.
std::string rule_text(const study::RuleState& rule);

}  // namespace plumbline::app
