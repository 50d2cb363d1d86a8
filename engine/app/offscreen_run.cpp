#include "engine/app/offscreen_run.h"

#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/scene/extract.h"

namespace plumbline::app {

Result<std::unique_ptr<OffscreenRun>> OffscreenRun::create(Session& session,
                                                           const OffscreenDef& def) {
    std::unique_ptr<OffscreenRun> run(new OffscreenRun(session, def));
    Result<std::unique_ptr<platform::OffscreenContext>> context =
        platform::OffscreenContext::create();
    if (!context) return context.error();
    run->context_ = std::move(*context);
    Result<std::unique_ptr<render::Renderer>> renderer =
        render::Renderer::create(run->context_->gl_loader(),
                                 render::PresentTarget::Offscreen,
                                 def.shader_folder,
                                 session.library);
    if (!renderer) return renderer.error();
    run->renderer_ = std::move(*renderer);
    return run;
}

OffscreenRun::OffscreenRun(Session& session, const OffscreenDef& def)
    : session_(session), def_(def) {
    // What is only looked at is drawn as its source draws it: a pixel is the mean of four samples.
    if (!def.level && session.simulation->description().viewer)
        report_.set_image({.quality = {.anti_aliasing = render::AntiAliasing::Ssaa4}});
    if (!def.level) return;
    render::Quality quality = render::quality_of(*def.level);
    if (def.render_scale > 0.0F) quality.render_scale = def.render_scale;
    report_.set_image({.level = render::name_of(*def.level), .quality = quality});
}

void OffscreenRun::simulate(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps && !interrupted(); ++i) {
        effects::advance(*session_.simulation, *session_.effects, *session_.game, {});
        report_.add_step(session_.simulation->physics.report().cost);
    }
}

render::RenderFrame OffscreenRun::frame(const std::optional<scene::ViewPoint>& view) {
    session_.effects->refresh(*session_.simulation);  // switches may have been turned
    const scene::ViewPoint seen_from =
        view ? *view : session_.game->view(*session_.simulation, Real{1}, 0.0F, 0.0F);
    render::RenderFrame frame =
        scene::extract(*session_.simulation, seen_from, def_.width_px, def_.height_px);
    if (def_.shading) frame.shading = def_.shading;
    frame.quality = report_.image().quality;
    session_.effects->extract(*session_.simulation, seen_from, frame);
    return frame;
}

Result<Done> OffscreenRun::draw(const std::optional<scene::ViewPoint>& view) {
    const double start_s = wall_s();
    const Result<Done> drawn = draw(frame(view));
    report_.add_frame((wall_s() - start_s) * 1e3, renderer_->stats());
    return drawn;
}

Result<Done> OffscreenRun::draw(const render::RenderFrame& frame) {
    if (report_.frames() == 0) renderer_->prepare(frame);
    render::draw(*renderer_, frame);
    session_.effects->add_render_stats(renderer_->stats(), renderer_->gpu_bytes());
    if (renderer_->device_lost()) return Error{.message = "the graphics device was reset"};
    const std::string& fault = renderer_->shader_fault();
    if (!fault.empty()) return Error{.message = fault, .exit_code = ExitCode::NoDisplay};
    return Done{};
}

std::string OffscreenRun::report_json() const {
    return report_.json({.simulation = *session_.simulation,
                         .ledger = session_.effects->ledger(),
                         .gl = renderer_->gl()});
}

}  // namespace plumbline::app
