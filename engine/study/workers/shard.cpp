#include "engine/study/workers/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace plumbline::study {
namespace {

constexpr int kMostShards = 10'000;

Error no_whole(std::string message) {
    return {.message = std::move(message), .exit_code = ExitCode::Refused};
}

/// What keeps `head` from being a part of the same whole as `first`, or empty.
std::string stranger(const ShardHead& first, const ShardHead& head) {
    if (!head.shard || !first.shard) return "one of the folders holds no shard, but a whole";
    if (head.shard->of != first.shard->of || head.shard->what != first.shard->what)
        return fmt::format("shards of different work: {} of \"{}\" and {} of \"{}\"",
                           shard_text(*first.shard),
                           first.shard->what,
                           shard_text(*head.shard),
                           head.shard->what);
    if (head.build != first.build)
        return fmt::format(
            "shards of different builds: \"{}\" and \"{}\"", first.build, head.build);
    if (!head.complete) return fmt::format("shard {} was interrupted", shard_text(*head.shard));
    return "";
}

}  // namespace

std::optional<Shard> shard_from(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto number = [](std::string_view digits) -> int {
        int value = 0;
        const char* end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value);
        return error == std::errc{} && stop == end && value <= kMostShards ? value : 0;
    };
    Shard shard{.index = number(text.substr(0, slash)), .of = number(text.substr(slash + 1))};
    if (shard.index < 1 || shard.index > shard.of) return std::nullopt;
    return shard;
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.index, shard.of);
}

Result<std::vector<std::size_t>> order_of_shards(std::span<const ShardHead> heads) {
    if (heads.empty()) return no_whole("nothing to merge");
    for (const ShardHead& head : heads) {
        const std::string why = stranger(heads.front(), head);
        if (!why.empty()) return no_whole(why);
    }
    std::vector<std::size_t> order;
    for (int index = 1; index <= heads.front().shard->of; ++index) {
        const auto is_it = [&](const ShardHead& head) { return head.shard->index == index; };
        const auto found = std::ranges::find_if(heads, is_it);
        if (found == heads.end()) return no_whole(fmt::format("shard {} is missing", index));
        if (std::ranges::count_if(heads, is_it) > 1)
            return no_whole(fmt::format("shard {} is there twice", index));
        order.push_back(static_cast<std::size_t>(found - heads.begin()));
    }
    return order;
}

}  // namespace plumbline::study
