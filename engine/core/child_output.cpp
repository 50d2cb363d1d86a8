#include "engine/core/child_output.h"

#include "engine/core/stopwatch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

extern char** environ;

namespace plumbline {
namespace {

/// A running child; killed and waited for at the latest when this goes.
class Child {
public:
    Child(pid_t pid, int output) : pid_(pid), output_(output) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(output_);
        if (pid_ > 0) {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
    }

    int output() const { return output_; }

    std::string wait() {
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
        return WEXITSTATUS(status) == 0 ? ""
                                        : fmt::format("ended with code {}", WEXITSTATUS(status));
    }

private:
    pid_t pid_;
    int output_;
};

Error cannot_start(const std::filesystem::path& program, int error) {
    return {.message = fmt::format("cannot start {}: {}", program.string(), strerror(error))};
}

/// The child's number, or the system's error as a negative one.
pid_t started(const std::filesystem::path& program,
              const std::vector<std::string>& arguments,
              const std::array<int, 2>& pipe) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, pipe[1], STDOUT_FILENO);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t pid = -1;
    const int error = posix_spawn(&pid, program.c_str(), &files, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    return error == 0 ? pid : -error;
}

/// Everything up to the end of the child's output.
Result<std::string> read_all(const Child& child,
                             const std::string& name,
                             std::size_t max_bytes,
                             double limit_s) {
    const double deadline_s = wall_s() + limit_s;
    std::string bytes;
    std::vector<char> buffer(1U << 20U);
    while (true) {
        const double left_s = deadline_s - wall_s();
        if (left_s <= 0.0) {
            return Error{.message = fmt::format("{} was given up after {:g} s", name, limit_s)};
        }
        pollfd waiting{.fd = child.output(), .events = POLLIN, .revents = 0};
        const int ready = poll(&waiting, 1, static_cast<int>(std::min(left_s, 1.0) * 1e3) + 1);
        if (ready <= 0) continue;
        const ssize_t count = read(child.output(), buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
        if (bytes.size() > max_bytes) {
            return Error{.message = fmt::format("{} answered more than {} bytes", name, max_bytes)};
        }
    }
}

}  // namespace

Result<ChildOutput> output_of(const std::filesystem::path& program,
                              const std::vector<std::string>& arguments,
                              std::size_t max_bytes,
                              double limit_s) {
    std::array<int, 2> pipe{-1, -1};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0) return cannot_start(program, errno);
    const pid_t pid = started(program, arguments, pipe);
    close(pipe[1]);
    if (pid < 0) {
        close(pipe[0]);
        return cannot_start(program, -pid);
    }
    Child child(pid, pipe[0]);
    Result<std::string> bytes = read_all(child, program.filename().string(), max_bytes, limit_s);
    if (!bytes) return bytes.error();
    return ChildOutput{.bytes = std::move(*bytes), .end = child.wait()};
}

}  // namespace plumbline
