// Findings as JSON text and back, and as a table for spreadsheets. Numbers read back to the same bits;
// one that is not finite is written as null and read as NaN.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <string>

namespace plumbline::study {

std::string findings_to_json(const Findings& findings);
/// A JSON array with an object for each reference at each fidelity (docs/SCENE-FORMAT.md).
std::string references_to_json(const std::vector<EffectError>& errors);
/// The error names the key or word that was not expected.
Result<Findings> findings_from_json(const std::string& text);

/// A heading, then one line per point and metric. Fields with commas or quotes are quoted (RFC 4180).
std::string findings_to_csv(const Findings& findings);

}  // namespace plumbline::study
