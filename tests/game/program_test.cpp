// How the programs end, whatever a command did.
#include "game/program.h"

#include "engine/core/process/exit_code.h"
#include "engine/core/process/interrupt.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace plumbline::game {
namespace {

int code_of(int (*commands)(int, char**)) {
    return run_program(commands, 0, nullptr);
}

TEST(Program, EndsWithTheCodeOfItsCommand) {
    for (const ExitCode code : {ExitCode::Good, ExitCode::Refused}) {
        static ExitCode given;
        given = code;
        EXPECT_EQ(code_of([](int, char**) { return static_cast<int>(given); }),
                  static_cast<int>(code));
    }
}

TEST(Program, RefusedMemoryAndFaultsAreCodes) {
    EXPECT_EQ(code_of([](int, char**) -> int { throw std::bad_alloc(); }),
              static_cast<int>(ExitCode::OutOfMemory));
    EXPECT_EQ(code_of([](int, char**) -> int { throw std::runtime_error("no such luck"); }),
              static_cast<int>(ExitCode::RunFailed));
}

/// Ends as the program would, after a signal within a command that gives a code.
template <ExitCode kCode>
[[noreturn]] void run_interrupted() {
    const auto command = [](int, char**) {
        catch_interrupts();
        std::raise(SIGTERM);
        return static_cast<int>(kCode);
    };
    std::_Exit(run_program(command, 0, nullptr));
}

TEST(ProgramDeathTest, ASignalIsALineAndACodeUnlessTheCommandFailed) {
    EXPECT_EXIT(run_interrupted<ExitCode::Good>(),
                testing::ExitedWithCode(130),
                "^plumbline: interrupted\n$");
    EXPECT_EXIT(run_interrupted<ExitCode::Interrupted>(),
                testing::ExitedWithCode(130),
                "^plumbline: interrupted\n$");
    EXPECT_EXIT(run_interrupted<ExitCode::RunFailed>(), testing::ExitedWithCode(1), "^$");
}

}  // namespace
}  // namespace plumbline::game
