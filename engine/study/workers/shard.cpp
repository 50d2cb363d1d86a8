#include "engine/study/workers/shard.h"

#include "engine/study/scenarios/scenario_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace plumbline::study {
namespace {

constexpr int kMostShards = 10'000;

/// A run or, of a scene, whose runs follow from each other, all of them.
struct Unit {
    const Subject* subject;
    std::span<const Point> points;
};

std::vector<Unit> units_of(const Findings& findings) {
    std::vector<Unit> units;
    for (const Subject& subject : findings.subjects) {
        const std::span points(subject.points);
        if (scenario_of(subject.id) == nullptr) {
            units.push_back({&subject, points});
            continue;
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            units.push_back({&subject, points.subspan(i, 1)});
    }
    return units;
}

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

void add(Findings& whole, const Unit& unit) {
    if (scenario_of(unit.subject->id) == nullptr) {
        whole.subjects.push_back(*unit.subject);
        return;
    }
    auto subject = std::ranges::find(whole.subjects, unit.subject->id, &Subject::id);
    if (subject == whole.subjects.end()) {
        whole.subjects.push_back(*unit.subject);
        subject = std::prev(whole.subjects.end());
        subject->points.clear();
    }
    subject->points.insert(subject->points.end(), unit.points.begin(), unit.points.end());
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

Result<Findings> merged(std::span<const Findings> shards) {
    std::vector<ShardHead> heads;
    for (const Findings& each : shards)
        heads.push_back({.shard = each.shard, .build = each.build, .complete = each.complete});
    const Result<std::vector<std::size_t>> order = order_of_shards(heads);
    if (!order) return order.error();
    std::vector<std::vector<Unit>> units;
    for (const std::size_t at : *order) units.push_back(units_of(shards[at]));
    Findings whole{.command = shards.front().shard->what,
                   .machine = shards.front().machine,
                   .build = shards.front().build,
                   .made_on = shards.front().made_on};
    // Shards take units in turn.
    for (std::size_t i = 0; i < units.front().size(); ++i) {
        for (const std::vector<Unit>& own : units) {
            if (i < own.size()) add(whole, own[i]);
        }
    }
    for (Subject& subject : whole.subjects) {
        if (const Scenario* scenario = scenario_of(subject.id))
            subject.verdicts = verdicts_of(subject.points, scenario->theory);
    }
    whole.clock_spread = clock_spread_of(whole.subjects);
    return whole;
}

}  // namespace plumbline::study
