#include "engine/app/session.h"

#include "engine/core/log.h"
#include "engine/scene/environment/sun_hour.h"
#include "engine/study/auto_preset/auto_accuracy.h"
#include "engine/study/gallery/case_events.h"

#include <algorithm>
#include <optional>
#include <set>

namespace plumbline::app {
namespace {

void log_errors(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults.list()) {
        if (fault.severity == Severity::Error) log_error("{}", to_string(fault));
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
        opened->description.accuracy = study::resolve_auto(*opened);
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

Result<Done> Session::build(const scene::OpenedScene& opened, const Prepare& prepare) {
    Result<std::unique_ptr<scene::Simulation>> built = opened.build(library);
    if (!built) return built.error();
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
    warning_log = {};
    warning_log.log_new(*simulation);
    return Done{};
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

Result<Done> Session::reset() {
    return build(scene_);
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
    const Result<Done> built = build(scene_, [&](const effects::RunningGame& made) {
        return effects::put_back(*saved, file, made);
    });
    if (!built) return built.error();
    return saved->steps;
}

Result<Done> Session::reload() {
    // As they are before the reading: a save meanwhile is then seen as one, an old fault is not.
    for (scene::FileStamp& file : files_) file = scene::stamp_of(file.path, file.use);
    Result<scene::OpenedScene> opened = open_scene();
    if (!opened) return opened.error();
    files_ = opened->files;
    library.doubt_models();
    if (const Result<Done> built = build(*opened); !built) return built;
    // What models are made of shows when they are read: buffers, materials, images.
    for (const std::filesystem::path& file : library.model_files())
        watch(file, scene::FileUse::Model);
    scene_ = std::move(*opened);
    return Done{};
}

}  // namespace plumbline::app
