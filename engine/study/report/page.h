// The report page: one HTML file that needs nothing else. assets/report has its markup, style and
// scripts; what was measured is put into it as JSON, and the scripts draw it in the browser.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <span>
#include <string>

namespace plumbline::study {

/// The page of `json`, which is what findings.json or stability.json holds (stability.json with its
/// images). Of the figures of other engines the page gets those of `peer_scenes`. Refused: a file of
/// assets/report or assets/data that cannot be read.
Result<std::string> report_page(const std::string& json,
                                std::span<const std::string> peer_scenes = {});

/// The page of a study.
Result<std::string> study_page(const Findings& findings);

}  // namespace plumbline::study
