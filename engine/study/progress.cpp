#include "engine/study/progress.h"

#include "engine/core/time/stopwatch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace plumbline::study {
namespace {

constexpr double kBetweenLines_s = 5;
constexpr int kBar = 40;

}  // namespace

ProgressBar::ProgressBar(Shown shown)
    : shown_(shown),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_line_s_(wall_s() + kBetweenLines_s) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressBar::show(double share, double left_s) {
    if (shown_ == Shown::No) return;
    const std::string text = fmt::format("{:3.0f} %, about {:.0f} s left", share * 100, left_s);
    if (terminal_) {
        const auto full = static_cast<int>(share * kBar);
        std::cerr << fmt::format("\r[{:#<{}}{:.<{}}] {} ", "", full, "", kBar - full, text)
                  << std::flush;
        drawn_ = true;
    } else if (wall_s() >= next_line_s_) {
        std::cerr << text << '\n';
        next_line_s_ = wall_s() + kBetweenLines_s;
    }
}

}  // namespace plumbline::study
