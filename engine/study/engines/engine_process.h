// Another engine as a program beside ours, which answers each line with a line, both JSON.
//
// It begins with {"version": ...}. Asked {"scene": ...} (neutral_scene.h) it makes a new world and says {}. Asked
// {"set": [[body, 13 numbers], ...], "gravity_mps2": [...], "steps": n}, of which all but `steps` may be
// left out, it answers {"cpu_ms": of the steps, "step_ms": [...], "states": [13 numbers for each moving body]}. What goes wrong
// is {"lacks": "a cone"} or {"failed": ...}.
#pragma once

#include "engine/core/process/process.h"
#include "engine/core/result.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::study {

/// 13 numbers: position, orientation x y z w, velocity, spin; of the mass frame, along world axes.
inline constexpr std::size_t kNumbersOfBody = 13;

/// What an engine is asked for.
struct EngineSteps {
    int steps{1};
    std::vector<std::pair<std::size_t, std::span<const double>>> set{};  ///< bodies' numbers
    std::vector<double> gravity_mps2{};                                  ///< three, or none
};
struct EngineMoved {
    double cpu_ms{0};
    std::vector<float> step_ms{};  ///< on the wall
    std::vector<double> states{};
    bool is_finite{true};  ///< all of the states
};

class EngineProcess {
public:
    /// Refused: what cannot be started, and what does not say its version.
    static Result<EngineProcess> start(const ChildDef& program);

    const std::string& version() const { return version_; }
    /// A new world in place of the one before. Refused: what the engine lacks or fails at.
    Result<Done> make(const std::string& scene);
    /// Refused (as "took longer than ..."): what needs more than `limit_s`.
    Result<EngineMoved> advance(const EngineSteps& steps, double limit_s);

private:
    explicit EngineProcess(ChildProcess child) : child_(std::move(child)) {}
    Result<std::string> ask(std::string line, double limit_s);
    Result<std::string> read_line(double limit_s);

    ChildProcess child_;
    std::string rest_;  ///< read, but not yet taken
    std::string version_;
};

}  // namespace plumbline::study
