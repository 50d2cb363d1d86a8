#include "game/program.h"

#include "engine/core/io/output.h"
#include "game/command_line/refuse.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace plumbline::game {
namespace {

int run_to_the_end(int (*commands)(int, char**), int argc, char** argv) {
    try {
        return commands(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("plumbline: error: out of memory\n", stderr);
        return static_cast<int>(ExitCode::OutOfMemory);
    } catch (const std::exception& fault) {
        return static_cast<int>(refuse({.message = fault.what()}));
    }
}

}  // namespace

int run_program(int (*commands)(int, char**), int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    const int code = run_to_the_end(commands, argc, argv);
    const Result<Done> written = flush_standard_output();
    if (written) return code;
    const ExitCode failed = refuse(written.error());
    return code != 0 ? code : static_cast<int>(failed);
}

}  // namespace plumbline::game
