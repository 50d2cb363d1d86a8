// A part of a study or of the stability table that one of several machines does, and its way back
// into the whole.
#pragma once

#include "engine/study/findings/findings.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

/// "2/4" as the second of four; none for what is no such text.
std::optional<Shard> shard_from(std::string_view text);

/// What tells whether a part belongs to others.
struct ShardHead {
    std::optional<Shard> shard;
    std::string build;
    bool complete{true};
};
/// Places of `heads` by the number of their shard. Refused: what is whole, parts of different
/// studies or builds, one that is missing, twice there or interrupted.
Result<std::vector<std::size_t>> order_of_shards(std::span<const ShardHead> heads);

}  // namespace plumbline::study
