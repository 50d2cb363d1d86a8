// The diagrams of a subject: error against cost, and error against step.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/report/diagrams/plot.h"
#include "engine/study/report/peers.h"

#include <optional>
#include <span>
#include <string>

namespace plumbline::study {

/// What is drawn for an error: its size, and where it is zero or less than arithmetic can tell, the
/// rounding level of the precision (1.2e-7, 2.2e-16). Empty: not a number, or infinite.
std::optional<double> drawn_error(double error, Precision precision);

/// Error of the first metric against CPU ms per simulated second: a line per solver, precision
/// and effort along which the step rate changes, a dotted one where only sub-steps or iterations do;
/// the cheapest settings for their error ringed, runs without an answer as red crosses at the top, peers in grey,
/// costs a frame and tolerances as guide lines. Empty: no run gave an error at a cost.
std::optional<Plot> work_precision_plot(const Subject& subject, std::span<const PeerPoint> peers);

/// Error of the first metric against the step that the solver takes (step / least sub-steps), with the
/// Euler floor, and the slopes of first and second order. Empty: fewer than two different steps.
std::optional<Plot> step_plot(const Subject& subject);

}  // namespace plumbline::study
