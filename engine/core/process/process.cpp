#include "engine/core/process/process.h"

#include "engine/core/time/stopwatch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <utility>

namespace plumbline {
namespace {

constexpr std::size_t kReadEnd = 0;
constexpr std::size_t kWriteEnd = 1;
constexpr int kLowPriority = 10;
constexpr double kLongestWait_s = 1000;

/// Both ends of a pipe; what is still held is closed. No child gets them but by dup.
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

bool has_ended(pid_t pid) {
    siginfo_t left{};
    return waitid(P_PID, static_cast<id_t>(pid), &left, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           left.si_pid == pid;
}

/// Waits until all is written, whatever signals come. False where nobody reads any more.
bool send_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// poll() takes whole milliseconds: rounded up, so that nobody spins.
int wait_ms(double seconds) {
    return static_cast<int>(std::clamp(seconds, 0.0, kLongestWait_s) * 1e3) + 1;
}

/// Writes what fits in the pipe without waiting. False where the child reads no more.
bool feed(int file, std::string_view& input) {
    // A pipe that takes anything takes this much.
    const ssize_t count = write(file, input.data(), std::min<std::size_t>(input.size(), PIPE_BUF));
    if (count < 0) return errno == EINTR;
    input.remove_prefix(static_cast<std::size_t>(count));
    return true;
}

void set_priority(pid_t pid, Priority priority) {
    if (priority == Priority::Same) return;
    setpriority(PRIO_PROCESS, static_cast<id_t>(pid), kLowPriority);
    if (priority == Priority::Low) return;
    // Where the system refuses, low it is.
    const sched_param none{};
    static_cast<void>(sched_setscheduler(pid, SCHED_IDLE, &none));
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const ChildDef& def) {
    std::signal(SIGPIPE, SIG_IGN);
    const auto refused = [&](int error) {
        return Error{.message =
                         fmt::format("cannot start {}: {}", def.program.string(), strerror(error))};
    };
    Pipe input;
    Pipe output;
    if (!input.open() || !output.open()) return refused(errno);
    SpawnSettings settings;
    posix_spawn_file_actions_adddup2(&settings.files, input.ends[kReadEnd], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&settings.files, output.ends[kWriteEnd], STDOUT_FILENO);
    if (def.silent)
        posix_spawn_file_actions_addopen(&settings.files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (def.tells_us)
        posix_spawn_file_actions_adddup2(&settings.files, output.ends[kWriteEnd], STDERR_FILENO);
    if (def.own_group) posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETPGROUP);

    std::vector<std::string> words{def.program.string()};
    words.insert(words.end(), def.arguments.begin(), def.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t pid = -1;
    const int error = posix_spawnp(&pid,
                                   words.front().c_str(),
                                   &settings.files,
                                   &settings.attributes,
                                   pointers.data(),
                                   environ);
    if (error != 0) return refused(error);
    set_priority(pid, def.priority);
    return ChildProcess(pid, input.release(kWriteEnd), output.release(kReadEnd));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      input_(std::exchange(other.input_, -1)),
      output_(std::exchange(other.output_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(input_, other.input_);
    std::swap(output_, other.output_);
    return *this;
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0) end();
}

bool ChildProcess::send(std::string_view bytes) const {
    return send_all(input_, bytes);
}

bool ChildProcess::send_line(std::string line) const {
    return send(line += '\n');
}

void ChildProcess::close_input() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

bool ChildProcess::receive(std::string& text) const {
    std::array<char, 65536> buffer{};
    ssize_t count = -1;
    do {
        count = read(output_, buffer.data(), buffer.size());
    } while (count < 0 && errno == EINTR);
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
}

bool ChildProcess::has_output() const {
    pollfd file{output_, POLLIN, 0};
    return poll(&file, 1, 0) > 0;
}

std::vector<bool> wait_for_output(std::span<const ChildProcess* const> children, double limit_s) {
    std::vector<pollfd> files;
    for (const ChildProcess* child : children) files.push_back({child->output_, POLLIN, 0});
    std::vector<bool> ready(children.size());
    if (poll(files.data(), files.size(), wait_ms(limit_s)) <= 0) return ready;
    for (std::size_t i = 0; i < files.size(); ++i) ready[i] = files[i].revents != 0;
    return ready;
}

ChildEnd ChildProcess::end(double grace_s) {
    constexpr useconds_t kBetweenLooks_us = 1000;
    const double deadline_s = wall_s() + grace_s;
    // One that has ended by itself keeps its own end.
    bool ended = has_ended(pid_);
    for (; !ended && wall_s() < deadline_s; ended = has_ended(pid_)) usleep(kBetweenLooks_us);
    if (!ended) kill(pid_, SIGKILL);
    int how = 0;
    while (waitpid(pid_, &how, 0) < 0 && errno == EINTR) {
    }
    close_input();
    std::string said;
    // Whoever it has left behind may hold the other end: that is not waited for.
    if (has_output()) receive(said);
    close(std::exchange(output_, -1));
    pid_ = -1;
    if (WIFSIGNALED(how)) {
        const int number = WTERMSIG(how);
        return {.words = fmt::format("was ended by signal {} ({})", number, strsignal(number)),
                .said = std::move(said)};
    }
    const int code = WEXITSTATUS(how);
    return {.good = code == 0,
            .words = fmt::format("ended with exit code {}", code),
            .said = std::move(said)};
}

Result<ChildEnd> output_to(const std::function<bool(std::string_view)>& take,
                           const ChildDef& def,
                           std::string_view input,
                           double limit_s) {
    Result<ChildProcess> child = ChildProcess::start(def);
    if (!child) return child.error();
    const auto refused = [&](std::string_view why) {
        return Error{.message = fmt::format("{} {}", def.program.string(), why)};
    };
    const double deadline_s = wall_s() + limit_s;
    std::string piece;
    while (true) {
        if (input.empty()) child->close_input();
        const double left_s = deadline_s - wall_s();
        if (left_s <= 0.0) return refused(fmt::format("did not end within {:g} s", limit_s));
        // poll() passes over what is closed.
        std::array<pollfd, 2> files{pollfd{child->output_, POLLIN, 0},
                                    pollfd{child->input_, POLLOUT, 0}};
        if (poll(files.data(), files.size(), wait_ms(std::min(left_s, 1.0))) <= 0) continue;
        if (files[1].revents != 0 && !feed(child->input_, input)) child->close_input();
        if (files[0].revents == 0) continue;
        piece.clear();
        if (!child->receive(piece)) break;
        if (!take(piece)) return refused("answered too much");
    }
    return child->end(deadline_s - wall_s());
}

bool process_runs(pid_t number) {
    return number > 0 && (::kill(number, 0) == 0 || errno == EPERM);
}

void end_with_parent() {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // One that ended before that sends no signal, but its end of our output's pipe is closed.
    pollfd output{STDOUT_FILENO, 0, 0};
    if (poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0) raise(SIGKILL);
}

bool receive_all(std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t count = read(STDIN_FILENO, bytes.data() + at, bytes.size() - at);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        at += static_cast<std::size_t>(count);
    }
    return true;
}

AnswerPipe::AnswerPipe() : file_(dup(STDOUT_FILENO)) {
    dup2(STDERR_FILENO, STDOUT_FILENO);
}

AnswerPipe::~AnswerPipe() {
    if (file_ >= 0) close(file_);
}

bool AnswerPipe::send_line(std::string line) const {
    return send_all(file_, line += '\n');
}

bool reader_has_gone(int descriptor) {
    pollfd pipe{.fd = descriptor, .events = POLLOUT, .revents = 0};
    return poll(&pipe, 1, 0) == 1 && (pipe.revents & POLLERR) != 0;
}

}  // namespace plumbline
