// What a study of scenarios found, as a table for a terminal.
#pragma once

#include "engine/study/findings/findings.h"

#include <string>

namespace plumbline::study {

/// Settings with their errors, cost and work, then the verdicts. Runs without an answer say why.
std::string subject_text(const Subject& subject);

}  // namespace plumbline::study
