// The part of the page that shows what the image's accuracy costs.
#pragma once

#include "engine/study/image/image_findings.h"
#include "engine/study/report/diagrams/plot.h"

#include <optional>
#include <string>

namespace plumbline::study {

/// Error against CPU ms of a frame: one point a row, those that nothing beats joined. Empty: fewer than two
/// rows have both.
std::optional<Plot> image_plot(const ImageFindings& findings);
/// What it was held against, and the table of all rows, as HTML.
std::string image_table(const ImageFindings& findings);

}  // namespace plumbline::study
