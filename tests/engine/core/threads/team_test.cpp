#include "engine/core/threads/team.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace plumbline {
namespace {

/// How often each of `count` items was worked on.
std::vector<int> visits_of(Team& team, std::size_t count, std::size_t grain) {
    std::vector<int> visits(count, 0);
    team.share(count, grain, [&](int, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    return visits;
}

TEST(Team, works_on_every_item_once_however_many_threads_and_ranges) {
    for (const int threads : {1, 2, 3, 7}) {
        Team team(threads);
        const AwakeTeam awake(&team);
        for (const std::size_t count : {0U, 1U, 2U, 63U, 1000U}) {
            for (const std::size_t grain : {1U, 8U, 2000U})
                EXPECT_EQ(visits_of(team, count, grain), std::vector<int>(count, 1));
        }
    }
}

TEST(Team, holds_over_very_many_short_lists) {
    Team team(3);
    const AwakeTeam awake(&team);
    std::vector<int> sums(4, 0);
    for (int list = 0; list < 20'000; ++list) {
        team.share(sums.size(), 1, [&](int, std::size_t begin, std::size_t) { ++sums[begin]; });
    }
    EXPECT_EQ(sums, std::vector<int>(4, 20'000));
}

TEST(Team, gives_each_thread_scratch_of_its_own) {
    Team team(4);
    const AwakeTeam awake(&team);
    std::vector<long> sums(4, 0);  // of each member: a race would lose some
    team.share(100'000, 10, [&](int member, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sums[static_cast<std::size_t>(member)] += 1;
    });
    EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0L), 100'000);
}

TEST(Team, asleep_the_caller_does_all_in_one_range) {
    Team team(4);
    int calls = 0;
    team.share(1000, 1, [&](int member, std::size_t begin, std::size_t end) {
        ++calls;
        EXPECT_EQ(member, 0);
        EXPECT_EQ(end - begin, 1000U);
    });
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(team.helpers_cpu_ms(), 0);
}

TEST(Team, wakes_again_and_again) {
    Team team(2);
    // A busy machine may leave the helper waiting for a while.
    for (int i = 0; i < 200 || (team.helpers_cpu_ms() == 0 && i < 1'000'000); ++i) {
        const AwakeTeam awake(&team);
        EXPECT_EQ(visits_of(team, 100, 1), std::vector<int>(100, 1));
    }
    EXPECT_GT(team.helpers_cpu_ms(), 0);
}

TEST(Team, throws_on_what_a_range_threw_and_works_on) {
    Team team(2);
    const AwakeTeam awake(&team);
    const auto fail_at = [&](std::size_t bad) {
        team.share(1000, 1, [&](int, std::size_t begin, std::size_t) {
            if (begin == bad) throw std::runtime_error("at the item");
        });
    };
    for (const std::size_t bad : {0U, 500U, 999U}) EXPECT_THROW(fail_at(bad), std::runtime_error);
    EXPECT_EQ(visits_of(team, 1000, 1), std::vector<int>(1000, 1));
}

TEST(Team, a_process_has_a_core_at_least) {
    EXPECT_GE(usable_cores(), 1);
}

}  // namespace
}  // namespace plumbline
