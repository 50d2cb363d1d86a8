// The tables of the page, as HTML. Every table shows every run; those without an answer are red.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/report/peers.h"

#include <span>
#include <string>
#include <string_view>

namespace plumbline::study {

/// One row a subject: link, tier, what 1 % costs with whom.
std::string contents_table(const Findings& findings);

/// Where a section begins: "s3".
std::string anchor_of(std::size_t subject_index);

/// What 1 % of error costs in one line: the cheapest setting, and each solver's price.
std::string verdict_line(const Subject& subject);

/// Knobs with their order and what it means in a sentence. Empty where there are none.
std::string verdict_table(const Subject& subject);

/// Cost to reach 5 %, 1 %, 0.1 %, and error at 0.1, 0.5, 2 ms a frame, per solver and precision: for
/// the first metric, and folded in for the worst of all.
std::string cost_tables(const Subject& subject);

/// Every run, all metrics, folded in.
std::string points_table(const Subject& subject);

/// Every peer of a diagram, by rising cost, folded in. Empty where there are none.
std::string peer_table(std::span<const PeerPoint> peers);

/// "3 of 40 runs failed: 2 exploded, 1 timed out." in red; empty when all did.
std::string failure_line(const Subject& subject);

/// What T1 to T5 mean, in words.
std::string tier_table();
std::string_view tier_words(Tier tier);

}  // namespace plumbline::study
