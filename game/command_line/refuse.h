// How every command ends that cannot do what it was told.
#pragma once

#include "engine/core/log.h"
#include "engine/core/result.h"

namespace plumbline::game {

inline ExitCode refuse(const Error& error) {
    log_error("{}", error.message);
    return error.exit_code;
}

}  // namespace plumbline::game
