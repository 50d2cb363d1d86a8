#include "engine/core/process/sandbox.h"

#include "engine/core/process/process.h"

#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <vector>

namespace plumbline {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kConfined = false;
#else
constexpr bool kConfined = true;
#endif

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
#error "add this processor's AUDIT_ARCH constant"
#endif

/// What memory, the standard streams, signals of its own and the end of a process need. mmap and
/// mprotect are among them: a heap grows with both.
constexpr std::array kAllowed{SYS_read,   SYS_readv,        SYS_write,         SYS_writev,
                              SYS_lseek,  SYS_fstat,        SYS_close,         SYS_mmap,
                              SYS_munmap, SYS_mremap,       SYS_mprotect,      SYS_madvise,
                              SYS_brk,    SYS_futex,        SYS_clock_gettime, SYS_getrandom,
                              SYS_getpid, SYS_gettid,       SYS_rt_sigaction,  SYS_rt_sigprocmask,
                              SYS_alarm,  SYS_rt_sigreturn, SYS_exit,          SYS_exit_group};

// What libraries ask for and do without: files beside a sound, what a stream is, how much memory there is
// (qsort() asks).
constexpr std::array kFailing{SYS_openat, SYS_newfstatat, SYS_ioctl, SYS_sysinfo};

sock_filter load(std::size_t offset) {
    return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

sock_filter answer(std::uint32_t action) {
    return BPF_STMT(BPF_RET | BPF_K, action);
}

/// Goes on with the next instruction where the loaded word is `value`, else passes over one.
sock_filter if_equal(std::uint32_t value) {
    return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
}

/// seccomp's program: it sees a call's number and the low words of its arguments (both processors store
/// the low word first).
std::vector<sock_filter> call_filter() {
    std::vector<sock_filter> program{load(offsetof(seccomp_data, arch)),
                                     BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
                                     answer(SECCOMP_RET_KILL_PROCESS),
                                     load(offsetof(seccomp_data, nr))};
    const auto add = [&](long call, std::uint32_t action) {
        program.push_back(if_equal(static_cast<std::uint32_t>(call)));
        program.push_back(answer(action));
    };
    for (const long call : kAllowed) add(call, SECCOMP_RET_ALLOW);
    for (const long call : kFailing) add(call, SECCOMP_RET_ERRNO | EPERM);
    // abort() signals its own process; nobody else may be signalled.
    program.push_back(
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(SYS_tgkill), 0, 3));
    program.push_back(load(offsetof(seccomp_data, args)));
    program.push_back(if_equal(static_cast<std::uint32_t>(getpid())));
    program.push_back(answer(SECCOMP_RET_ALLOW));
    program.push_back(answer(SECCOMP_RET_KILL_PROCESS));
    return program;
}

std::size_t mapped_bytes() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

bool limit(__rlimit_resource_t resource, rlim_t most, rlim_t grace = 0) {
    const rlimit both{.rlim_cur = most, .rlim_max = most + grace};
    return setrlimit(resource, &both) == 0;
}

}  // namespace

Result<Done> enter_sandbox(const SandboxLimits& limits) {
    const auto refused = [] {
        return Error{.message = fmt::format("it cannot be confined: {}", strerror(errno))};
    };
    end_with_parent();
    tzset();  // what logs the time would read a file for it later
    // A second after SIGXCPU, which tells the reason, comes SIGKILL.
    if (!limit(RLIMIT_CPU, limits.cpu_s, 1) || !limit(RLIMIT_CORE, 0)) return refused();
    if (!kConfined) return Done{};
    if (!limit(RLIMIT_AS, mapped_bytes() + limits.memory_bytes)) return refused();
    if (close_range(STDERR_FILENO + 1, ~0U, 0) != 0) return refused();
    std::vector<sock_filter> instructions = call_filter();
    const sock_fprog program{.len = static_cast<unsigned short>(instructions.size()),
                             .filter = instructions.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        return refused();
    return Done{};
}

}  // namespace plumbline
