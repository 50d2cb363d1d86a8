// What a person asked for, one function a request.
#include "engine/app/frame/frame.h"
#include "engine/core/log.h"

#include <utility>
#include <variant>

namespace plumbline::app {
namespace {

void apply(const WorldRequest& asked, Frame& frame) {
    frame.world.apply(asked);
}
void apply(const ChangeConfig& asked, Frame& frame) {
    frame.input.change_config(asked.wanted);
}
void apply(const ChangeBindings& asked, Frame& frame) {
    frame.input.change_bindings(asked.wanted);
}
void apply(const OpenScene& asked, Frame& frame) {
    frame.opening.begin(frame.state.play.def, asked.file);
}
void apply(const ReloadScene&, Frame& frame) {
    if (frame.world.reload_scene()) frame.view.renderer().forget_scene();
}
void apply(const ReloadShaders&, Frame& frame) {
    frame.view.reload_shaders();
}
void apply(const SaveGame& asked, Frame& frame) {
    frame.world.save_game(asked.slot);
}
void apply(const LoadGame& asked, Frame& frame) {
    frame.world.load_game(asked.slot);
}
void apply(const SaveImage&, Frame& frame) {
    frame.view.save_image();
}
void apply(const SaveRecording&, Frame& frame) {
    frame.world.save_recording();
}
void apply(const StartOrEndFilm&, Frame& frame) {
    frame.film.start_or_end();
}
void apply(const ToggleFullscreen&, Frame& frame) {
    frame.window.set_fullscreen(!frame.window.fullscreen());
}
void apply(const AdoptAccuracy&, Frame& frame) {
    frame.world.adopt_accuracy();
}
void apply(const StartGhost& asked, Frame& frame) {
    frame.world.start_ghost(asked);
}
void apply(const StopGhost&, Frame& frame) {
    frame.world.accuracy.stop_ghost();
}
void apply(const ShowHintsAgain&, Frame& frame) {
    frame.view.hints.forget();
    frame.state.messages.say("hints reset");
}
void apply(const Quit&, Frame& frame) {
    frame.present.end_with(ExitCode::Good);
}

}  // namespace

void apply(Requests& requests, Frame& frame) {
    frame.world.accuracy.watch(frame.view.settings.parts.accuracy);
    frame.world.note_saved_files(frame.window.now_s(), requests);
    frame.view.note_saved_files(frame.window.now_s(), requests);
    for (const Request& request : std::exchange(requests, {}))
        std::visit([&](const auto& asked) { apply(asked, frame); }, request);
    // What runs goes on where another scene is refused.
    if (const Result<Done> opened = frame.opening.update(); !opened) {
        log_error("{}", opened.error().message);
        frame.state.messages.say(opened.error().message);
    }
}

}  // namespace plumbline::app
