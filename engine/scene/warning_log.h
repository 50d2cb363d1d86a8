// What a simulation warns of, in the log.
#pragma once

#include <cstddef>

namespace plumbline::scene {

class Simulation;

class WarningLog {
public:
    /// Logs the warnings that have come since the last call; those of building come first.
    void log_new(const Simulation& simulation);

private:
    std::size_t logged_{0};
};

}  // namespace plumbline::scene
