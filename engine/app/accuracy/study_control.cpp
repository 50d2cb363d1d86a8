#include "engine/app/accuracy/study_control.h"

#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/machine.h"

#include <algorithm>

namespace plumbline::app {
namespace {

/// For the whole of it, unless effects that bodies feel ask for more.
constexpr double kWall_s = 18.0;
constexpr double kQuiet_s = 10.0;

}  // namespace

void StudyControl::forget_other_scene() {
    if (generation_ == session_.generation()) return;
    generation_ = session_.generation();
    if (files_ == session_.opened().files) return;  // it was only started again
    live_.reset();
    study_.reset();
    failure_.clear();
    files_ = session_.opened().files;
    key_ = {};
}

void StudyControl::look_up() {
    forget_other_scene();
    if (study_ || live_) return;
    key_ = study::study_key(session_.opened());
    if (auto kept = study::find_study(folder_, key_)) study_ = std::move(kept->study);
}

void StudyControl::start() {
    look_up();
    failure_.clear();
    scene::Simulation& simulation = *session_.simulation;
    left_out_ = 0;
    for ([[maybe_unused]] auto [entity, made] : simulation.registry.view<const scene::Spawned>())
        ++left_out_;
    // One core is the renderer's.
    study::Workers workers{.count = std::max(1, study::default_workers() - 1)};
    workers.programs.priority = Priority::Idle;
    revision_ = 0;
    heard_s_ = wall_s();
    live_ = std::make_unique<study::LiveStudy>(
        study::SceneStudyOptions{.scene = session_.description().file,
                                 .start = study::scene_start_of(simulation),
                                 .grid = study::GridSize::Quick,
                                 .wall_s = kWall_s,
                                 .workers = std::move(workers)});
}

void StudyControl::stop() {
    if (live_) live_->stop();
}

void StudyControl::take_answers() {
    forget_other_scene();
    if (!live_ || live_->revision() == revision_) return;
    revision_ = live_->revision();
    heard_s_ = wall_s();
    study::LiveStudy::State state = live_->state();
    if (!state.study.subject.points.empty()) study_ = state.study;
    if (state.ended) end(state);
}

void StudyControl::end(const study::LiveStudy::State& state) {
    live_.reset();
    failure_ = state.failure;
    if (!state.study.complete || state.study.subject.points.empty()) return;
    const Result<Done> kept = study::keep_study(
        folder_,
        key_,
        {.study = state.study, .grid = study::GridSize::Quick, .made_on = study::today_text()});
    if (!kept) log_warning("the study could not be cached: {}", kept.error().message);
}

bool StudyControl::waits_for_processor() const {
    return live_ && wall_s() - heard_s_ > kQuiet_s;
}

study::StudyProgress StudyControl::progress() const {
    return live_ ? live_->progress() : study::StudyProgress{};
}

}  // namespace plumbline::app
