#include "engine/app/session.h"

#include "engine/core/log.h"
#include "engine/scene/accuracy.h"
#include "engine/scene/simulation/sun_hour.h"
#include "engine/study/auto_preset/auto_accuracy.h"
#include "engine/study/gallery/case_events.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <variant>

namespace plumbline::app {
namespace {

void log_errors(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults.list()) {
        if (fault.severity == Severity::Error) log_error("{}", to_string(fault));
    }
}

void run_at(const study::Setting& setting, scene::Simulation& simulation) {
    physics::WorldDef def = simulation.physics.def();
    const physics::WorldDef asked = study::world_def(setting);
    def.step_s = asked.step_s;
    def.substeps = asked.substeps;
    def.substeps_max = asked.substeps_max;
    def.iterations = asked.iterations;
    def.solver = asked.solver;
    simulation.set_accuracy(def);
}

scene::OpenedScene at_fidelity(scene::OpenedScene opened,
                               const std::vector<scene::EffectFidelity>& fidelity) {
    opened.description.accuracy.fidelity = fidelity;
    return opened;
}

void change(const SwitchEffect& asked, scene::Simulation& simulation) {
    if (asked.on)
        simulation.switches.turn(asked.effect, *asked.on);
    else
        simulation.switches.effects.erase(asked.effect);
}

void change(const SetFog& asked, scene::Simulation& simulation) {
    simulation.switches.fog_density_scale = asked.density_scale;
    simulation.switches.fog_color = asked.color;
}

void change(const SetLight& asked, scene::Simulation& simulation) {
    simulation.switches.light_scale = asked.scale;
}

void change(const SetHour& asked, scene::Simulation& simulation) {
    set_hour(simulation, asked.hour);
}

void change(const SetAnimation& asked, scene::Simulation& simulation) {
    for (auto [entity, playing] : simulation.registry.view<scene::PlayingModel>()) {
        const assets::MovingModel* model = simulation.library().moving(playing.model);
        if (model == nullptr) continue;
        playing.paused = asked.paused;
        if (!asked.next && asked.time_s == playing.time_s) continue;
        playing.latest_step_s = 0;  // it jumps there
        playing.time_s = asked.next ? 0.0 : asked.time_s;
        const auto count = static_cast<std::uint32_t>(model->data.animations.size());
        if (asked.next) playing.animation = (playing.animation + 1) % count;
    }
}

}  // namespace

Result<std::unique_ptr<Session>> Session::open(const SessionDef& def) {
    std::unique_ptr<Session> session(new Session(def));
    if (const Result<Done> opened = session->reload(); !opened) return opened.error();
    return session;
}

Result<scene::OpenedScene> Session::open_scene() {
    Diagnostics faults;
    Result<scene::OpenedScene> opened = scene::open_scene(
        def_.scene, {.folders = def_.folders, .overrides = def_.overrides}, faults);
    if (opened) {
        scene::Accuracy& accuracy = opened->description.accuracy;
        accuracy = study::resolve_auto(*opened);
        if (!accuracy.threads) accuracy.threads = scene::kAutoThreads;
        return opened;
    }
    log_errors(faults);
    // Whatever is mended first, one of these will change.
    for (const Diagnostic& fault : faults.list()) watch(fault.file, scene::FileUse::Scene);
    return opened;
}

void Session::watch(const std::filesystem::path& file, scene::FileUse use) {
    const auto known = [&](const scene::FileStamp& each) { return each.path == file; };
    if (!file.empty() && std::ranges::none_of(files_, known))
        files_.push_back(scene::stamp_of(file, use));
}

Result<Done> Session::build(const scene::OpenedScene& opened,
                            const std::optional<study::Setting>& accuracy,
                            const Prepare& prepare) {
    Result<std::unique_ptr<scene::Simulation>> built =
        accuracy ? at_fidelity(opened, accuracy->fidelity).build(library) : opened.build(library);
    if (!built) return built.error();
    if (accuracy) run_at(*accuracy, **built);
    if (def_.hour) set_hour(**built, *def_.hour);
    study::play_case_events(**built);
    std::unique_ptr<study::HardCaseJudge> judge_made;
    if ((*built)->description().hard_case) {
        Result<study::HardCaseJudge> made = study::HardCaseJudge::create(**built);
        if (!made) return made.error();
        judge_made = std::make_unique<study::HardCaseJudge>(std::move(*made));
    }
    std::unique_ptr<scene::Game> game_made = def_.make_game(**built);
    auto effects_made = std::make_unique<effects::EffectRuntime>(**built, def_.served);
    if (prepare) {
        const Result<Done> prepared = prepare({.opened = opened,
                                               .simulation = **built,
                                               .effects = *effects_made,
                                               .game = *game_made});
        if (!prepared) return prepared;
    }
    // Nothing fails from here on, not even for want of memory: the running world goes when the new
    // one is whole.
    effects = std::move(effects_made);
    game = std::move(game_made);
    judge = std::move(judge_made);
    simulation = std::move(*built);
    ++generation_;
    warning_log = {};
    warning_log.log_new(*simulation);
    return Done{};
}

