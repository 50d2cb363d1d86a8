// What all phases of a frame use: how time runs, what is told to the person, what is counted.
#pragma once

#include "engine/app/frame/play_def.h"
#include "engine/app/frame_report.h"
#include "engine/app/overlay/messages.h"
#include "engine/core/log.h"
#include "engine/core/time/frame_clock.h"

namespace plumbline::app {

struct FrameState {
    explicit FrameState(const Play& with)
        : play(with), clock(with.session.simulation->step_s()), report(with.def.chosen_s) {}

    const AppConfig& config() const { return play.config.current(); }
    /// To the log and to the person.
    void say_failed(const Error& error) {
        log_error("{}", error.message);
        messages.say(error.message);
    }

    Play play;
    FrameClock clock;
    FrameReport report;
    Messages messages;
};

}  // namespace plumbline::app
