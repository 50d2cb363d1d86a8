#include "engine/study/scenes/scene_run.h"

#include "engine/core/process/process_memory.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/totals.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/study/engines/engine_table.h"
#include "engine/study/engines/other_engine.h"
#include "engine/study/scenes/moving_samples.h"
#include "engine/study/stepping_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

/// Wall time that another engine may take for a sample, as a multiple of the CPU time that a run may.
constexpr double kEngineWall = 3;

/// One simulation from its start to its end.
class OneRun {
public:
    /// `scene` has started. `engine`: who steps it; null: its own physics.
    OneRun(const SceneRun& run, PlayedScene& scene, OtherEngine* engine)
        : run_(run),
          engine_(engine),
          scene_(scene),
          simulation_(scene.simulation()),
          start_s_(simulation_.time_s()),
          steps_per_sample_(
              std::max(1, static_cast<int>(std::lround(kSampleEvery_s / simulation_.step_s())))),
          bodies_(simulation_) {}

    MovingSamples& bodies() { return bodies_; }

    /// Steps to the end, sampling as often as agreed.
    Trace sample() {
        Trace trace;
        const physics::Energy start = physics::energy(simulation_.physics);
        trace.moments.push_back(moment());
        std::size_t next = 0;
        for (int sample = 1; next < run_.moments.size(); ++sample) {
            if (!step_to_next_sample(trace)) break;
            const physics::Energy energy = physics::energy(simulation_.physics);
            note_turnover(trace, start, energy);
            const physics::PoseFaults faults = this->faults();
            trace.penetration_m = std::max(trace.penetration_m, faults.penetration_m);
            trace.joint_error_m = std::max(trace.joint_error_m, faults.joint_error_m);
            if (sample != run_.moments[next]) continue;
            trace.moments.push_back(moment());
            ++next;
        }
        trace.end_s = done_s();
        return trace;
    }

    /// Steps to the end for the clock alone.
    void repeat() {
        Trace unused;
        for (int sample = 0; sample < run_.moments.back(); ++sample) {
            if (!step_to_next_sample(unused)) break;
        }
    }

    /// Of all steps so far.
    Lap lap() const {
        Lap lap = lap_;
        lap.simulated_s = done_s();
        return lap;
    }

private:
    Moment moment() {
        Moment now = bodies_.moment();
        now.time_s = done_s();
        return now;
    }
    double done_s() const { return simulation_.time_s() - start_s_; }

    physics::PoseFaults faults() const {
        if (engine_ != nullptr) return engine_->faults();
        return {.penetration_m = max_penetration_m(simulation_.physics),
                .joint_error_m = max_joint_error_m(simulation_.physics)};
    }

    void step() {
        const CpuTimer timer;
        LapTimer clock;
        clock.start();
        double helpers_ms = 0;
        for (int i = 0; i < steps_per_sample_; ++i) {
            scene_.step();
            const physics::StepCost& cost = simulation_.physics.report().cost;
            lap_.work += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
            helpers_ms += cost.helpers_ms;
            if (engine_ == nullptr) lap_.step_ms.push_back(static_cast<float>(cost.total_ms));
        }
        if (engine_ != nullptr) return;
        lap_.cpu_ms += timer.ms() + helpers_ms;
        lap_.clock_ms += clock.lap_ms();
    }

    /// False where the engine stopped; `trace` then says why.
    bool catch_up(Trace& trace) {
        if (engine_ == nullptr) return true;
        const Result<EngineMoved> moved = engine_->catch_up(kEngineWall * run_.cpu_limit_s);
        if (!moved || !moved->is_finite) {
            trace.status = moved ? RunStatus::NotFinite : RunStatus::Crashed;
            trace.why = fmt::format("{} by {:.2f} s",
                                    moved ? "a body had no finite state" : moved.error().message,
                                    done_s());
            return false;
        }
        lap_.cpu_ms += moved->cpu_ms;
        lap_.step_ms.insert(lap_.step_ms.end(), moved->step_ms.begin(), moved->step_ms.end());
        return true;
    }

    /// False where the run ends early; `trace` then says why.
    bool step_to_next_sample(Trace& trace) {
        step();
        if (!catch_up(trace)) return false;
        if (!simulation_.physics.report().isolated.empty()) {
            trace.status = RunStatus::NotFinite;
            trace.why = fmt::format(
                "{} had no finite state by {:.2f} s",
                name_of_mark(
                    simulation_,
                    simulation_.physics.state(simulation_.physics.report().isolated.front()).user),
                done_s());
            return false;
        }
        if (lap_.cpu_ms > run_.cpu_limit_s * 1e3) {
            trace.status = RunStatus::TimedOut;
            trace.why =
                fmt::format("{:g} s of CPU time went for {:.2f} s", run_.cpu_limit_s, done_s());
            return false;
        }
        return true;
    }