Result<Done> Session::apply(const WorldRequest& request) {
    return std::visit(
        [this]<class Asked>(const Asked& asked) -> Result<Done> {
            if constexpr (std::is_same_v<Asked, StartAgain>)
                return build(scene_, chosen_accuracy_);
            else if constexpr (std::is_same_v<Asked, SetAccuracy>)
                return set_accuracy(asked.setting);
            else
                change(asked, *simulation);
            return Done{};
        },
        request);
}

Result<Done> Session::set_accuracy(const study::Setting& setting) {
    // Bodies that deform are made of as many parts as their fidelity says.
    if (judge || setting.fidelity != accuracy().fidelity) {
        if (const Result<Done> built = build(scene_, setting); !built) return built;
    } else {
        run_at(setting, *simulation);
    }
    chosen_accuracy_ = setting;
    return Done{};
}

study::Setting Session::accuracy() const {
    const physics::WorldDef& def = simulation->physics.def();
    const bool on_demand =
        def.solver == physics::Solver::SmallStep && def.substeps_max > def.substeps;
    return {.solver = def.solver,
            .step_hz = static_cast<int>(std::lround(1 / def.step_s)),
            .substeps = on_demand ? 0 : def.substeps,
            .substeps_max = def.substeps_max,
            .iterations = def.iterations,
            .precision = sizeof(Real) == sizeof(double) ? study::Precision::Float64
                                                        : study::Precision::Float32,
            .fidelity = simulation->description().accuracy.fidelity};
}

void Session::prefetch_images() {
    const std::optional<scene::SkyDescription>& sky = description().sky;
    library.prefetch_images(sky ? sky->folder : std::filesystem::path());
}

void Session::prefetch_sounds() {
    std::set<std::filesystem::path> files;
    for (const scene::Surface& surface : simulation->surfaces().surfaces) {
        files.insert(surface.impact_sounds.begin(), surface.impact_sounds.end());
        files.insert(surface.step_sounds.begin(), surface.step_sounds.end());
        files.insert({surface.roll_sound, surface.scrape_sound});
    }
    files.erase(std::filesystem::path());
    library.prefetch_sounds({files.begin(), files.end()});
}

Result<Done> Session::save(const std::filesystem::path& file, std::uint64_t steps) {
    return effects::save_game(
        file,
        {.opened = scene_, .simulation = *simulation, .effects = *effects, .game = *game},
        steps);
}

Result<std::uint64_t> Session::load(const std::filesystem::path& file) {
    const Result<effects::SavedGame> saved = effects::read_saved_game(file);
    if (!saved) return saved.error();
    const study::Setting before = accuracy();
    const scene::OpenedScene opened = at_fidelity(scene_, saved->fidelity);
    const Result<Done> built = build(opened, {}, [&](const effects::RunningGame& made) {
        return effects::put_back(*saved, file, made);
    });
    if (!built) return built.error();
    if (accuracy() != before) chosen_accuracy_ = accuracy();
    return saved->steps;
}

Result<Done> Session::reload() {
    // As they are before the reading: a save meanwhile is then seen as one, an old fault is not.
    for (scene::FileStamp& file : files_) file = scene::stamp_of(file.path, file.use);
    Result<scene::OpenedScene> opened = open_scene();
    if (!opened) return opened.error();
    files_ = opened->files;
    library.doubt_models();
    if (const Result<Done> built = build(*opened, {}); !built) return built;
    chosen_accuracy_.reset();
    // What models are made of shows when they are read: buffers, materials, images.
    for (const std::filesystem::path& file : library.model_files())
        watch(file, scene::FileUse::Model);
    scene_ = std::move(*opened);
    return Done{};
}

}  // namespace plumbline::app
