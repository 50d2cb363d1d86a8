#include "game/commands/simulate_command.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/frame_clock.h"
#include "engine/core/time/trace_events.h"
#include "engine/effects/advance.h"
#include "engine/effects/saved_game.h"
#include "engine/physics/totals.h"
#include "engine/scene/open_scene.h"
#include "engine/scene/scene_file.h"
#include "engine/scene/simulation/trace_csv.h"
#include "engine/scene/state_report.h"
#include "engine/scene/warning_log.h"
#include "engine/study/auto_preset/auto_accuracy.h"
#include "engine/study/gallery/case_events.h"
#include "game/command_line/refuse.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace plumbline::game {

namespace fs = std::filesystem;

namespace {

/// What is loaded for one run. The library outlives the simulation.
struct World {
    assets::AssetLibrary library;
    std::optional<scene::OpenedScene> opened;
    std::unique_ptr<scene::Simulation> simulation;
    scene::WarningLog warning_log;
    std::optional<effects::SavedGame> saved;  ///< to continue from
};

Result<Done> load(const SimulateOptions& options, World& world) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const Result<fs::path> file =
        scene::find_scene(options.scene, scene::scene_folders(folders->assets));
    if (!file) return file.error();
    Diagnostics faults;
    Result<scene::OpenedScene> opened =
        scene::open_scene(*file,
                          {.folders = *folders,
                           .overrides = {.solver = options.solver,
                                         .step_hz = options.step_hz,
                                         .substeps = options.substeps,
                                         .iterations = options.iterations,
                                         .threads = options.threads,
                                         .seed = options.seed}},
                          faults);
    if (!opened) {
        for (const Diagnostic& fault : faults.list()) log_error("{}", to_string(fault));
        return opened.error();
    }
    world.opened = std::move(*opened);
    world.opened->description.accuracy = study::resolve_auto(*world.opened);
    if (!options.load_file.empty()) {
        Result<effects::SavedGame> saved = effects::read_saved_game(options.load_file);
        if (!saved) return saved.error();
        world.opened->description.accuracy.fidelity = saved->fidelity;
        world.saved = std::move(*saved);
    }
    Result<std::unique_ptr<scene::Simulation>> built = world.opened->build(world.library);
    if (!built) return built.error();
    world.simulation = std::move(*built);
    study::play_case_events(*world.simulation);
    world.warning_log.log_new(*world.simulation);
    return Done{};
}

/// Runs the steps and collects what the files want to know.
class Run {
public:
    Run(const SimulateOptions& options, World& world)
        : options_(options),
          opened_(*world.opened),
          simulation_(*world.simulation),
          warning_log_(world.warning_log),
          game_(simulation_.description().camera),
          effects_(simulation_, {.frame = false, .sound = false}) {}

    Result<Done> go_on_from(const effects::SavedGame& saved, const fs::path& file) {
        return effects::put_back(saved, file, running());
    }
    Result<Done> save(const fs::path& file) {
        return effects::save_game(file, running(), simulation_.steps());
    }

    /// The error is that of the trace, which ends the run.
    Result<Done> all_steps() {
        const auto steps_in = [this](double duration_s) {
            return static_cast<std::uint64_t>(std::llround(duration_s / simulation_.step_s()));
        };
        steps_wanted_ = simulation_.steps() + steps_in(options_.seconds);
        steps_between_traces_ = std::max<std::uint64_t>(1, steps_in(options_.trace_every_s));
        if (!options_.trace_file.empty()) traced_ = trace_.open(options_.trace_file);
        if (traces_csv() && traced_) traced_ = trace_.write(scene::trace_csv_head());
        trace();
        if (!options_.trace_events_file.empty() && traced_) {
            traced_ = event_file_.open(options_.trace_events_file);
            events_.emplace();
        }
        if (options_.drive_fps)
            step_by_frames();
        else
            while (!done()) step();
        if (traced_) traced_ = trace_.close();
        if (events_ && traced_)
            traced_ = event_file_.write(events_->take() + std::string(TraceRecording::kEnd));
        return traced_ ? event_file_.close() : traced_;
    }

    void step_by_frames() {
        FrameClock clock(simulation_.step_s());
        for (std::uint64_t frame = 0; !done(); ++frame) {
            const double now_s = static_cast<double>(frame) / *options_.drive_fps;
            const int due = clock.advance(now_s).steps;
            for (int i = 0; i < due && !done(); ++i) step();
        }
        lost_s_ = clock.lost_s();
    }

