// What a study found, as plain data: measured by the runners, read by the report, the tables and
// `preset = "auto"`.
#pragma once

#include "engine/study/engine_setting.h"
#include "engine/study/findings/effect_findings.h"
#include "engine/study/findings/image_findings.h"
#include "engine/study/setting.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::study {

/// How far a reference can be trusted (docs/ACCURACY.md). T4 shows consistency, not correctness.
enum class Tier {
    ClosedForm,      ///< T1
    TwoIntegrators,  ///< T2: independent high-order integrators that agree to 1e-10
    Conserved,       ///< T3: a conserved quantity, or a symmetry
    SelfConverged,   ///< T4: the same engine in float64 at a far smaller step, shown to converge
    Spread,          ///< T5: no truth: how far perturbed copies lie apart
};
template <>
inline constexpr std::array<std::string_view, 5> kWords<Tier>{
    "T1 closed form", "T2 two integrators", "T3 conserved", "T4 self-converged", "T5 spread"};

/// One number that is compared with the reference. Errors are relative to `scale`: 0.01 is 1 %.
struct Metric {
    std::string name;   ///< "height at 2 s"
    std::string scale;  ///< what 1 means: "the distance fallen, 19.62 m"
};

/// What "a frame" of a cost is: 1/60 s.
inline constexpr double kFrames_per_s = 60;

enum class RunStatus { Done, NotFinite, Exploded, TimedOut, Crashed, Refused };
template <>
inline constexpr std::array<std::string_view, 6> kWords<RunStatus>{
    "done", "not finite", "exploded", "timed out", "crashed", "refused"};

/// CPU time of stepping only, of all its threads. All zero where nothing ran.
struct RunCost {
    double ms_per_s_min{0};  ///< CPU ms per simulated second, least of the repeats
    double ms_per_s_median{0};
    double ms_per_s_max{0};
    double clock_ms_per_s{0};  ///< ms on the clock per simulated second, least of the repeats
    int repeats{0};
    double step_ms_median{0};
    double step_ms_p99{0};
    double step_ms_max{0};
    double frame_ms_p99{0};  ///< of the steps that fall into one frame, together
    double frame_ms_max{0};
    std::size_t bodies{0};        ///< that move
    std::uint64_t peak_bytes{0};  ///< most resident memory of the process that ran it
    /// Clock-free, exactly repeatable: row solves + contact points looked after, per simulated second.
    double work_per_s{0};
};

/// One setting, measured.
struct Point {
    Setting setting;
    RunStatus status{RunStatus::Done};
    std::string why;             ///< of a status other than Done
    std::vector<double> errors;  ///< one per metric; empty unless Done
    RunCost cost;
};

/// One setting of another engine on the same scene, measured on this machine.
struct EnginePoint {
    EngineSetting setting;
    std::string title;    ///< "Jolt"
    std::string text;     ///< "60 Hz, 10 iterations"
    std::string version;  ///< as the engine or its package says; empty where it did not start
    bool webassembly{false};
    RunStatus status{RunStatus::Done};  ///< Refused: it lacks what the scene needs
    std::string why;                    ///< of a status other than Done
    std::vector<double> errors;         ///< as a Point's
    RunCost cost;
};

/// The scene at its own rate with a number of threads.
struct ThreadsPoint {
    int threads{1};
    RunStatus status{RunStatus::Done};
    std::string why;   ///< of a status other than Done
    bool same{false};  ///< every sampled pose is that of the first of the list, bit by bit
    RunCost cost;
};

/// The Euler floor: the error of a body moved by semi-implicit Euler at a step, without any constraint.
struct FloorPoint {
    double step_s{0};
    double error{0};
};

enum class Trend { Converges, Stalls, Diverges, Exact, TooFew };
template <>
inline constexpr std::array<std::string_view, 5> kWords<Trend>{
    "converges", "stalls", "diverges", "exact", "too few"};

/// How the first metric's error changes with one parameter while the others stay fixed.
struct Convergence {
    std::string knob;  ///< "step rate", "sub-steps", "iterations"
    physics::Solver solver{physics::Solver::SmallStep};
    std::string held;  ///< the rest of the setting, as text
    Trend trend{Trend::TooFew};
    std::optional<double> order;   ///< median of log2(e(2h)/e(h)) over the halvings
    std::optional<double> theory;  ///< where theory gives one
    int halvings{0};
};

/// Everything found out about one scenario or one scene.
struct Subject {
    std::string id;  ///< "A20 e=0.5", or the scene's path
    std::string title;
    std::string set_up;     ///< one or two plain sentences
    std::string reference;  ///< formula or method, with its source
    Tier tier{Tier::ClosedForm};
    /// Name in assets/data/peers.csv, or empty. Its figures are drawn where the first metric has one of
    /// the names in report/peers.cpp.
    std::string peer_scene;
    std::vector<Metric> metrics;
    double uncertainty{0};                ///< of every error, from the reference's own
    std::vector<FloorPoint> euler_floor;  ///< of the first metric; empty where it has no meaning
    std::vector<Point> points;
    std::vector<EnginePoint> engines{};   ///< where they were asked for
    std::vector<ThreadsPoint> threads{};  ///< likewise
    std::vector<Convergence> verdicts;
    std::vector<std::string>
        notes;  ///< "chaotic: 16 perturbed copies", "reference converged to 1e-6"
};

/// The part of a whole that one machine does: of all runs in order those in turn.
struct Shard {
    int index{1};      ///< from 1
    int of{1};         ///< how many there are
    std::string what;  ///< which whole: what was asked for, without the shard

    /// Whether it does the whole's `run`-th run, from 0.
    bool has(std::size_t run) const {
        return static_cast<int>(run % static_cast<std::size_t>(of)) == index - 1;
    }
};
std::string shard_text(const Shard& shard);  ///< "2/4"

/// One study: what the JSON file and the page hold.
struct Findings {
    std::string command;           ///< to repeat it
    std::string machine;           ///< processor, cores
    std::string build;             ///< version, compiler, type
    std::string made_on;           ///< "2026-11-21"
    bool complete{true};           ///< false: interrupted, what was done by then
    std::optional<Shard> shard{};  ///< none: it is whole
    double clock_spread{0};        ///< (median-min)/min over all points' repeats, median of them
    std::vector<Subject> subjects;
    std::vector<ImageFindings> images;
    std::vector<EffectFindings> effects;
    std::vector<EffectError> references;  ///< of effects
};

}  // namespace plumbline::study