    const SceneRun& run_;
    OtherEngine* engine_;
    PlayedScene& scene_;
    scene::Simulation& simulation_;
    double start_s_;
    int steps_per_sample_;
    MovingSamples bodies_;
    Lap lap_;
};

/// By the ledger at the end of a run.
std::vector<std::string> open_effects(const PlayedScene& scene) {
    std::vector<std::string> open;
    const auto names = scene::effects_with_fidelity();
    const auto& given = scene.simulation().description().effect_settings;
    const std::vector<effects::LedgerLine> ledger = scene.effects().ledger();
    for (std::size_t i = 0; i < ledger.size(); ++i) {
        const std::string name(ledger[i].name);
        if (effects::effect_table()[i].domain == effects::Domain::Step &&
            ledger[i].constructions > 0 && !given.contains(name) &&
            std::ranges::find(names, name) != names.end())
            open.push_back(name);
    }
    return open;
}

/// The first run warms up, and counts only where it stays alone.
RunCost cost_of_runs(std::span<const Lap> laps) {
    return cost_of(laps.size() > 1 ? laps.subspan(1) : laps);
}

}  // namespace

Result<Done> SceneRunner::open(const SceneRun& run) {
    if (start_file_ != run.start) {
        start_.reset();
        start_file_ = run.start;
        if (!run.start.empty()) {
            Result<SceneStart> start = read_start(run.start);
            if (!start) return start.error();
            start_ = std::move(*start);
        }
    }
    const std::filesystem::path& file = run.scene;
    if (opened_ && file_ == file && scene::unchanged(opened_->files)) return Done{};
    opened_.reset();
    library_ = std::make_unique<assets::AssetLibrary>();
    Result<scene::OpenedScene> opened = open_for_study(file);
    if (!opened) return opened.error();
    opened_ = std::move(*opened);
    file_ = file;
    return Done{};
}

Result<SceneAnswer> SceneRunner::run(const SceneRun& run) {
    const double start_s = wall_s();
    const double cpu_start_s = thread_cpu_s();
    if (const Result<Done> opened = open(run); !opened) return opened.error();
    opened_->overrides = overrides(run.setting);
    opened_->overrides.threads = run.threads;
    reset_peak_resident_bytes();
    SceneAnswer answer;
    std::optional<EngineProcess> process;
    if (run.engine) {
        Result<EngineProcess> started = start_engine(*run.engine);
        if (!started) return started.error();
        answer.engine_version = started->version();
        process = std::move(*started);
    }
    std::vector<Lap> laps;
    double spent_s = 0;
    const int runs = run.copies + run.repeats;
    for (int i = 0; i < runs; ++i) {
        if (i >= run.copies && spent_s > run.repeat_s) break;
        const Result<Lap> lap = run_one(run, i, process ? &*process : nullptr, answer);
        if (!lap) return lap.error();
        if (lap->simulated_s > 0) laps.push_back(*lap);
        // An engine that compiles itself while it runs has spent much in its first run already.
        if (!run.engine || i >= run.copies) spent_s += lap->cpu_ms * 1e-3;
        if (answer.traces.back().status != RunStatus::Done) break;
    }
    answer.cost = cost_of_runs(laps);
    answer.cost.bodies = answer.bodies;
    if (!run.engine) answer.cost.peak_bytes = peak_resident_bytes();
    answer.cpu_s = thread_cpu_s() - cpu_start_s;
    answer.wall_s = wall_s() - start_s;
    return answer;
}

Result<Lap> SceneRunner::run_one(const SceneRun& run,
                                 int number,
                                 EngineProcess* process,
                                 SceneAnswer& answer) {
    Result<PlayedScene> scene = PlayedScene::create(*opened_, *library_);
    if (!scene) return scene.error();
    if (start_) {
        if (const Result<Done> taken = take_up(*start_, *scene); !taken) return taken.error();
    }
    scene->start();
    std::unique_ptr<OtherEngine> engine;
    if (process != nullptr) {
        auto made = OtherEngine::create(*run.engine, *process, *scene);
        if (!made) return made.error();
        engine = std::move(*made);
    }
    OneRun one(run, *scene, engine.get());
    MovingSamples& bodies = one.bodies();
    if (bodies.bodies().empty())
        return Error{.message = fmt::format("{}: nothing in it moves by itself, so there is no "
                                            "accuracy to study; expected a body of kind "
                                            "\"dynamic\"",
                                            run.scene.string()),
                     .exit_code = ExitCode::Refused};
    if (number == 0) bodies.describe(answer);
    if (run.shift_m > 0)
        bodies.shift(run.seed + static_cast<std::uint64_t>(std::min(number, run.copies - 1)),
                     run.shift_m);
    if (number < run.copies)
        answer.traces.push_back(one.sample());
    else
        one.repeat();
    if (number == 0 && bodies.has_others()) answer.effects = open_effects(*scene);
    return one.lap();
}

}  // namespace plumbline::study
