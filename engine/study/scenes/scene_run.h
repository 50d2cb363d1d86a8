// One run of a scene at one setting, in a worker process: the poses of its bodies at fixed times, their
// layout as a whole, and what the steps cost.
//
// Poses are sampled every 1/30 s, which is a whole number of steps at every rate of the grid. Bodies are
// the scene's dynamic ones.
#pragma once

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/study/engine_setting.h"
#include "engine/study/findings/findings.h"
#include "engine/study/scene_start.h"
#include "engine/study/stepping_cost.h"
#include "engine/study/workers/worker.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::study {

class EngineProcess;

inline constexpr double kSampleEvery_s = 1.0 / 30.0;

/// What a worker is asked.
struct SceneRun {
    std::filesystem::path scene{};
    /// A file that write_start() made; empty: runs begin where the scene does. Moments are counted from there.
    std::filesystem::path start{};
    Setting setting{};
    /// By another engine; of `setting` the rate counts then, and is the same.
    std::optional<EngineSetting> engine{};
    int threads{1};  ///< that share a step; the result is the same
    /// In units of kSampleEvery_s, rising, the last one is the run's end.
    std::vector<int> moments{};
    int copies{1};           ///< runs that are sampled; with `shift_m` each starts elsewhere
    std::uint64_t seed{1};   ///< of the first copy's shifts; the next copies count on
    double shift_m{0};       ///< every body starts up to so far away, along each axis
    int repeats{0};          ///< further runs of the first copy, for the clock alone
    double repeat_s{1};      ///< no further repeat begins after so much CPU time of stepping
    double cpu_limit_s{60};  ///< of one run's stepping: then it stops where it is, TimedOut
};

struct BodyPose {
    Vec3d position_m{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
    bool there{true};  ///< false: removed, or taken out; the pose is the last one
};

/// Where the bodies are, taken together. Heights are measured against gravity.
struct Layout {
    Vec3d center_m{0, 0, 0};  ///< of mass
    double top_m{0};          ///< 95th percentile of the bodies' heights
    double spread_m{0};       ///< root mean square of the horizontal distance from the centre
    double reach_m{0};        ///< 95th percentile of that distance
};

struct Moment {
    double time_s{0};
    std::vector<BodyPose> bodies{};  ///< of at most kMostBodiesSampled, evenly chosen
    Layout layout{};
    double energy_J{0};
};
inline constexpr std::size_t kMostBodiesSampled = 300;

/// One run. Shorter than asked for where its status is not Done.
struct Trace {
    RunStatus status{RunStatus::Done};
    std::string why{};
    double end_s{0};
    std::vector<Moment> moments{};  ///< the start first
    double energy_turnover_J{0};    ///< most kinetic energy, or change of the potential
    double penetration_m{0};        ///< deepest of all samples after the start
    double joint_error_m{0};
};

/// What a worker answers.
struct SceneAnswer {
    std::size_t bodies{0};
    std::size_t joints{0};
    double mass_kg{0};
    double gravity_mps2{0};
    double body_size_m{0};  ///< median diagonal of the bodies' boxes
    /// That the scene called for and bodies feel, and whose fidelity its file leaves open.
    std::vector<std::string> effects{};
    double cpu_s{0};   ///< of all that was done for it, loading and sampling included
    double wall_s{0};  ///< likewise; more than `cpu_s` on a machine that does other things too
    std::vector<Trace> traces{};  ///< one per copy
    std::string engine_version{};
    RunCost cost{};
};

/// Runs scenes in this process. The latest scene stays loaded until one of its files changes, as a
/// study asks about one scene many times.
class SceneRunner {
public:
    /// Refused: a scene that does not load, or has no dynamic body (exit code 4).
    Result<SceneAnswer> run(const SceneRun& run);

private:
    Result<Done> open(const SceneRun& run);
    /// The `number`th run; what it finds beside its cost goes to `answer`. `process`: the engine's, where there is one.
    Result<Lap> run_one(const SceneRun& run,
                        int number,
                        EngineProcess* process,
                        SceneAnswer& answer);

    std::filesystem::path file_;
    std::optional<scene::OpenedScene> opened_;
    std::filesystem::path start_file_;
    std::optional<SceneStart> start_;
    std::unique_ptr<assets::AssetLibrary> library_;
};

/// The kind "scene": SceneRunner::run() as a job.
RunJob scene_jobs();
std::string scene_job_body(const SceneRun& run);
Result<SceneAnswer> parse_scene_answer(const std::string& body);

}  // namespace plumbline::study
