#include "engine/study/report/gnuplot.h"

#include "engine/study/report/html_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

namespace plumbline::study {

namespace {

using Clock = std::chrono::steady_clock;

/// One end of a pipe; closed when it goes.
class End {
public:
    explicit End(int file = -1) : file_(file) {}
    End(End&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    End& operator=(End&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~End() { close(); }
    int file() const { return file_; }
    void close() {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }

private:
    int file_;
};

struct Pipe {
    End read;
    End write;
};

/// Both ends close on exec; only what is dup'ed into the child stays.
Result<Pipe> make_pipe() {
    std::array<int, 2> files{-1, -1};
    if (::pipe2(files.data(), O_CLOEXEC) != 0) {
        return Error{fmt::format("no pipe: {}", std::strerror(errno))};
    }
    return Pipe{End(files[0]), End(files[1])};
}

/// A child that reads `in`, writes `out` and says its errors to nobody.
Result<pid_t> spawn(const std::string& program, const Pipe& in, const Pipe& out) {
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.read.file(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.write.file(), STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::string name = program;
    std::string plain = "-d";
    std::string from_input = "-";
    std::array<char*, 4> arguments{name.data(), plain.data(), from_input.data(), nullptr};
    pid_t child = 0;
    const int failed =
        ::posix_spawnp(&child, name.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) return Error{fmt::format("cannot run {}: {}", program, std::strerror(failed))};
    return child;
}

int milliseconds_left(Clock::time_point until) {
    using std::chrono::milliseconds;
    const auto left = std::chrono::duration_cast<milliseconds>(until - Clock::now()).count();
    return left < 0 ? 0 : static_cast<int>(left);
}

/// Feeds and reads the child until it closes its output. False: the time was up.
bool converse(
    std::string_view script, Pipe& in, Pipe& out, Clock::time_point until, std::string& got) {
    std::array<char, 65536> bytes{};
    while (out.read.file() >= 0) {
        std::array<pollfd, 2> files{pollfd{out.read.file(), POLLIN, 0},
                                    pollfd{in.write.file(), POLLOUT, 0}};
        const nfds_t count = in.write.file() >= 0 ? 2 : 1;
        const int ready = ::poll(files.data(), count, milliseconds_left(until));
        if (ready == 0) return false;
        if (ready < 0 && errno != EINTR) return false;
        if (ready < 0) continue;
        if (files[0].revents != 0) {
            const ssize_t size = ::read(out.read.file(), bytes.data(), bytes.size());
            if (size <= 0 && errno != EINTR) out.read.close();
            if (size == 0) out.read.close();
            if (size > 0) got.append(bytes.data(), static_cast<std::size_t>(size));
        }
        if (count == 2 && files[1].revents != 0) {
            const ssize_t size = ::write(in.write.file(), script.data(), script.size());
            if (size > 0) script.remove_prefix(static_cast<std::size_t>(size));
            if (script.empty() || (size < 0 && errno != EAGAIN && errno != EINTR)) in.write.close();
        }
    }
    return true;
}

/// Waits for a child that closed its output, or ends it when the time is up. -1: it was ended.
int exit_code_of(pid_t child, Clock::time_point until) {
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (Clock::now() > until) {
            ::kill(child, SIGKILL);
            ::waitpid(child, &status, 0);
            return -1;
        }
        ::usleep(1000);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// A write to a child that has gone is an error here, not the end of this program.
class NoPipeSignal {
public:
    NoPipeSignal() : before_(::signal(SIGPIPE, SIG_IGN)) {}
    NoPipeSignal(const NoPipeSignal&) = delete;
    NoPipeSignal& operator=(const NoPipeSignal&) = delete;
    ~NoPipeSignal() {
        if (before_ != SIG_ERR) ::signal(SIGPIPE, before_);
    }

private:
    void (*before_)(int);
};

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// Without every <tag ...>...</tag> of that name.
std::string without(std::string text, const std::string& tag) {
    const std::string opening = fmt::format("<{}>", tag);
    const std::string closing = fmt::format("</{}>", tag);
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening)) {
        const std::size_t end = text.find(closing, at);
        if (end == std::string::npos) break;
        text.erase(at, end + closing.size() - at);
    }
    return text;
}

}  // namespace

std::string gnuplot_program() {
    const char* named = std::getenv("PLUMBLINE_GNUPLOT");
    return named != nullptr && *named != '\0' ? named : "gnuplot";
}

Result<std::string> run_gnuplot(const std::string& program,
                                const std::string& script,
                                double limit_s) {
    auto in = make_pipe();
    auto out = make_pipe();
    if (!in) return in.error();
    if (!out) return out.error();
    const NoPipeSignal no_pipe_signal;
    const auto child = spawn(program, *in, *out);
    if (!child) return child.error();
    in->read.close();
    out->write.close();
    ::fcntl(in->write.file(), F_SETFL, O_NONBLOCK);
    const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(limit_s));
    std::string got;
    const bool ended = converse(script, *in, *out, until, got);
    if (!ended) ::kill(*child, SIGKILL);
    const int code = exit_code_of(*child, until);
    if (!ended) return Error{fmt::format("{} did not end within {} s", program, limit_s)};
    if (code == 127) return Error{fmt::format("cannot run {}: no such program", program)};
    if (code != 0) return Error{fmt::format("{} failed (exit code {})", program, code)};
    if (got.empty()) return Error{fmt::format("{} drew nothing", program)};
    return got;
}

Result<std::string> inline_svg(const std::string& svg,
                               const std::string& prefix,
                               const std::string& name) {
    const std::size_t begin = svg.find("<svg");
    const std::size_t box = svg.find("viewBox=", begin);
    const std::size_t end = svg.rfind("</svg>");
    if (begin == std::string::npos || box == std::string::npos || end == std::string::npos ||
        box > end) {
        return Error{"gnuplot wrote something else than a picture"};
    }
    std::string body = without(without(svg.substr(box, end - box), "title"), "desc");
    body = replaced(std::move(body), "id='", fmt::format("id='{}-", prefix));
    body = replaced(std::move(body), "id=\"", fmt::format("id=\"{}-", prefix));
    body = replaced(std::move(body), "href='#", fmt::format("href='#{}-", prefix));
    return fmt::format("<svg role=\"img\" aria-label=\"{}\" {}</svg>", escape_html(name), body);
}

}  // namespace plumbline::study
