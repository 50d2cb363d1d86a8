#include "engine/core/process/process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline {
namespace {

ChildDef shell(const std::string& script) {
    return {.program = "sh", .arguments = {"-c", script}};
}

/// All up to the end of its output.
std::string all_of(const ChildProcess& child) {
    std::string text;
    while (child.receive(text)) {
    }
    return text;
}

struct ChildOutput {
    std::string bytes;
    ChildEnd end;
};

/// All that a program prints, which may be so much.
Result<ChildOutput> output_of(const ChildDef& def,
                              std::string_view input,
                              std::size_t max_bytes,
                              double limit_s) {
    ChildOutput output;
    const auto take = [&](std::string_view piece) {
        output.bytes += piece;
        return output.bytes.size() <= max_bytes;
    };
    Result<ChildEnd> end = output_to(take, def, input, limit_s);
    if (!end) return end.error();
    output.end = std::move(*end);
    return output;
}

TEST(ChildOutput, IsAllThatItPrintsHoweverMuchGoesInAndOut) {
    const std::string input(300'000, 'x');  // longer than any pipe
    const Result<ChildOutput> output = output_of(shell("cat; echo end"), input, 400'000, 20);
    ASSERT_TRUE(output) << output.error().message;
    EXPECT_EQ(output->bytes, input + "end\n");
    EXPECT_TRUE(output->end.good);
}

TEST(ChildOutput, OneThatReadsNothingEndsNobody) {
    const std::string input(300'000, 'x');
    EXPECT_EQ(output_of(shell("exec 0<&-; echo here"), input, 100, 20)->bytes, "here\n");
    EXPECT_EQ(output_of(shell("cat"), {}, 100, 20)->bytes, "");
}

TEST(ChildOutput, SaysHowItEnded) {
    EXPECT_EQ(output_of(shell("exit 3"), {}, 100, 20)->end.words, "ended with exit code 3");
    const ChildEnd killed = output_of(shell("kill -SEGV $$"), {}, 100, 20)->end;
    EXPECT_FALSE(killed.good);
    EXPECT_EQ(killed.words, "was ended by signal 11 (Segmentation fault)");
    // Its output ends before it does: waited for all the same.
    EXPECT_EQ(output_of(shell("exec >&-; sleep 0.2; exit 7"), {}, 100, 20)->end.words,
              "ended with exit code 7");
}

TEST(ChildOutput, HasLimits) {
    EXPECT_EQ(output_of(shell("exec sleep 1000"), {}, 100, 0.2).error().message,
              "sh did not end within 0.2 s");
    EXPECT_EQ(output_of(shell("exec >&-; exec sleep 1000"), {}, 100, 0.2)->end.words,
              "was ended by signal 9 (Killed)");
    EXPECT_EQ(output_of(shell("exec cat /dev/zero"), {}, 100'000, 20).error().message,
              "sh answered too much");
    EXPECT_EQ(output_of({.program = "/no/such"}, {}, 100, 20).error().message,
              "cannot start /no/such: No such file or directory");
}

TEST(ChildProcess, WhatItSaidLastComesWithItsEnd) {
    ChildDef def = shell("cat >/dev/null; echo no room >&2; echo bye; exit 4");
    def.tells_us = true;
    Result<ChildProcess> child = ChildProcess::start(def);
    ASSERT_TRUE(child) << child.error().message;
    child->close_input();
    const ChildEnd end = child->end(20);
    EXPECT_EQ(end.words, "ended with exit code 4");
    EXPECT_EQ(end.said, "no room\nbye\n");
    // One that it left behind holds the pipe: it is not waited for.
    Result<ChildProcess> parent = ChildProcess::start(shell("sleep 3 & exit 0"));
    ASSERT_TRUE(parent) << parent.error().message;
    EXPECT_EQ(parent->end(20).said, "");
}

TEST(ChildProcess, GivesWayWhereThatIsAskedFor) {
    const int own = getpriority(PRIO_PROCESS, 0);
    for (const Priority priority : {Priority::Same, Priority::Low, Priority::Idle}) {
        // proc(5): field 41 is the scheduling policy.
        ChildDef def = shell("read go; nice; cut -d' ' -f41 /proc/self/stat");
        def.priority = priority;
        Result<ChildProcess> child = ChildProcess::start(def);
        ASSERT_TRUE(child) << child.error().message;
        ASSERT_TRUE(child->send_line("now"));
        const int nice = priority == Priority::Same ? own : std::max(own, 10);
        EXPECT_EQ(
            all_of(*child),
            fmt::format("{}\n{}\n", nice, priority == Priority::Idle ? SCHED_IDLE : SCHED_OTHER));
    }
}

TEST(ChildProcess, AnswersLineByLine) {
    Result<ChildProcess> child = ChildProcess::start(shell("read a; echo $a $a; read b; echo $b"));
    ASSERT_TRUE(child) << child.error().message;
    std::string text;
    ASSERT_TRUE(child->send_line("one"));
    ASSERT_TRUE(child->receive(text));
    EXPECT_EQ(text, "one one\n");
    ASSERT_TRUE(child->send_line("two"));
    EXPECT_EQ(all_of(*child), "two\n");
    EXPECT_TRUE(child->end(20).good);
}

TEST(ChildProcess, ThoseThatHaveSpokenAreFoundAmongOthers) {
    const Result<ChildProcess> silent = ChildProcess::start(shell("cat"));
    const Result<ChildProcess> speaks = ChildProcess::start(shell("read line; echo $line"));
    ASSERT_TRUE(silent && speaks);
    const std::array<const ChildProcess*, 2> both{&*silent, &*speaks};
    EXPECT_EQ(wait_for_output(both, 0), (std::vector<bool>{false, false}));
    EXPECT_FALSE(speaks->has_output());
    ASSERT_TRUE(speaks->send_line("word"));
    EXPECT_EQ(wait_for_output(both, 20), (std::vector<bool>{false, true}));
    EXPECT_TRUE(speaks->has_output());
    std::string said;
    EXPECT_TRUE(speaks->receive(said));
    EXPECT_EQ(said, "word\n");
    // The end of its pipe is news too.
    EXPECT_EQ(wait_for_output(both, 20), (std::vector<bool>{false, true}));
    EXPECT_FALSE(speaks->receive(said));
}

TEST(AnswerPipe, KeepsAnswersApartFromWhatIsPrinted) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int before = dup(STDOUT_FILENO);
    {
        const AnswerPipe answers;
        ASSERT_EQ(write(STDOUT_FILENO, "noise\n", 6), 6);
        EXPECT_TRUE(answers.send_line("answer"));
    }
    dup2(before, STDOUT_FILENO);
    close(before);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "answer\n");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "noise\n");
}

TEST(ChildProcess, IsOfAGroupOfItsOwnWhereThatIsAskedFor) {
    for (const bool own : {false, true}) {
        // The fifth word is the group.
        ChildDef def =
            shell("read pid name state parent group rest </proc/$$/stat; echo $group $$");
        def.own_group = own;
        Result<ChildProcess> child = ChildProcess::start(def);
        ASSERT_TRUE(child) << child.error().message;
        const std::string said = all_of(*child);
        const std::string group = said.substr(0, said.find(' '));
        const std::string pid = said.substr(said.find(' ') + 1);
        EXPECT_EQ(group, own ? pid.substr(0, pid.size() - 1) : std::to_string(::getpgrp()));
    }
}

TEST(ChildProcess, DoesNotOutliveItsOwner) {
    pid_t pid = 0;
    {
        Result<ChildProcess> child = ChildProcess::start(shell("echo $$; exec sleep 1000"));
        ASSERT_TRUE(child) << child.error().message;
        std::string text;
        ASSERT_TRUE(child->receive(text));
        pid = std::atoi(text.c_str());
        ASSERT_EQ(::kill(pid, 0), 0);
        const ChildProcess moved = std::move(*child);
        EXPECT_EQ(::kill(pid, 0), 0) << "moving ends nothing";
    }
    EXPECT_EQ(::kill(pid, 0), -1);
    EXPECT_EQ(errno, ESRCH);
}

/// How a process ended that ends with its parent and writes to `output`.
int end_of_one_that_writes_to(int output) {
    const pid_t pid = fork();
    if (pid == 0) {
        dup2(output, STDOUT_FILENO);
        end_with_parent();
        _exit(3);
    }
    int how = 0;
    EXPECT_EQ(waitpid(pid, &how, 0), pid);
    return how;
}

TEST(EndWithParent, IsAtOnceWhereTheParentWasQuicker) {
    std::array<int, 2> pipe_ends{};
    ASSERT_EQ(pipe(pipe_ends.data()), 0);
    const int heard = end_of_one_that_writes_to(pipe_ends[1]);
    EXPECT_TRUE(WIFEXITED(heard) && WEXITSTATUS(heard) == 3);
    close(pipe_ends[0]);
    const int unheard = end_of_one_that_writes_to(pipe_ends[1]);
    EXPECT_TRUE(WIFSIGNALED(unheard) && WTERMSIG(unheard) == SIGKILL);
    close(pipe_ends[1]);
}

}  // namespace
}  // namespace plumbline
