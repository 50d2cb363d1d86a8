// Settings, points and findings as JSON text and back, and findings as a table for spreadsheets.
// Numbers read back to the same bits; one that is not finite is written as null and read as NaN.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <string>

namespace plumbline::study {

/// {"solver": "small_step", "step_hz": 60, "substeps": 0, "substeps_max": 16, "iterations": 1,
///  "precision": "float32"}, on one line.
std::string setting_to_json(const Setting& setting);
std::string point_to_json(const Point& point);
std::string subject_to_json(const Subject& subject);
std::string findings_to_json(const Findings& findings);  ///< many lines, for files

/// The errors name the key or word that was not expected.
Result<Setting> setting_from_json(const std::string& text);
Result<Point> point_from_json(const std::string& text);
Result<Subject> subject_from_json(const std::string& text);
Result<Findings> findings_from_json(const std::string& text);

/// A heading, then one line per point and metric. Fields with commas or quotes are quoted (RFC 4180).
std::string findings_to_csv(const Findings& findings);

}  // namespace plumbline::study
