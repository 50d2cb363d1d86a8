// Confines a process that decodes what strangers wrote.
#pragma once

#include "engine/core/result.h"

#include <cstddef>

namespace plumbline {

struct SandboxLimits {
    std::size_t memory_bytes{0};  ///< beyond what the process has mapped already
    unsigned cpu_s{0};
};

/// From now on the calling process, which has one thread, can compute, allocate memory, read and write
/// its three standard streams, and end. Opening a file fails; nearly any other system call ends it
/// (SIGSYS), as does more than `cpu_s` of CPU time (SIGXCPU); memory beyond the limit is refused
/// (std::bad_alloc). It ends with the
/// process that started it. The error says why the kernel does not confine it.
///
/// Under a sanitizer, whose runtime needs more of both, only the limit on CPU time holds.
Result<Done> enter_sandbox(const SandboxLimits& limits);

}  // namespace plumbline
