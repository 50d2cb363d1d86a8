// gnuplot as a child process.
#pragma once

#include "engine/core/result.h"

#include <string>

namespace plumbline::study {

/// The program that draws: PLUMBLINE_GNUPLOT, or "gnuplot" found along PATH.
std::string gnuplot_program();

/// What `program -d -` writes to its standard output for `script`, without anybody's own start-up
/// files. Refused: no such program, an exit code other than 0, nothing written or more
/// than any image has, or no end within `limit_s` (it is killed).
Result<std::string> run_gnuplot(const std::string& program,
                                const std::string& script,
                                double limit_s);

/// gnuplot's SVG as an element inside a page: no prologue, its size left to the page, its ids begun
/// with `prefix` so that two on one page do not meet, `name` as its title. Refused: not an SVG.
Result<std::string> inline_svg(const std::string& svg,
                               const std::string& prefix,
                               const std::string& name);

}  // namespace plumbline::study
