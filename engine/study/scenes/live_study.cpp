#include "engine/study/scenes/live_study.h"

#include <utility>

namespace plumbline::study {

LiveStudy::LiveStudy(SceneStudyOptions options)
    : thread_([this, asked = std::move(options)](const std::stop_token& stop) mutable {
          asked.workers.stop = stop;
          run(std::move(asked));
      }) {}

void LiveStudy::run(SceneStudyOptions options) {
    options.tell = [this](const SceneStudy& study) {
        const std::scoped_lock lock(mutex_);
        state_.study = study;
        ++revision_;
    };
    options.progress = [this](const StudyProgress& progress) {
        const std::scoped_lock lock(mutex_);
        state_.progress = progress;
    };
    Result<SceneStudy> made = study_scene(options);
    const std::scoped_lock lock(mutex_);
    if (made)
        state_.study = std::move(*made);
    else
        state_.failure = made.error().message;
    state_.ended = true;
    ++revision_;
}

LiveStudy::State LiveStudy::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

StudyProgress LiveStudy::progress() const {
    const std::scoped_lock lock(mutex_);
    return state_.progress;
}

std::uint64_t LiveStudy::revision() const {
    const std::scoped_lock lock(mutex_);
    return revision_;
}

}  // namespace plumbline::study
