// Parts of a study, and the whole that they make.
#include "engine/study/merged_findings.h"

#include "engine/study/findings/findings_json.h"
#include "engine/study/scenarios/scenario_study.h"
#include "engine/study/workers/shard.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::study {
namespace {

/// A study of two scenarios and a scene, as one machine would find it.
Findings whole_study() {
    Findings findings{.command = "plumbline study x", .build = "1.0"};
    for (const char* id : {"A01", "A28"}) {
        const Scenario& scenario = *scenario_of(id);
        Subject subject{.id = id, .metrics = scenario.metrics};
        double error = 1;
        for (const Setting& setting : grid_of(scenario, Effort::Quick)) {
            subject.points.push_back(
                {.setting = setting,
                 .errors = std::vector(scenario.metrics.size(), error /= 2),
                 .cost = {.ms_per_s_min = 1, .ms_per_s_median = 1 + error, .repeats = 3}});
        }
        subject.verdicts = verdicts_of(subject.points, scenario.theory);
        findings.subjects.push_back(std::move(subject));
    }
    findings.subjects.push_back({.id = "scenes/a.toml", .points = std::vector<Point>(3)});
    findings.clock_spread = clock_spread_of(findings.subjects);
    return findings;
}

/// What shard `index` of `of` does of it.
Findings shard_of(const Findings& whole, int index, int of) {
    Findings part = whole;
    part.subjects.clear();
    part.shard = Shard{.index = index, .of = of, .what = whole.command};
    std::size_t run = 0;
    for (const Subject& subject : whole.subjects) {
        Subject own = subject;
        own.points.clear();
        own.verdicts.clear();
        if (scenario_of(subject.id) == nullptr) {
            if (part.shard->has(run++)) part.subjects.push_back(subject);
            continue;
        }
        for (const Point& point : subject.points) {
            if (part.shard->has(run++)) own.points.push_back(point);
        }
        if (!own.points.empty()) part.subjects.push_back(own);
    }
    return part;
}

std::vector<Findings> shards_of(const Findings& whole, int of) {
    std::vector<Findings> parts;
    for (int index = of; index >= 1; --index) parts.push_back(shard_of(whole, index, of));
    return parts;
}

std::string refusal(std::span<const Findings> parts) {
    const Result<Findings> made = merged(parts);
    EXPECT_FALSE(made.ok());
    return made ? "" : made.error().message;
}

TEST(Shard, IsReadFromItsText) {
    const std::optional<Shard> second = shard_from("2/4");
    ASSERT_TRUE(second);
    EXPECT_EQ(shard_text(*second), "2/4");
    EXPECT_TRUE(second->has(1) && second->has(5));
    EXPECT_FALSE(second->has(0) || second->has(2) || second->has(4));
    for (const char* wrong :
         {"", "2", "/", "0/4", "5/4", "-1/4", "2/", "/4", "2/4/1", "a/4", "2/4 ", "1/999999999999"})
        EXPECT_FALSE(shard_from(wrong)) << wrong;
}

TEST(Shard, AllOfThemAreTheWholeToTheLastByte) {
    const Findings whole = whole_study();
    for (const int of : {1, 2, 3, 4, 7, 50}) {
        std::vector<Findings> parts;
        for (const Findings& part : shards_of(whole, of)) {
            const Result<Findings> read = findings_from_json(findings_to_json(part));
            ASSERT_TRUE(read.ok()) << read.error().message;
            parts.push_back(*read);
        }
        const Result<Findings> made = merged(parts);
        ASSERT_TRUE(made.ok()) << of << ": " << made.error().message;
        EXPECT_EQ(findings_to_json(*made), findings_to_json(whole)) << of;
        EXPECT_EQ(findings_to_csv(*made), findings_to_csv(whole)) << of;
    }
}

TEST(Shard, WhatIsNoWholeIsRefused) {
    const Findings whole = whole_study();
    const std::vector<Findings> parts = shards_of(whole, 3);
    EXPECT_EQ(refusal({}), "nothing to merge");
    EXPECT_EQ(refusal(std::span(parts).first(2)), "shard 1 is missing");
    EXPECT_EQ(refusal({{parts[0], parts[1], parts[1], parts[2]}}), "shard 2 is there twice");
    EXPECT_EQ(refusal({{parts[0], whole}}), "one of the folders holds no shard, but a whole");
    std::vector<Findings> odd = parts;
    odd[1].complete = false;
    EXPECT_EQ(refusal(odd), "shard 2/3 was interrupted");
    odd = parts;
    odd[1].build = "1.1";
    EXPECT_EQ(refusal(odd), "shards of different builds: \"1.0\" and \"1.1\"");
    odd = parts;
    odd[1].shard->what = "plumbline study y";
    EXPECT_EQ(
        refusal(odd),
        "shards of different work: 3/3 of \"plumbline study x\" and 2/3 of \"plumbline study y\"");
    EXPECT_EQ(
        refusal({{parts[0], shards_of(whole, 2)[0]}}),
        "shards of different work: 3/3 of \"plumbline study x\" and 2/2 of \"plumbline study x\"");
}

}  // namespace
}  // namespace plumbline::study
