#include "engine/app/controls/frame_controls.h"

#include "engine/app/controls/action_words.h"

#include <fmt/format.h>

namespace plumbline::app {
namespace {

void apply_time_actions(input::ActionLatch& latch,
                        FrameControls& controls,
                        FrameClock& clock,
                        const std::function<void(std::string)>& say) {
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
    if (latch.take_frame_presses(Action::Reset) > 0) controls.reset = true;
    if (latch.take_frame_presses(Action::QuickSave) > 0) controls.save_slot = 0;
    if (latch.take_frame_presses(Action::QuickLoad) > 0) controls.load_slot = 0;
    if (latch.take_frame_presses(Action::Reload) > 0) controls.reload = true;
}

void apply_view_actions(input::ActionLatch& latch,
                        FrameControls& controls,
                        platform::Window& window,
                        const std::function<void(std::string)>& say) {
    const auto toggles = [&](Action action) { return latch.take_frame_presses(action) % 2 == 1; };
    using render::FillMode;
    const auto toggle_fill = [&](FillMode mode) {
        controls.fill_mode = controls.fill_mode == mode ? FillMode::Filled : mode;
    };
    if (toggles(Action::Hud)) controls.parts.hud = !controls.parts.hud;
    for (int i = latch.take_frame_presses(Action::Stats); i > 0; --i)
        controls.parts.stats = next(controls.parts.stats);
    if (toggles(Action::AccuracyPanel)) controls.parts.accuracy = !controls.parts.accuracy;
    if (toggles(Action::CollisionShapes)) controls.collision_shapes = !controls.collision_shapes;
    if (toggles(Action::CollisionBoxes)) controls.collision_boxes = !controls.collision_boxes;
    if (const int times = latch.take_frame_presses(Action::DepthTest); times > 0) {
        controls.depth_test = render::next(controls.depth_test, times);
        say(fmt::format("depth test: {}", render::name_of(controls.depth_test)));
    }
    if (toggles(Action::Wireframe)) toggle_fill(FillMode::Wireframe);
    if (toggles(Action::Points)) toggle_fill(FillMode::Points);
    if (latch.take_frame_presses(Action::Filled) > 0) controls.fill_mode = FillMode::Filled;
    if (toggles(Action::Fullscreen)) window.set_fullscreen(!window.fullscreen());
    if (latch.take_frame_presses(Action::Screenshot) > 0) controls.screenshot = true;
    if (latch.take_frame_presses(Action::Record) > 0) controls.save_recording = true;
    if (toggles(Action::Film)) controls.film = true;
}

/// Named in the contract of actions, built with the parts of the program that they belong to.
void refuse_unbuilt_actions(input::ActionLatch& latch,
                            const std::function<void(std::string)>& say) {
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (in_this_version(action) || latch.take_frame_presses(action) == 0) continue;
        say(fmt::format("\"{}\" is not available", action_words(action)));
    }
}

}  // namespace

void apply_frame_actions(input::ActionLatch& latch,
                         FrameControls& controls,
                         FrameClock& clock,
                         platform::Window& window,
                         const std::function<void(std::string)>& say) {
    apply_time_actions(latch, controls, clock, say);
    apply_view_actions(latch, controls, window, say);
    refuse_unbuilt_actions(latch, say);
}

void resume_toggles(const scene::Game& game, input::ActionLatch& latch) {
    const auto put = [&](Action action, bool engaged) {
        if (engaged) {
            latch.engage(action);
        } else {
            latch.release(action);
        }
    };
    put(Action::Grab, game.holds());
    put(Action::Crouch, game.crouches());
}

}  // namespace plumbline::app