    std::string state(bool one_line) const {
        return scene::state_json(
            simulation_, costs_, effects::ledger_json(effects_.ledger()), lost_s_, one_line);
    }
    const scene::CostHistory& costs() const { return costs_; }

private:
    effects::RunningGame running() {
        return {.opened = opened_, .simulation = simulation_, .effects = effects_, .game = game_};
    }
    bool done() const { return simulation_.steps() >= steps_wanted_ || interrupted() || !traced_; }

    void step() {
        effects::advance(simulation_, effects_, game_, {});
        warning_log_.log_new(simulation_);
        costs_.add(simulation_.physics.report().cost);
        if (simulation_.steps() % steps_between_traces_ == 0) trace();
        if (events_ && traced_) traced_ = event_file_.write(events_->take());
    }

    void trace() {
        if (options_.trace_file.empty() || !traced_) return;
        traced_ =
            trace_.write(traces_csv() ? scene::trace_csv_lines(simulation_) : state(true) + "\n");
    }
    bool traces_csv() const { return options_.trace_file.extension() == ".csv"; }

    const SimulateOptions& options_;
    const scene::OpenedScene& opened_;
    scene::Simulation& simulation_;
    scene::WarningLog& warning_log_;
    scene::NoGame game_;
    effects::EffectRuntime effects_;
    std::uint64_t steps_wanted_{0};
    std::uint64_t steps_between_traces_{1};
    scene::CostHistory costs_;
    GrowingOutput trace_;
    GrowingOutput event_file_;
    std::optional<TraceRecording> events_;
    Result<Done> traced_{Done{}};
    double lost_s_{0.0};
};

/// Beside what a file may take of the standard output.
std::ostream& summary_stream(const SimulateOptions& options) {
    const bool taken = is_standard_output(options.state_file) ||
                       is_standard_output(options.trace_file) ||
                       is_standard_output(options.trace_events_file);
    return taken ? std::cerr : std::cout;
}

void print_summary(std::ostream& out,
                   const scene::Simulation& simulation,
                   const scene::CostHistory& costs) {
    const physics::Energy energy = physics::energy(simulation.physics);
    const scene::Percentiles step_ms = scene::percentiles_of(costs.step_ms);
    const auto awake = std::count_if(simulation.moving_bodies().begin(),
                                     simulation.moving_bodies().end(),
                                     [](const scene::MovingBody& body) { return body.awake; });
    out << fmt::format(
        "{:.3f} s in {} steps of {:.3f} ms, {} ({})\n"
        "{} moving bodies, {} awake, {} removed, {} not finite\n"
        "kinetic {:.4g} J, potential {:.4g} J\n"
        "{:.3f} ms a step (median), {:.3f} ms (worst), {:.1f} ms in all\n"
        "state {}\n",
        simulation.time_s(),
        simulation.steps(),
        simulation.step_s() * 1e3,
        physics::solver_name(simulation.physics.def().solver),
        kPrecisionName,
        simulation.moving_bodies().size(),
        awake,
        simulation.tally().removed,
        simulation.physics.report().isolated.size(),
        energy.kinetic_J,
        energy.potential_J + energy.elastic_J,
        step_ms.median,
        step_ms.max,
        costs.cpu_ms_total,
        hex_of(simulation.state_hash()));
}

}  // namespace

ExitCode run_simulate(const SimulateOptions& options) {
    for (const fs::path& file :
         {options.state_file, options.trace_file, options.trace_events_file, options.save_file}) {
        if (const Result<Done> open = check_output(file); !open) return refuse(open.error());
    }
    World world;
    if (const Result<Done> loaded = load(options, world); !loaded) return refuse(loaded.error());
    scene::Simulation& simulation = *world.simulation;
    Run run(options, world);
    if (world.saved) {
        const Result<Done> there = run.go_on_from(*world.saved, options.load_file);
        if (!there) return refuse(there.error());
    }
    const PollsInterrupts polls;
    const Result<Done> traced = run.all_steps();
    print_summary(summary_stream(options), simulation, run.costs());

    ExitCode code = interrupted() ? ExitCode::Interrupted : ExitCode::Good;
    if (!traced) code = refuse(traced.error());
    const auto write = [&](const fs::path& file, const std::string& text) {
        const Result<Done> written = write_output(file, text);
        if (!written) code = refuse(written.error());
    };
    if (!options.state_file.empty()) write(options.state_file, run.state(false) + "\n");
    if (!options.save_file.empty()) {
        if (const Result<Done> saved = run.save(options.save_file); !saved)
            code = refuse(saved.error());
    }
    const std::string hash = hex_of(simulation.state_hash());
    if (code == ExitCode::Good && options.expect_hash && *options.expect_hash != hash) {
        log_error("the state at the end is {}, expected {}", hash, *options.expect_hash);
        return ExitCode::Differs;
    }
    return code;
}

}  // namespace plumbline::game
