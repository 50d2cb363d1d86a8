#include "engine/study/workers/worker_pool.h"

#include "engine/core/time/stopwatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace plumbline::study {
namespace {

const WorkerPrograms kFixture{
    .float32 = PL_WORKER_FIXTURE, .float64 = PL_WORKER_FIXTURE, .arguments = {}};

Job job(const char* kind, const char* body = "", double limit_s = 30) {
    return {.kind = kind, .body = body, .limit_s = limit_s};
}

/// The answers by job; every job has exactly one.
std::map<std::size_t, Answer> answers_to(const std::vector<Job>& jobs, int workers) {
    std::map<std::size_t, Answer> answers;
    const Result<bool> all = run_jobs(jobs,
                                      {.count = workers, .programs = kFixture},
                                      [&](std::size_t index, const Answer& answer) {
                                          EXPECT_TRUE(answers.emplace(index, answer).second)
                                              << "a second answer to " << index;
                                      });
    EXPECT_TRUE(all.ok()) << (all.ok() ? "" : all.error().message);
    EXPECT_TRUE(all.ok() && *all);
    EXPECT_EQ(answers.size(), jobs.size());
    return answers;
}

TEST(WorkerPool, EveryJobGetsItsOwnAnswer) {
    std::vector<Job> jobs;
    for (int i = 0; i < 50; ++i) {
        jobs.push_back({.kind = "echo",
                        .body = std::to_string(i),
                        .precision = i % 3 == 0 ? Precision::Float64 : Precision::Float32});
    }
    for (const int workers : {1, 2, 7}) {
        for (const auto& [index, answer] : answers_to(jobs, workers)) {
            EXPECT_EQ(answer.status, RunStatus::Done);
            EXPECT_EQ(answer.body, std::to_string(index));
        }
    }
}

TEST(WorkerPool, WhatTravelsComesBackWhole) {
    const std::string odd = "line\nbreak \"quoted\" \\ tab\t {\"a\": 1} \xC3\xA9";
    const auto answers = answers_to({{.kind = "echo", .body = odd}, job("many", "3000000")}, 2);
    EXPECT_EQ(answers.at(0).body, odd);
    EXPECT_EQ(answers.at(1).body.size(), 3'000'000U);
}

TEST(WorkerPool, AWorkerThatGoesWrongTakesOnlyItsJobAlong) {
    for (const int workers : {1, 3}) {
        const auto answers = answers_to({job("echo", "a"),
                                         job("crash"),
                                         job("echo", "b"),
                                         job("leave"),
                                         job("fail", "why not"),
                                         job("unheard_of"),
                                         job("chatter"),
                                         job("echo", "c")},
                                        workers);
        for (const std::size_t good : {0U, 2U, 7U})
            EXPECT_EQ(answers.at(good).status, RunStatus::Done) << good;
        EXPECT_EQ(answers.at(7).body, "c");
        EXPECT_EQ(answers.at(1).status, RunStatus::Crashed);
        EXPECT_NE(answers.at(1).body.find("signal 11"), std::string::npos) << answers.at(1).body;
        EXPECT_EQ(answers.at(3).status, RunStatus::Crashed);
        EXPECT_NE(answers.at(3).body.find("exit code 7"), std::string::npos) << answers.at(3).body;
        EXPECT_EQ(answers.at(4).status, RunStatus::Refused);
        EXPECT_EQ(answers.at(4).body, "fail: why not");
        EXPECT_EQ(answers.at(5).status, RunStatus::Refused);
        EXPECT_NE(answers.at(5).body.find("unheard_of"), std::string::npos);
        EXPECT_EQ(answers.at(6).status, RunStatus::Refused) << "chatter is no answer";
    }
}

TEST(WorkerPool, AWorkerThatHangsIsGivenUpAndTheNextJobHasAFreshOne) {
    const auto answers = answers_to({job("hang", "", 0.2), job("echo", "after")}, 1);
    EXPECT_EQ(answers.at(0).status, RunStatus::TimedOut);
    EXPECT_EQ(answers.at(0).body, "timed out after 0.2 s");
    EXPECT_EQ(answers.at(1).body, "after");
}

TEST(WorkerPool, RefusesWhereAProgramIsMissing) {
    WorkerPrograms programs = kFixture;
    programs.float64 = "/nowhere/plumbline-f64";
    const auto ignore = [](std::size_t, const Answer&) {};
    const std::vector<Job> single{job("echo")};
    EXPECT_TRUE(run_jobs(single, {.programs = programs}, ignore).ok()) << "nothing needs it";
    const std::vector<Job> jobs{{.kind = "echo", .precision = Precision::Float64}};
    const Result<bool> all = run_jobs(jobs, {.programs = programs}, ignore);
    ASSERT_FALSE(all.ok());
    EXPECT_NE(all.error().message.find("/nowhere/plumbline-f64"), std::string::npos);
}

TEST(WorkerPool, StopsWhenToldTo) {
    std::stop_source source;
    const std::vector<Job> jobs{job("echo", "a"), job("hang"), job("echo", "b")};
    const double start_s = wall_s();
    int answered = 0;
    const Result<bool> all = run_jobs(
        jobs, {.programs = kFixture, .stop = source.get_token()}, [&](std::size_t, const Answer&) {
            ++answered;
            source.request_stop();
        });
    ASSERT_TRUE(all.ok());
    EXPECT_FALSE(*all);
    EXPECT_EQ(answered, 1);
    EXPECT_LT(wall_s() - start_s, 20) << "the one that hangs was not waited for";
}

TEST(WorkerPool, NoJobsEndAtOnce) {
    EXPECT_TRUE(answers_to({}, 4).empty());
}

TEST(WorkerPool, AMissingProgramIsNamedWithWhatMakesIt) {
    WorkerPrograms programs = kFixture;
    programs.float64 = "/nowhere/plumbline-f64";
    EXPECT_TRUE(check_programs(programs, std::array{Precision::Float32}).ok());
    const Result<Done> missing =
        check_programs(programs, std::array{Precision::Float32, Precision::Float64});
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().exit_code, ExitCode::RunFailed);
    EXPECT_EQ(missing.error().message,
              "float64 runs need the program /nowhere/plumbline-f64, which is not there; ./play "
              "builds it, and so does `cmake --build` with the target plumbline-f64");
    const Result<bool> ran =
        run_jobs(std::vector{Job{.kind = "echo", .precision = Precision::Float64}},
                 {.programs = programs},
                 [](std::size_t, const Answer&) { ADD_FAILURE(); });
    EXPECT_FALSE(ran.ok());
}

}  // namespace
}  // namespace plumbline::study
