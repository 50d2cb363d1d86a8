#include "engine/app/controls/frame_controls.h"

#include <fmt/format.h>

namespace plumbline::app {
namespace {

using Say = std::function<void(std::string)>;

void apply_time_actions(input::ActionLatch& latch, FrameClock& clock, const Say& say) {
    if (latch.take_frame_presses(Action::Pause) % 2 == 1) clock.set_paused(!clock.paused());
    for (int i = latch.take_frame_presses(Action::Step); i > 0; --i) {
        clock.set_paused(true);
        clock.request_step();
    }
    const int slower = latch.take_frame_presses(Action::Slower);
    const int faster = latch.take_frame_presses(Action::Faster);
    for (int i = 0; i < slower; ++i) clock.set_speed(clock.speed() * 0.5);
    for (int i = 0; i < faster; ++i) clock.set_speed(clock.speed() * 2.0);
    if (slower + faster > 0) say(fmt::format("speed {:g}x", clock.speed()));
}

void apply_view_actions(input::ActionLatch& latch, ViewSettings& view, const Say& say) {
    const auto toggles = [&](Action action) { return latch.take_frame_presses(action) % 2 == 1; };
    using render::FillMode;
    const auto toggle_fill = [&](FillMode mode) {
        view.fill_mode = view.fill_mode == mode ? FillMode::Filled : mode;
    };
    if (toggles(Action::Hud)) view.parts.hud = !view.parts.hud;
    for (int i = latch.take_frame_presses(Action::Stats); i > 0; --i)
        view.parts.stats = next(view.parts.stats);
    if (toggles(Action::AccuracyPanel)) view.parts.accuracy = !view.parts.accuracy;
    if (toggles(Action::CollisionShapes)) view.collision_shapes = !view.collision_shapes;
    if (toggles(Action::CollisionBoxes)) view.collision_boxes = !view.collision_boxes;
    if (const int times = latch.take_frame_presses(Action::DepthTest); times > 0) {
        view.depth_test = render::next(view.depth_test, times);
        say(fmt::format("depth test: {}", render::name_of(view.depth_test)));
    }
    if (toggles(Action::Wireframe)) toggle_fill(FillMode::Wireframe);
    if (toggles(Action::Points)) toggle_fill(FillMode::Points);
    if (latch.take_frame_presses(Action::Filled) > 0) view.fill_mode = FillMode::Filled;
}

void ask_for_actions(input::ActionLatch& latch, Requests& requests) {
    const auto pressed = [&](Action action) { return latch.take_frame_presses(action) > 0; };
    const auto toggled = [&](Action action) { return latch.take_frame_presses(action) % 2 == 1; };
    if (pressed(Action::Reset)) requests.push_back(WorldRequest{StartAgain{}});
    if (pressed(Action::Reload)) {
        requests.push_back(ReloadScene{});
        requests.push_back(ReloadShaders{});
    }
    if (pressed(Action::QuickSave)) requests.push_back(SaveGame{});
    if (pressed(Action::QuickLoad)) requests.push_back(LoadGame{});
    if (pressed(Action::Screenshot)) requests.push_back(SaveImage{});
    if (pressed(Action::Record)) requests.push_back(SaveRecording{});
    if (toggled(Action::Film)) requests.push_back(StartOrEndFilm{});
    if (toggled(Action::Fullscreen)) requests.push_back(ToggleFullscreen{});
}

}  // namespace

void apply_frame_actions(input::ActionLatch& latch,
                         ViewSettings& view,
                         FrameClock& clock,
                         Requests& requests,
                         const Say& say) {
    apply_time_actions(latch, clock, say);
    apply_view_actions(latch, view, say);
    ask_for_actions(latch, requests);
}

void resume_toggles(const scene::Game& game, input::ActionLatch& latch) {
    const auto put = [&](Action action, bool engaged) {
        engaged ? latch.engage(action) : latch.release(action);
    };
    put(Action::Grab, game.holds());
    put(Action::Crouch, game.crouches());
}

}  // namespace plumbline::app
