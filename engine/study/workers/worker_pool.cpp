#include "engine/study/workers/worker_pool.h"

#include "engine/core/process/interrupt.h"
#include "engine/core/process/process.h"
#include "engine/core/threads/team.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/workers/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace plumbline::study {
namespace {

constexpr double kLongestWait_s = 0.05;  // until somebody who says stop is heard

/// One place for a job at work. It keeps a worker of each precision that it has needed.
class Slot {
public:
    explicit Slot(const WorkerPrograms& programs) : programs_(programs) {}

    bool busy() const { return job_.has_value(); }
    std::size_t job() const { return *job_; }
    const ChildProcess& process() const { return *worker(); }
    double left_s() const { return deadline_s_ - wall_s(); }

    Result<Done> give(std::size_t index, const Job& job) {
        precision_ = job.precision;
        if (!worker()) {
            Result<ChildProcess> started = start_worker(programs_, precision_);
            if (!started) return started.error();
            worker().emplace(std::move(*started));
        }
        // A worker that does not read has ended: its pipe's end says so, and how.
        worker()->send_line(job_line(job));
        job_ = index;
        received_.clear();
        deadline_s_ = wall_s() + job.limit_s;
        return Done{};
    }

    /// Once there is something to read: the answer, if it is whole or there will be none.
    std::optional<Answer> receive() {
        const bool open = worker()->receive(received_);
        const std::size_t line_end = received_.find('\n');
        if (line_end != std::string::npos) {
            job_.reset();
            Result<Answer> answer = parse_answer_line(received_.substr(0, line_end));
            if (answer) return *answer;
            worker().reset();
            return Answer{.status = RunStatus::Refused, .body = answer.error().message};
        }
        if (open) return std::nullopt;
        job_.reset();
        Answer crashed{.status = RunStatus::Crashed,
                       .body = fmt::format("the worker {}", worker()->end().words)};
        worker().reset();
        return crashed;
    }

    Answer give_up(double limit_s) {
        job_.reset();
        worker().reset();
        return {.status = RunStatus::TimedOut,
                .body = fmt::format("timed out after {:g} s", limit_s)};
    }

private:
    std::optional<ChildProcess>& worker() { return workers_[static_cast<std::size_t>(precision_)]; }
    const std::optional<ChildProcess>& worker() const {
        return workers_[static_cast<std::size_t>(precision_)];
    }

    const WorkerPrograms& programs_;
    std::array<std::optional<ChildProcess>, 2> workers_;
    Precision precision_{Precision::Float32};
    std::optional<std::size_t> job_;
    std::string received_;
    double deadline_s_{0};
};

/// Waits until a busy slot has something to say, a limit is near, or a moment has passed: which of
/// the busy ones have.
std::vector<bool> wait_for_answers(const std::vector<Slot>& slots) {
    std::vector<const ChildProcess*> busy;
    double wait_s = kLongestWait_s;
    for (const Slot& slot : slots) {
        if (!slot.busy()) continue;
        busy.push_back(&slot.process());
        wait_s = std::clamp(slot.left_s(), 0.0, wait_s);
    }
    return wait_for_output(busy, wait_s);
}

std::vector<Precision> precisions_of(std::span<const Job> jobs) {
    std::vector<Precision> needed;
    for (const Job& job : jobs) {
        if (std::ranges::find(needed, job.precision) == needed.end())
            needed.push_back(job.precision);
    }
    return needed;
}

}  // namespace

WorkerPrograms sibling_programs() {
    std::error_code error;
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    return {.float32 = folder / "plumbline", .float64 = folder / "plumbline-f64"};
}

Result<ChildProcess> start_worker(const WorkerPrograms& programs, Precision precision) {
    return ChildProcess::start({.program = programs.of(precision),
                                .arguments = programs.arguments,
                                .own_group = true,
                                .priority = programs.priority});
}

Result<Done> check_programs(const WorkerPrograms& programs, std::span<const Precision> needed) {
    for (const Precision precision : needed) {
        const std::filesystem::path& program = programs.of(precision);
        std::error_code error;
        if (std::filesystem::is_regular_file(program, error)) continue;
        return Error{.message = fmt::format("{} runs need the program {}, which is not there; "
                                            "./play builds it, and so does `cmake --build` with "
                                            "the target {}",
                                            word_of(precision),
                                            program.string(),
                                            program.filename().string())};
    }
    return Done{};
}

Result<bool> run_jobs(std::span<const Job> jobs,
                      const Workers& workers,
                      const std::function<void(std::size_t job, const Answer& answer)>& done) {
    if (Result<Done> there = check_programs(workers.programs, precisions_of(jobs)); !there)
        return there.error();
    const auto slot_count = static_cast<std::size_t>(std::max(1, workers.count));
    std::vector<Slot> slots;
    slots.reserve(slot_count);
    for (std::size_t i = 0; i < std::min(slot_count, jobs.size()); ++i)
        slots.emplace_back(workers.programs);

    std::size_t next = 0;
    std::size_t ended = 0;
    while (ended < jobs.size()) {
        for (Slot& slot : slots) {
            if (slot.busy() || next == jobs.size()) continue;
            if (Result<Done> given = slot.give(next, jobs[next]); !given) return given.error();
            ++next;
        }
        const std::vector<bool> ready = wait_for_answers(slots);
        if (interrupted() || workers.stop.stop_requested()) return false;
        std::size_t place = 0;
        for (Slot& slot : slots) {
            if (!slot.busy()) continue;
            const std::size_t job = slot.job();
            std::optional<Answer> answer;
            if (ready[place++]) answer = slot.receive();
            if (!answer && slot.left_s() <= 0) answer = slot.give_up(jobs[job].limit_s);
            if (!answer) continue;
            ++ended;
            done(job, *answer);
        }
    }
    return true;
}

int default_workers() {
    return usable_cores();
}

}  // namespace plumbline::study
