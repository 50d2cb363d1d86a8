#include "engine/app/frame_loop.h"

#include "engine/app/frame_parts_impl.h"
#include "engine/core/log.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"

namespace plumbline::app {

/// The order below is the order of a frame; there is no other.
PlayEnd run(platform::Window& window,
            Session& session,
            LiveBindings& bindings,
            LiveConfig& config,
            const PlayDef& def) {
    Result<std::unique_ptr<FrameParts>> made =
        FrameParts::create(window, session, bindings, config, def);
    if (!made) {
        log_error("{}", made.error().message);
        return {.code = made.error().exit_code};
    }
    FrameParts& parts = **made;
    const CloseAtExit whatever_happens(parts);

    while (!parts.ended(window.now_s())) {
        const double frame_start_s = wall_s();

        // Input: devices become intent. A press is kept until a step has seen it.
        const InputSnapshot input = window.poll_input();
        parts.take_input(input);

        // Time: how many whole steps are due, and how far we stand between the last two poses.
        const FrameTime time = parts.clock.advance(window.now_s());

        // Simulation: the only lines that change the world.
        parts.do_requests();
        parts.run_steps(time);
        session.effects->refresh(*session.simulation);

        // Extraction: the world is read, blended and copied into plain data.
        const scene::ViewPoint view = parts.view(time.blend);
        const render::RenderFrame frame = parts.extract(view);

        // Passes: each reads the frame and the images of the passes above it.
        parts.renderer->begin(frame);
        parts.renderer->shadows();
        parts.renderer->opaque();
        parts.renderer->sky();
        parts.renderer->translucent();
        parts.renderer->post();
        parts.renderer->lines();
        parts.draw_overlay(frame);
        parts.draw_opening();
        parts.renderer->end();
        parts.film_frame();

        // Sound: what the steps asked for, heard from where this frame is seen.
        parts.play_sound(view, input.now_s);

        const double present_s = wall_s();
        window.present();
        parts.finish_frame(frame_start_s, present_s);
    }
    return parts.close();
}

}  // namespace plumbline::app
