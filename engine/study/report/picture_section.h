// The part of the page that shows what the picture's accuracy costs.
#pragma once

#include "engine/study/picture/picture_findings.h"
#include "engine/study/report/diagrams/plot.h"

#include <optional>
#include <string>

namespace plumbline::study {

/// Error against CPU ms of a frame: one point a row, those that nothing beats joined. Empty: fewer than two
/// rows have both.
std::optional<Plot> picture_plot(const PictureFindings& findings);
/// What it was held against, and the table of all rows, as HTML.
std::string picture_table(const PictureFindings& findings);

}  // namespace plumbline::study
