#include "engine/app/frame/frame.h"

#include "engine/app/overlay/loading_screen.h"
#include "engine/core/hash.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"

#include <algorithm>
#include <cstdlib>
#include <future>
#include <utility>

namespace plumbline::app {
namespace {

std::array<std::uint64_t, kActionCount> actions_seen(const Frame& frame) {
    std::array<std::uint64_t, kActionCount> seen = frame.input.latch.presses_seen();
    // Replays and random input press no keys: what their steps were told counts.
    for (std::size_t i = 0; i < kActionCount; ++i)
        seen[i] = std::max(seen[i], frame.world.stepper.presses()[i]);
    return seen;
}

/// What exit() may have to close; functions given to atexit() take no arguments.
Frame* open_frame = nullptr;

void close_open_frame() {
    if (open_frame == nullptr) return;
    log_error("lost the connection to the display");
    open_frame->write_files();
}

}  // namespace

Result<std::unique_ptr<Frame>> Frame::create(platform::Window& window, const Play& play) {
    // Reads a hundred files; meanwhile the first frame is made ready.
    auto scenes = std::async(std::launch::async | std::launch::deferred,
                             [folders = scene::scene_folders(play.session.folders().assets)] {
                                 return scene::list_scenes(folders);
                             });
    Result<std::unique_ptr<render::Renderer>> renderer =
        render::Renderer::create(window.gl_loader(),
                                 render::PresentTarget::Window,
                                 play.def.shader_folder,
                                 play.session.library);
    if (!renderer) return renderer.error();
    StepperDef steps = play.def.steps;
    steps.record = play.def.record;
    Result<Stepper> stepper = Stepper::create(play.session, steps);
    if (!stepper) return stepper.error();
    auto frame = std::make_unique<Frame>(window, play, std::move(*stepper), std::move(*renderer));
    LoadingScreen screen(window);
    screen.show(0.0F);
    const scene::ViewPoint first = frame->view.point(Real{1}, frame->input.shown());
    render::Renderer& made = frame->view.renderer();
    made.prepare(frame->view.extract(first, frame->input.shown(), frame->world.accuracy),
                 [&](float share) { screen.show(share); });
    if (const std::string& fault = made.shader_fault(); !fault.empty())
        return Error{.message = fault, .exit_code = ExitCode::NoDisplay};
    frame->world.scenes = scenes.get();
    return frame;
}

Frame::Frame(platform::Window& window_shown,
             const Play& play,
             Stepper stepper,
             std::unique_ptr<render::Renderer> renderer)
    : window(window_shown),
      state(play),
      world(state, std::move(stepper)),
      sound(state),
      view(state, window, std::move(renderer)),
      input(state, window, world, view),
      present(state, window),
      film(state, window) {
    if (!play.def.first_message.empty()) state.messages.say(play.def.first_message);
    log_faults(play.bindings.faults());
    for (const Diagnostics& faults : {play.bindings.faults(), play.config.faults()})
        for (const Diagnostic& fault : faults.list()) state.messages.say(to_string(fault));
}

bool Frame::ended() const {
    return present.ended() || opening.opened() || interrupted() || world.stepper.ended();
}

bool Frame::write_files() {
    if (report_text) return true;
    report_text.emplace();
    view.camera_path.end_recording();
    bool good = true;
    const auto note = [&](const Result<Done>& done) {
        if (done) return;
        log_error("{}", done.error().message);
        good = false;
    };
    const PlayDef& def = state.play.def;
    // As behind the start page: the recording is of the scene in which time goes on.
    const bool passed_on = opening.opened() && world.stepper.steps() == 0;
    if (!def.record.empty() && !passed_on) note(world.stepper.save_recording(def.record));
    if (!def.report.empty()) {
        report_text = state.report.json({.simulation = *state.play.session.simulation,
                                         .ledger = state.play.session.effects->ledger(),
                                         .gl = view.renderer().gl(),
                                         .lost_s = state.clock.lost_s(),
                                         .presses_seen = actions_seen(*this),
                                         .before = def.report_before});
        note(write_output(def.report, *report_text));
    }
    return good;
}

PlayEnd Frame::close() {
    window.capture_pointer(false);
    film.end();
    if (interrupted()) opening.take();
    ExitCode code = interrupted() ? ExitCode::Interrupted : present.code();
    if (!write_files()) code = ExitCode::RunFailed;
    const std::optional<std::string>& expected = state.play.def.expect_hash;
    const std::string hash = hex_of(state.play.session.simulation->state_hash());
    if (!world.stepper.divergence().empty()) code = ExitCode::Differs;
    if (!opening.opened() && expected && *expected != hash) {
        log_error("the state at the end is {}, expected {}", hash, *expected);
        code = ExitCode::Differs;
    }
    log_note("{} steps, state {}", world.stepper.steps(), hash);
    return {.code = code,
            .next = opening.take(),
            .chosen_s = opening.chosen_s(),
            .seconds = present.seconds(),
            .steps = world.stepper.steps(),
            .report = std::move(*report_text)};
}

CloseAtExit::CloseAtExit(Frame& frame) {
    [[maybe_unused]] static const int kAsked = std::atexit(close_open_frame);
    open_frame = &frame;
}

CloseAtExit::~CloseAtExit() {
    open_frame = nullptr;
}

}  // namespace plumbline::app
