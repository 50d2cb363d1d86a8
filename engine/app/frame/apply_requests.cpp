// What a person asked for, request by request.
#include "engine/app/frame/frame.h"

#include <utility>
#include <variant>

namespace plumbline::app {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

void apply(const Request& request, Frame& frame) {
    std::visit(
        Overloaded{
            [&](const WorldRequest& asked) { frame.world.apply(asked); },
            [&](const ChangeConfig& asked) { frame.input.change_config(asked.wanted); },
            [&](const ChangeBindings& asked) { frame.input.change_bindings(asked.wanted); },
            [&](const OpenScene& asked) { frame.opening.begin(frame.state.play.def, asked.file); },
            [&](const ReloadScene&) {
                if (frame.world.reload_scene()) frame.view.renderer().forget_scene();
            },
            [&](const ReloadShaders&) { frame.view.reload_shaders(); },
            [&](const SaveGame& asked) { frame.world.save_game(asked.slot); },
            [&](const LoadGame& asked) { frame.world.load_game(asked.slot); },
            [&](const SaveLevel&) { frame.world.save_level(); },
            [&](const SaveImage&) { frame.view.save_image(); },
            [&](const SaveRecording&) { frame.world.save_recording(); },
            [&](const StartOrEndFilm&) { frame.film.start_or_end(); },
            [&](const ToggleFullscreen&) {
                frame.window.set_fullscreen(!frame.window.fullscreen());
            },
            [&](const AdoptAccuracy&) { frame.world.adopt_accuracy(); },
            [&](const StartGhost& asked) { frame.world.start_ghost(asked); },
            [&](const StopGhost&) { frame.world.accuracy.stop_ghost(); },
            [&](const StartStudy&) { frame.world.accuracy.study.start(); },
            [&](const StopStudy&) { frame.world.accuracy.study.stop(); },
            [&](const StartPictureStudy&) { frame.world.start_picture_study(); },
            [&](const StopPictureStudy&) { frame.world.accuracy.picture.stop(); },
            [&](const SetImageLevel& asked) {
                AppConfig wanted = frame.state.config();
                wanted.quality_level = asked.level;
                frame.input.change_config(wanted);
            },
            [&](const ShowHintsAgain&) {
                frame.view.hints.forget();
                frame.state.messages.say("hints reset");
            },
            [&](const Quit&) { frame.present.end_with(ExitCode::Good); }},
        request);
}

}  // namespace

void apply(Requests& requests, Frame& frame) {
    frame.world.accuracy.watch(frame.view.settings.parts.accuracy);
    frame.world.note_saved_files(frame.window.now_s(), requests);
    frame.view.note_saved_files(frame.window.now_s(), requests);
    for (const Request& request : std::exchange(requests, {})) apply(request, frame);
    // What runs goes on where another scene is refused.
    if (const Result<Done> opened = frame.opening.update(); !opened)
        frame.state.say_failed(opened.error());
}

}  // namespace plumbline::app
