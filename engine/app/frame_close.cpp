// The end of a session: the files that were asked for, and the exit code.
#include "engine/app/frame_parts_impl.h"
#include "engine/core/hash.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace plumbline::app {

std::array<std::uint64_t, kActionCount> FrameParts::actions_seen() const {
    std::array<std::uint64_t, kActionCount> seen = latch.presses_seen();
    // Replays and random input press no keys: what their steps were told counts.
    for (std::size_t i = 0; i < kActionCount; ++i)
        seen[i] = std::max(seen[i], stepper.presses()[i]);
    return seen;
}

bool FrameParts::write_files() {
    if (written_) return true;
    written_ = true;
    camera_path_.end_recording();
    bool good = true;
    const auto note = [&](const Result<Done>& done) {
        if (done) return;
        log_error("{}", done.error().message);
        good = false;
    };
    const bool passed_on = next_ && stepper.steps() == 0;  // as behind the start page
    if (!def_.record.empty() && !passed_on) note(stepper.save_recording(def_.record));
    if (!def_.report.empty()) {
        report_text_ = report.json({.simulation = *session_.simulation,
                                    .ledger = session_.effects->ledger(),
                                    .gl = renderer->gl(),
                                    .lost_s = clock.lost_s(),
                                    .presses_seen = actions_seen(),
                                    .before = def_.report_before});
        note(write_output(def_.report, report_text_));
    }
    return good;
}

PlayEnd FrameParts::close() {
    window_.capture_pointer(false);
    if (film_) end_film();
    if (interrupted()) next_.reset();
    ExitCode code = interrupted() ? ExitCode::Interrupted : code_;
    if (!write_files()) code = ExitCode::RunFailed;
    const std::string hash = hex_of(session_.simulation->state_hash());
    if (!stepper.divergence().empty()) code = ExitCode::Differs;
    if (!next_ && def_.expect_hash && *def_.expect_hash != hash) {
        log_error("the state at the end is {}, expected {}", hash, *def_.expect_hash);
        code = ExitCode::Differs;
    }
    log_note("{} steps, state {}", stepper.steps(), hash);
    return {.code = code,
            .next = std::move(next_),
            .chosen_s = chosen_s_,
            .seconds = window_.now_s() - start_s_,
            .steps = stepper.steps(),
            .report = std::move(report_text_)};
}

void go_on(PlayDef& def, const PlayEnd& end) {
    def.start_page = false;
    def.first_message.clear();
    if (end.steps > 0 && !def.record.empty()) {
        def.first_message = fmt::format("a recording is of one scene: {} ends with the one before",
                                        def.record.string());
        log_warning("{}", def.first_message);
        def.record.clear();
    }
    if (def.seconds) *def.seconds -= end.seconds;
    def.steps.replay.clear();
    def.steps.first_step = 0;
    def.camera_path.clear();
    def.chosen_s = end.chosen_s;
    def.report_before = end.report;
}

namespace {

/// What exit() may have to close; functions given to atexit() take no arguments.
FrameParts* open_parts = nullptr;

void close_open_parts() {
    if (open_parts == nullptr) return;
    log_error("lost the connection to the display");
    open_parts->write_files();
}

}  // namespace

CloseAtExit::CloseAtExit(FrameParts& parts) {
    [[maybe_unused]] static const int kAsked = std::atexit(close_open_parts);
    open_parts = &parts;
}

CloseAtExit::~CloseAtExit() {
    open_parts = nullptr;
}

}  // namespace plumbline::app
