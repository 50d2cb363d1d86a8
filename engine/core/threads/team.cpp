#include "engine/core/threads/team.h"

#include <pthread.h>  // and what is in sched.h (POSIX)
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace plumbline {
namespace {

/// Looks at a counter that another core writes before the thread gives its core away: some tens of microseconds.
constexpr int kLooksBeforeYield = 1000;

void pause_shortly(int looks) {
    if (looks > kLooksBeforeYield) {
        std::this_thread::yield();
        return;
    }
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/// What is left of one member's share of a list: the next of its ranges and the end of them, in one word, so that who takes
/// a range knows whether there is one.
struct Ticket {
    static constexpr int kBits = 32;
    static constexpr std::size_t kMostRanges = std::size_t{1} << 20;

    std::uint64_t bits;

    static Ticket of(std::size_t begin, std::size_t end) {
        return {std::uint64_t{end} << kBits | std::uint64_t{begin}};
    }
    std::size_t range() const { return bits & 0xFFFFFFFF; }
    bool is_left() const { return range() < bits >> kBits; }
};

/// CPU time of the quota of the process's group (cgroup 2), in cores; infinite without one.
double quota_cores() {
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    std::string quota;
    double period_us = 0;
    if (!(file >> quota >> period_us) || quota == "max" || !(period_us > 0)) return HUGE_VAL;
    return std::strtod(quota.c_str(), nullptr) / period_us;
}

double cpu_ms_of(pthread_t thread) {
    clockid_t clock{};
    timespec time{};
    if (pthread_getcpuclockid(thread, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace

int usable_cores() {
    cpu_set_t set;
    const int by_affinity = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
    return std::max(1, static_cast<int>(std::min<double>(by_affinity, quota_cores())));
}

struct Team::Impl {
    /// On a cache line of its own: another core's writes there cost hundreds of nanoseconds.
    struct alignas(64) Share {
        std::atomic<std::uint64_t> next{0};  // a Ticket
        std::atomic<std::uint64_t> done{
            0};  // ranges that the member has finished of all lists so far
    };

    List list;
    std::vector<Share> shares;  // of each member
    std::mutex mutex;           // of `failure`
    std::exception_ptr failure;
    alignas(64) std::atomic<std::uint64_t> lists{0};
    /// What helpers do: watch for work, sleep, or end.
    enum : int { kEnd = -1, kSleep = 0, kWatch = 1 };
    alignas(64) std::atomic<int> watch{kSleep};
    std::atomic<int> caller_core{0};
    std::vector<std::thread> helpers;

    explicit Impl(int threads) : shares(static_cast<std::size_t>(threads)) {}
    void start(int count);
    void stop();
    void help(int member);
    void leave_core_of_caller() const;
    void work(int member);
    bool take_one(std::size_t of, int member);
    std::uint64_t done() const;
};

Team::Team(int threads) : threads_(std::max(threads, 1)), impl_(std::make_unique<Impl>(threads_)) {}

Team::~Team() {
    impl_->stop();
}

void Team::Impl::start(int count) {
    try {
        for (int i = 0; i < count; ++i) helpers.emplace_back([this, i] { help(i + 1); });
    } catch (const std::system_error&) {
        // Those that there are do.
    }
}

void Team::Impl::stop() {
    watch = kEnd;
    watch.notify_all();
    for (std::thread& helper : helpers) helper.join();
}

void Team::Impl::help(int member) {
    std::uint64_t seen = 0;
    for (;;) {
        watch.wait(kSleep);
        leave_core_of_caller();
        int looks = 0;
        while (watch.load(std::memory_order_relaxed) == kWatch) {
            const std::uint64_t now = lists.load(std::memory_order_acquire);
            if (now == seen) {
                pause_shortly(++looks);
                continue;
            }
            seen = now;
            looks = 0;
            work(member);
        }
        if (watch == kEnd) return;
    }
}

/// A system wakes a thread where its waker runs: there the two would take turns.
void Team::Impl::leave_core_of_caller() const {
    const int core = caller_core.load(std::memory_order_relaxed);
    cpu_set_t others;
    if (sched_getcpu() != core || sched_getaffinity(getpid(), sizeof others, &others) != 0) return;
    CPU_CLR(static_cast<std::size_t>(core), &others);
    if (CPU_COUNT(&others) > 0) sched_setaffinity(0, sizeof others, &others);
}

/// The member's own share, which is the same of list after list: its data stay in this core's cache. Then what others have not
/// come to.
void Team::Impl::work(int member) {
    const auto own = static_cast<std::size_t>(member);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        while (take_one((own + i) % shares.size(), member)) {
        }
    }
}

/// Whether a range was left.
bool Team::Impl::take_one(std::size_t of, int member) {
    std::atomic<std::uint64_t>& next = shares[of].next;
    if (!Ticket{next.load(std::memory_order_relaxed)}.is_left()) return false;
    const Ticket ticket{next.fetch_add(1, std::memory_order_acq_rel)};
    if (!ticket.is_left()) return false;
    const std::size_t begin = ticket.range() * list.grain;
    try {
        list.call(list.work, member, begin, std::min(begin + list.grain, list.count));
    } catch (...) {
        const std::scoped_lock lock(mutex);
        failure = std::current_exception();
    }
    shares[static_cast<std::size_t>(member)].done.fetch_add(1, std::memory_order_release);
    return true;
}

std::uint64_t Team::Impl::done() const {
    std::uint64_t sum = 0;
    for (const Share& share : shares) sum += share.done.load(std::memory_order_acquire);
    return sum;
}

void Team::wake() {
    if (threads_ == 1) return;
    if (impl_->helpers.empty()) impl_->start(threads_ - 1);
    awake_ = !impl_->helpers.empty();
    impl_->caller_core.store(sched_getcpu(), std::memory_order_relaxed);
    impl_->watch = Impl::kWatch;
    impl_->watch.notify_all();
}

void Team::rest() {
    awake_ = false;
    if (threads_ > 1) impl_->watch = Impl::kSleep;
}

double Team::helpers_cpu_ms() const {
    double sum_ms = 0;
    for (std::thread& helper : impl_->helpers) sum_ms += cpu_ms_of(helper.native_handle());
    return sum_ms;
}

void Team::run(const List& list) {
    Impl& team = *impl_;
    team.list = list;
    team.list.grain = std::max(list.grain, list.count / Ticket::kMostRanges + 1);
    const std::size_t ranges = (list.count + team.list.grain - 1) / team.list.grain;
    const std::size_t members = team.shares.size();
    const std::uint64_t end = team.done() + ranges;
    for (std::size_t i = 0; i < members; ++i) {
        team.shares[i].next.store(Ticket::of(i * ranges / members, (i + 1) * ranges / members).bits,
                                  std::memory_order_release);
    }
    team.lists.fetch_add(1, std::memory_order_release);
    team.work(0);
    for (int looks = 0; team.done() < end; ++looks) pause_shortly(looks);
    if (team.failure) std::rethrow_exception(std::exchange(team.failure, nullptr));
}

}  // namespace plumbline
