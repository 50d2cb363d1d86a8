#include "engine/app/session.h"

#include "engine/core/log.h"
#include "engine/study/any_scene/auto_accuracy.h"

namespace plumbline::app {
namespace {

void log_faults(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults.list()) {
        const LogLevel level =
            fault.severity == Severity::Error ? LogLevel::Error : LogLevel::Warning;
        log_line(level, to_string(fault));
    }
}

}  // namespace

Result<std::unique_ptr<Session>> Session::open(const SessionDef& def) {
    std::unique_ptr<Session> session(new Session(def));
    Diagnostics faults;
    session->surfaces =
        scene::load_surfaces(def.folders.config / "surfaces.toml", def.folders.assets, faults);
    Result<scene::SceneDescription> description =
        scene::load_scene(def.scene, def.folders.assets, faults);
    log_faults(faults);
    if (!description) return description.error();
    session->description = std::move(*description);
    session->description.accuracy = study::resolve_auto(session->description);
    if (const Result<Done> built = session->build(); !built) return built.error();
    return session;
}

Result<Done> Session::build() {
    Result<std::unique_ptr<scene::Simulation>> built =
        scene::build_simulation(description, def_.overrides, library, surfaces);
    if (!built) return built.error();
    effects.reset();
    game.reset();
    simulation = std::move(*built);
    for (const std::string& warning : simulation->warnings()) log_line(LogLevel::Warning, warning);
    judge.reset();
    if (simulation->description().hard_case) {
        Result<study::HardCaseJudge> made = study::HardCaseJudge::create(*simulation);
        if (!made) return made.error();
        judge = std::make_unique<study::HardCaseJudge>(std::move(*made));
    }
    game = def_.make_game(*simulation);
    effects = std::make_unique<effects::EffectRuntime>(*simulation, def_.served);
    return Done{};
}

Result<Done> Session::reset() {
    return build();
}

Result<Done> Session::reload() {
    Diagnostics faults;
    Result<scene::SceneDescription> description_read =
        scene::load_scene(def_.scene, def_.folders.assets, faults);
    log_faults(faults);
    if (!description_read) return description_read.error();
    description_read->accuracy = study::resolve_auto(*description_read);
    library.doubt_models();
    scene::SceneDescription before = std::exchange(description, std::move(*description_read));
    Result<Done> built = build();
    if (!built) description = std::move(before);
    return built;
}

}  // namespace plumbline::app
