// How far a long command has come, on standard error.
#pragma once

#include <string>

namespace plumbline::study {

/// On a terminal one line that is written over, elsewhere a line every 5 s. Cleared at the end.
class ProgressBar {
public:
    enum class Shown { Yes, No };
    explicit ProgressBar(Shown shown);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double share, double left_s);

private:
    Shown shown_;
    bool terminal_;
    bool drawn_{false};
    double next_line_s_;
};

}  // namespace plumbline::study
