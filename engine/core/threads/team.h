// Threads that share the work of a step: the caller and its helpers take ranges of one list after the other.
//
// A step has a hundred short lists. A scheduler's task costs some microseconds, as long as many of them take; helpers
// that watch a counter between two lists join in within a fraction of one. docs/decisions/0024 has the figures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace plumbline {

/// Cores that this process may use: of its affinity, and no more than its group's quota of CPU time allows; >= 1.
int usable_cores();

/// One thread at a time calls it. What a list's ranges write must not overlap, so that their order does not matter.
class Team {
public:
    /// Of the calling thread and `threads` - 1 helpers, `threads` >= 1. Helpers start at the first wake(); one that the
    /// system refuses is left out.
    explicit Team(int threads);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// How many may work at once. Their numbers, from 0, say whose scratch memory a range may use.
    int threads() const { return threads_; }

    /// Helpers sleep before the first wake() and after rest(), and cost nothing; in between they watch for work.
    void wake();
    void rest();
    /// CPU time that helpers have used so far, ms.
    double helpers_cpu_ms() const;

    /// Calls `work(member, begin, end)` for ranges of at most `grain` (>= 1) that cover [0, count), on all threads at once,
    /// and returns when all calls have. Asleep or for a single range, the caller alone works. Throws what one of the
    /// calls threw; then some ranges may have been left out.
    template <typename Work>
    void share(std::size_t count, std::size_t grain, const Work& work) {
        if (!awake_ || count <= grain) {
            if (count > 0) work(0, std::size_t{0}, count);
            return;
        }
        const auto call = [](const void* of, int member, std::size_t begin, std::size_t end) {
            (*static_cast<const Work*>(of))(member, begin, end);
        };
        run({call, &work, count, grain});
    }

private:
    struct List {
        void (*call)(const void*, int, std::size_t, std::size_t){nullptr};
        const void* work{nullptr};
        std::size_t count{0};
        std::size_t grain{1};
    };
    struct Impl;
    void run(const List& list);

    int threads_;
    bool awake_{false};
    std::unique_ptr<Impl> impl_;
};

/// Team::share(), or without a team the caller alone.
template <typename Work>
void share(Team* team, std::size_t count, std::size_t grain, const Work& work) {
    if (team != nullptr)
        team->share(count, grain, work);
    else if (count > 0)
        work(0, std::size_t{0}, count);
}

/// Has a team's helpers awake while it lives; null: nobody's.
class AwakeTeam {
public:
    explicit AwakeTeam(Team* team) : team_(team) {
        if (team_ != nullptr) team_->wake();
    }
    ~AwakeTeam() {
        if (team_ != nullptr) team_->rest();
    }
    AwakeTeam(const AwakeTeam&) = delete;
    AwakeTeam& operator=(const AwakeTeam&) = delete;

private:
    Team* team_;
};

}  // namespace plumbline
