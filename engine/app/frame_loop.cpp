#include "engine/app/frame_loop.h"

#include "engine/app/frame/frame.h"
#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"

namespace plumbline::app {

/// The order below is the order of a frame; there is no other.
PlayEnd run(platform::Window& window, const Play& play) {
    Result<std::unique_ptr<Frame>> made = Frame::create(window, play);
    if (!made) {
        log_error("{}", made.error().message);
        return {.code = made.error().exit_code};
    }
    Frame& frame = **made;
    const CloseAtExit whatever_happens(frame);
    render::Renderer& renderer = frame.view.renderer();
    Requests requests;  // of keys, menu and panels, until they are applied

    while (!frame.ended()) {
        const double frame_start_s = wall_s();

        // Input: devices become intent. A press is kept until a step has seen it.
        const InputSnapshot devices = window.poll_input();
        frame.input.take(devices, requests);

        // Time: how many whole steps are due, and how far we stand between the last two poses.
        const FrameTime time = frame.state.clock.advance(window.now_s());

        // Simulation: the only lines that change the world.
        apply(requests, frame);
        frame.world.run_steps(time, frame.input.latch);
        play.session.effects->refresh(*play.session.simulation);

        // Extraction: the world is read, blended and copied into plain data.
        const scene::ViewPoint eye = frame.view.point(time.blend, frame.input.shown());
        const render::RenderFrame image =
            frame.view.extract(eye, frame.input.shown(), frame.world.accuracy);

        // Passes: each reads the frame's data and what the passes above it drew.
        renderer.begin(image);
        renderer.shadows();
        renderer.opaque();
        renderer.sky();
        renderer.translucent();
        renderer.post();
        renderer.lines();
        frame.view.draw_overlay(image, frame.input.shown(), {frame.world, frame.sound}, requests);
        frame.view.draw_opening(frame.opening);
        renderer.end();
        frame.film.add_frame(renderer);

        // Sound: what the steps asked for, heard from where this frame is seen.
        frame.sound.play(eye, frame.input.menu.menu(), devices.now_s);

        frame.present.present(frame_start_s, frame.view);
    }
    return frame.close();
}

}  // namespace plumbline::app
