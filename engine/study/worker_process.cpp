#include "engine/study/worker_process_impl.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

extern char** environ;

namespace plumbline::study {
namespace {

/// Both ends of a pipe; what is still held is closed.
struct Pipe {
    std::array<int, 2> ends{-1, -1};
    Pipe() = default;
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        for (const int end : ends) {
            if (end >= 0) close(end);
        }
    }
    bool open() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
    int release(std::size_t end) { return std::exchange(ends[end], -1); }
};

constexpr std::size_t kRead = 0;
constexpr std::size_t kWrite = 1;

/// What posix_spawn wants beside the program; freed however it ends.
struct SpawnSettings {
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
    SpawnSettings() {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
};

}  // namespace

Result<WorkerProcess> WorkerProcess::start(const std::filesystem::path& program,
                                           const std::vector<std::string>& arguments) {
    const auto refused = [&program](int error) {
        return Error{.message =
                         fmt::format("cannot start {}: {}", program.string(), strerror(error))};
    };
    Pipe jobs;
    Pipe answers;
    if (!jobs.open() || !answers.open()) return refused(errno);
    SpawnSettings settings;
    posix_spawn_file_actions_adddup2(&settings.files, jobs.ends[kRead], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&settings.files, answers.ends[kWrite], STDOUT_FILENO);
    posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&settings.attributes, 0);

    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t pid = -1;
    const int error = posix_spawn(
        &pid, program.c_str(), &settings.files, &settings.attributes, pointers.data(), environ);
    if (error != 0) return refused(error);
    return WorkerProcess(pid, jobs.release(kWrite), answers.release(kRead));
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      jobs_(std::exchange(other.jobs_, -1)),
      answers_(std::exchange(other.answers_, -1)) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(jobs_, other.jobs_);
    std::swap(answers_, other.answers_);
    return *this;
}

WorkerProcess::~WorkerProcess() {
    if (running()) end();
}

bool WorkerProcess::send(std::string line) const {
    line += '\n';
    std::size_t sent = 0;
    while (sent < line.size()) {
        const ssize_t count = write(jobs_, line.data() + sent, line.size() - sent);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        sent += static_cast<std::size_t>(count);
    }
    return true;
}

bool WorkerProcess::receive(std::string& text) const {
    std::array<char, 65536> buffer;
    ssize_t count = -1;
    do {
        count = read(answers_, buffer.data(), buffer.size());
    } while (count < 0 && errno == EINTR);
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

std::string WorkerProcess::end() {
    // One that has ended by itself keeps its own end.
    int how = 0;
    siginfo_t left{};
    const bool ended =
        waitid(P_PID, static_cast<id_t>(pid_), &left, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        left.si_pid == pid_;
    if (!ended) kill(pid_, SIGKILL);
    while (waitpid(pid_, &how, 0) < 0 && errno == EINTR) {
    }
    close(jobs_);
    close(answers_);
    pid_ = jobs_ = answers_ = -1;
    if (WIFSIGNALED(how))
        return fmt::format("was ended by signal {} ({})", WTERMSIG(how), strsignal(WTERMSIG(how)));
    return fmt::format("ended with exit code {}", WEXITSTATUS(how));
}

}  // namespace plumbline::study
