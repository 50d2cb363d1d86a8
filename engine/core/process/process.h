// Programs that run beside ours, with a pipe to each and one from it. Nothing else starts, waits for
// or ends processes.
#pragma once

#include "engine/core/result.h"

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

enum class Priority : std::uint8_t {
    Same,  ///< as ours
    Low,   ///< a small share where ours wants all
    Idle,  ///< what others leave alone
};

struct ChildDef {
    std::filesystem::path program;  ///< without a slash it is looked for along PATH
    std::vector<std::string> arguments;
    bool own_group{false};  ///< Ctrl-C on the terminal is for us alone, who end the child
    bool silent{false};     ///< its messages go nowhere; else where ours go,
    bool tells_us{false};   ///< or to us, with its output
    Priority priority{Priority::Same};
};

struct ChildEnd {
    bool good{false};   ///< by itself, with exit code 0
    std::string words;  ///< "ended with exit code 3", "was ended by signal 11 (Segmentation fault)"
    std::string said;   ///< what was still in the pipe from it, 64 KiB at most
};

/// Killed and waited for on destruction, so that no child outlives its owner.
class ChildProcess {
public:
    /// From the first one on SIGPIPE is ignored: that a child reads no more is a failed write.
    static Result<ChildProcess> start(const ChildDef& def);
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ~ChildProcess();

    /// Waits until all is in the pipe. False where the child reads no more.
    bool send(std::string_view bytes) const;
    bool send_line(std::string line) const;
    void close_input();
    /// Takes what has come, or waits for something; false at the end of the pipe.
    bool receive(std::string& text) const;
    /// Whether receive() would not wait.
    bool has_output() const;
    /// Waits so long for its end, then kills it.
    ChildEnd end(double grace_s = 0);

private:
    friend std::vector<bool> wait_for_output(std::span<const ChildProcess* const> children,
                                             double limit_s);
    friend Result<ChildEnd> output_to(const std::function<bool(std::string_view)>& take,
                                      const ChildDef& def,
                                      std::string_view input,
                                      double limit_s);

    ChildProcess(pid_t pid, int input, int output) : pid_(pid), input_(input), output_(output) {}

    pid_t pid_{-1};
    int input_{-1};
    int output_{-1};
};

/// Waits `limit_s` at most until receive() of one of them would not wait: of which it would not.
std::vector<bool> wait_for_output(std::span<const ChildProcess* const> children, double limit_s);

/// Runs a program with `input` on its standard input, whether it reads that or not, hands what it prints
/// to `take` piece by piece and waits for its end. The error is for one that cannot be started, takes
/// more than `limit_s`, or prints what `take` says no to; it is killed then.
Result<ChildEnd> output_to(const std::function<bool(std::string_view)>& take,
                           const ChildDef& def,
                           std::string_view input,
                           double limit_s);

/// Whether a process of this number runs, as far as can be seen from here.
bool process_runs(pid_t number);

/// From now on this process is killed when the one that started it, and reads its output, ends; at
/// once if it has ended.
void end_with_parent();

/// Fills `bytes` from the standard input. False where that ends before.
bool receive_all(std::string& bytes);

/// Of a process that answers the one that started it: takes the standard output over, and what else
/// is printed there goes to the standard error output.
class AnswerPipe {
public:
    AnswerPipe();
    AnswerPipe(const AnswerPipe&) = delete;
    AnswerPipe& operator=(const AnswerPipe&) = delete;
    ~AnswerPipe();
    /// Waits until all is in the pipe. False where nobody reads any more.
    bool send_line(std::string line) const;

private:
    int file_{-1};
};

/// Whether `descriptor` is a pipe whose reader, `head` for one, has closed it.
bool reader_has_gone(int descriptor);

}  // namespace plumbline
