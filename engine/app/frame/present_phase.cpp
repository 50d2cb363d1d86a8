#include "engine/app/frame/present_phase.h"

#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace plumbline::app {

PresentPhase::PresentPhase(FrameState& state, platform::Window& window)
    : state_(state), window_(window), start_s_(window.now_s()) {}

void PresentPhase::fail(ExitCode code, const std::string& why) {
    log_error("{}", why);
    end_with(code);
}

bool PresentPhase::ended() const {
    const std::optional<double>& most_s = state_.play.def.seconds;
    return ends_ || (most_s && seconds() >= *most_s);
}

void PresentPhase::present(double frame_start_s, ViewPhase& view) {
    const double present_s = wall_s();
    window_.present();
    const render::Renderer& renderer = view.renderer();
    FrameReport& report = state_.report;
    if (report.frames() == 0 && !renderer.shader_fault().empty())
        fail(ExitCode::NoDisplay, renderer.shader_fault());
    if (renderer.device_lost())
        fail(ExitCode::RunFailed, "the graphics device was reset; the session ends");
    state_.play.session.effects->add_render_stats(renderer.stats(), renderer.gpu_bytes());
    const double wall_ms = (wall_s() - frame_start_s) * 1e3;
    report.add_frame(wall_ms, renderer.stats());
    if (report.frames() == 1 && state_.play.def.after_first_frame)
        state_.play.def.after_first_frame(state_.play.session, renderer.gl());
    FrameCost cost{.wall_ms = wall_ms, .cpu_ms = (present_s - frame_start_s) * 1e3};
    for (const render::PassTiming& pass : renderer.stats().passes) {
        if (pass.gpu_ms >= 0.0) cost.gpu_ms = std::max(cost.gpu_ms, 0.0) + pass.gpu_ms;
    }
    view.note_cost(cost);
    const AppConfig& config = state_.config();
    if (vsync_ != config.vsync) {
        vsync_ = config.vsync;
        window_.set_vsync(config.vsync);
    }
    // Hidden windows do not block in present(); without vsync nothing does.
    const double least_s = window_.iconified() ? 0.1 : 1.0 / config.max_fps;
    const double left_s = least_s - (wall_s() - frame_start_s);
    if (left_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
}

}  // namespace plumbline::app
