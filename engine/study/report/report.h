// The page of a study: one HTML file that needs nothing else, for people; findings.json and
// findings.csv beside it hold the same numbers for programs.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <filesystem>

namespace plumbline::study {

/// Writes `folder`/report.html: what was asked, how to read it, and for each subject its set-up,
/// reference, diagrams and tables. Runs that failed are shown in red, never left out.
/// Diagrams are drawn by gnuplot (the program that PLUMBLINE_GNUPLOT names, or `gnuplot`); without it
/// the page has all tables and one line that says what is missing. The same for assets/data/peers.csv.
/// Refused: what write_file_atomically refuses.
Result<Done> write_report(const Findings& findings, const std::filesystem::path& folder);

}  // namespace plumbline::study
