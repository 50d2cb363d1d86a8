// One worker: a child process with a pipe to it and one from it.
#pragma once

#include "engine/core/result.h"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::study {

/// Killed and waited for on destruction, so that no worker outlives its owner.
class WorkerProcess {
public:
    /// In a process group of its own: Ctrl-C on the terminal is for the parent, which ends it.
    static Result<WorkerProcess> start(const std::filesystem::path& program,
                                       const std::vector<std::string>& arguments);
    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&& other) noexcept;
    ~WorkerProcess();

    bool running() const { return pid_ > 0; }
    int answers() const { return answers_; }  ///< to poll() for reading
    /// False where the worker reads no more.
    bool send(std::string line) const;
    /// Takes what has come; false at the end of the pipe.
    bool receive(std::string& text) const;
    /// Ends it, if it has not, and says how it ended: "was ended by signal 11 (Segmentation fault)".
    std::string end();

private:
    WorkerProcess(pid_t pid, int jobs, int answers) : pid_(pid), jobs_(jobs), answers_(answers) {}

    pid_t pid_{-1};
    int jobs_{-1};
    int answers_{-1};
};

}  // namespace plumbline::study
