// Which points of a subject a diagram joins: those that one knob leads through.
#pragma once

#include "engine/study/findings/findings.h"

#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

struct KnobLine {
    std::string name;
    bool is_of_rate{true};  ///< false: sub-steps or iterations change along it, or it is one point
    std::vector<const Point*> points;  ///< by rising effort; at least one
};

/// Every point is on a line: on that of its step rate where others differ from it in that alone, else
/// on one of its sub-steps, else of its iterations, else alone. A line of sub-steps or iterations also
/// has the point of a rate's line from which the knob was turned.
std::vector<KnobLine> knob_lines(std::span<const Point> points);

}  // namespace plumbline::study
