#include "engine/core/time/trace_events.h"

#include "engine/core/threads/team.h"
#include "engine/core/time/stopwatch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace plumbline {
namespace {

using Json = nlohmann::json;

/// The spans of all that a recording gave, without what names the process.
std::vector<Json> spans_of(const std::string& taken) {
    std::vector<Json> spans;
    for (const Json& event : Json::parse(taken + std::string(TraceRecording::kEnd))) {
        if (event.at("ph") == "X") spans.push_back(event);
    }
    return spans;
}

void work_for(double seconds) {
    const double start_s = wall_s();
    while (wall_s() < start_s + seconds) {
    }
}

TEST(TraceEvents, ASpanLiesWithinTheOneItIsOpenedIn) {
    TraceRecording recording;
    {
        const TraceSpan outer("outer");
        work_for(1e-4);
        {
            TraceSpan inner("inner");
            inner.note("bodies", 7);
            work_for(2e-4);
        }
    }
    const std::vector<Json> spans = spans_of(recording.take());
    ASSERT_EQ(spans.size(), 2U);
    const Json& inner = spans[0];
    const Json& outer = spans[1];
    EXPECT_EQ(inner.at("name"), "inner");
    EXPECT_EQ(outer.at("name"), "outer");
    EXPECT_EQ(inner.at("args").at("bodies"), 7);
    EXPECT_FALSE(outer.contains("args"));
    const auto end_of = [](const Json& span) {
        return span.at("ts").get<double>() + span.at("dur").get<double>();
    };
    EXPECT_GE(inner.at("dur").get<double>(), 199.0);
    EXPECT_GE(inner.at("ts").get<double>(), outer.at("ts").get<double>() + 99.0);
    EXPECT_LE(end_of(inner), end_of(outer) + 0.002);  // of a microsecond, three digits
}

TEST(TraceEvents, EachThreadHasItsOwnNumber) {
    TraceRecording recording;
    Team team(3);
    std::map<int, std::size_t> ranges;
    {
        const AwakeTeam awake(&team);
        std::vector<int> member_of(300);
        team.share(member_of.size(), 1, [&](int member, std::size_t begin, std::size_t) {
            const TraceSpan span("range");
            member_of[begin] = member;
            work_for(2e-5);
        });
        for (const int member : member_of) ++ranges[member];
    }
    std::map<int, std::size_t> spans;
    for (const Json& span : spans_of(recording.take())) ++spans[span.at("tid").get<int>()];
    std::multiset<std::size_t> of_members;
    std::multiset<std::size_t> of_threads;
    for (const auto& [member, count] : ranges) of_members.insert(count);
    for (const auto& [thread, count] : spans) of_threads.insert(count);
    EXPECT_EQ(of_threads, of_members);
    EXPECT_EQ(spans[0], ranges[0]) << "the recording's own thread is the team's first";
}

TEST(TraceEvents, WhatIsTakenIsOneListAndComesOnce) {
    TraceRecording recording;
    { const TraceSpan span("first"); }
    std::string taken = recording.take();
    { const TraceSpan span("second"); }
    taken += recording.take();
    taken += recording.take();
    const std::vector<Json> spans = spans_of(taken);
    ASSERT_EQ(spans.size(), 2U);
    EXPECT_EQ(spans[0].at("name"), "first");
    EXPECT_EQ(spans[1].at("name"), "second");
}

TEST(TraceEvents, NothingIsKeptBeforeOrAfterARecording) {
    { const TraceSpan span("before"); }
    {
        TraceRecording recording;
        { const TraceSpan span("of the first"); }
    }
    { const TraceSpan span("between"); }
    TraceRecording recording;
    EXPECT_TRUE(spans_of(recording.take()).empty());
    { const TraceSpan span("of the second"); }
    EXPECT_EQ(spans_of(recording.take().insert(0, "[{\"ph\":\"M\"}")).size(), 1U);
}

TEST(TraceEvents, NotesBeyondTheMostAreLeftOut) {
    TraceRecording recording;
    {
        TraceSpan span("span");
        for (const char* key : {"a", "b", "c", "d", "e", "f"}) span.note(key, 1);
    }
    EXPECT_EQ(spans_of(recording.take())[0].at("args").size(), TraceSpan::kMostNotes);
}

}  // namespace
}  // namespace plumbline
