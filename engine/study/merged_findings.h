// The parts of a study that several machines made, put together.
#pragma once

#include "engine/core/result.h"
#include "engine/study/findings/findings.h"

#include <span>

namespace plumbline::study {

/// The findings of all shards of one study as those of one run: points in the order of the whole,
/// verdicts and the spread of clocks made anew. Refused: what order_of_shards() refuses.
Result<Findings> merged(std::span<const Findings> shards);

}  // namespace plumbline::study
