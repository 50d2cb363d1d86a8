#include "game/program.h"

#include "engine/core/io/output.h"
#include "engine/core/process/interrupt.h"
#include "game/command_line/refuse.h"

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
    ignore_write_signals();
    int code = run_to_the_end(commands, argc, argv);
    cancel_cut_off();
    const int interrupted_code = static_cast<int>(ExitCode::Interrupted);
    if (interrupted() && (code == 0 || code == interrupted_code)) {
        std::fputs("plumbline: interrupted\n", stderr);
        code = interrupted_code;
    }
    const Result<Done> written = flush_standard_output();
    if (written) return code;
    const ExitCode failed = refuse(written.error());
    return code != 0 ? code : static_cast<int>(failed);
}

}  // namespace plumbline::game
