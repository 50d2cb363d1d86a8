#include "engine/app/frame/view_phase.h"

#include "engine/app/capture/screenshot.h"
#include "engine/app/overlay/loading_screen.h"
#include "engine/core/log.h"
#include "engine/physics/debug_lines.h"
#include "engine/scene/extract.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace plumbline::app {
namespace fs = std::filesystem;
namespace {

/// The setting is a walker's view; other cameras and zooming keep their proportion to it.
Real fov_with_setting_rad(Real fov_y_rad, Real setting_deg) {
    constexpr Real kWidest_rad = radians_from_degrees(140.0_r);
    static const Real usual = std::tan(radians_from_degrees(AppConfig{}.fov_deg) / 2);
    const Real wanted = std::tan(radians_from_degrees(setting_deg) / 2);
    if (wanted == usual) return fov_y_rad;
    const Real scaled = 2 * std::atan(std::tan(fov_y_rad / 2) * wanted / usual);
    return std::min(scaled, std::max(kWidest_rad, fov_y_rad));
}

/// Of the first model that moves, where a model is shown by itself.
std::optional<AnimationBar> bar_of(const scene::Simulation& simulation) {
    if (!simulation.description().shows_model) return std::nullopt;
    for (auto [entity, playing] : simulation.registry.view<const scene::PlayingModel>()) {
        const assets::MovingModel* model = simulation.library().moving(playing.model);
        if (model == nullptr) continue;
        const assets::ModelAnimation& animation =
            model->data.animations[playing.animation % model->data.animations.size()];
        return AnimationBar{.name = animation.name,
                            .length_s = static_cast<double>(animation.duration_s),
                            .time_s = playing.time_s,
                            .paused = playing.paused};
    }
    return std::nullopt;
}

std::vector<fs::path> files_below(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed))
        if (entry->is_regular_file(failed)) files.push_back(entry->path());
    return files;
}

}  // namespace

ViewPhase::ViewPhase(FrameState& state,
                     platform::Window& window,
                     std::unique_ptr<render::Renderer> renderer_made)
    : overlay(window, state.play.def.thumbnails),
      camera_path({.folder = in_user_data(state.play.def, "camera_paths"),
                   .scene = scene_name(state.play.session),
                   .file = state.play.def.camera_path},
                  [&state](std::string line) {
                      log_note("{}", line);
                      state.messages.say(std::move(line));
                  }),
      hints(in_user_data(state.play.def, "first_minute")),
      state_(state),
      session_(state.play.session),
      window_(window),
      renderer_(std::move(renderer_made)),
      shader_watch_(files_below(state.play.def.shader_folder)),
      quality_request_(quality_request_of(state.config())),
      quality_(quality_request_, renderer_->draws_in_software()) {}

Real ViewPhase::fov_rad(const scene::ViewPoint& view) const {
    return fov_with_setting_rad(view.fov_y_rad, Real{state_.config().fov_deg});
}

scene::ViewPoint ViewPhase::point(Real blend, const FrameInput& input) {
    scene::ViewPoint view = session_.game->view(*session_.simulation,
                                                blend,
                                                input.latch.pending_yaw_rad(),
                                                input.latch.pending_pitch_rad());
    view.fov_y_rad = fov_rad(view);
    return camera_path.see(view, window_.now_s(), input.menu.open());
}

bool ViewPhase::pointer_is_free(const input::ActionLatch& latch) const {
    return latch.bindings().tuning.free_pointer && !session_.game->frees_pointer();
}

std::optional<std::array<float, 2>> ViewPhase::pointer_of(const InputSnapshot& input,
                                                          const input::ActionLatch& latch) const {
    const platform::PixelSize size = window_.framebuffer_size();
    if (!pointer_is_free(latch) || size.width <= 0 || size.height <= 0) return {};
    const scene::ViewPoint seen = session_.game->view(*session_.simulation, Real{1}, 0.0F, 0.0F);
    const double height = size.height;
    const double per_px = 2.0 * std::tan(static_cast<double>(fov_rad(seen)) / 2) / height;
    return std::array{static_cast<float>((input.cursor_px[0] - size.width / 2.0) * per_px),
                      static_cast<float>((height / 2.0 - input.cursor_px[1]) * per_px)};
}

render::RenderFrame ViewPhase::extract(const scene::ViewPoint& view,
                                       const FrameInput& input,
                                       const AccuracyControl& accuracy) {
    const scene::Simulation& simulation = *session_.simulation;
    const platform::PixelSize size = window_.framebuffer_size();
    render::RenderFrame frame = scene::extract(simulation,
                                               view,
                                               static_cast<std::uint32_t>(size.width),
                                               static_cast<std::uint32_t>(size.height));
    frame.fill_mode = settings.fill_mode;
    frame.depth_test = settings.depth_test;
    if (const QualityRequest wish = quality_request_of(state_.config()); wish != quality_request_) {
        quality_request_ = wish;
        quality_ = QualityControl(wish, renderer_->draws_in_software());
    }
    frame.quality = quality_.quality();
    session_.effects->extract(simulation, view, frame);
    accuracy.add_ghost_lines(frame.lines, Vec3f(view.world_from_camera.position));
    if (settings.parts.hud && !input.menu.open())
        session_.game->add_lines(simulation, view.blend, frame.lines);
    if (settings.collision_shapes)
        add_debug_lines(simulation.physics, frame.lines, view.world_from_camera.position);
    if (settings.collision_boxes)
        add_box_lines(simulation.physics, frame.lines, view.world_from_camera.position);
    return frame;
}

void ViewPhase::draw_overlay(const render::RenderFrame& frame,
                             const FrameInput& input,
                             const OverlayWorld& others,
                             Requests& requests) {
    if (frame.width_px == 0 || frame.height_px == 0) return;
    const AppConfig& config = state_.config();
    const scene::Simulation& simulation = *session_.simulation;
    const scene::HudContent hud = session_.game->hud(simulation);
    const double now_s = window_.now_s();
    // It would lie over the start page.
    if (renderer_->draws_in_software() && !input.menu.open() &&
        !std::exchange(said_software_, true))
        state_.messages.say("software rendering (no GPU driver): expect a low frame rate");
    for (const std::string& message : hud.messages) state_.messages.say_latest(message);
    std::vector<std::string> faults = input.faults;
    for (const std::string& fault : {renderer_->shader_fault(), others.world.scene_fault})
        if (!fault.empty()) faults.push_back(fault);
    std::vector<effects::LedgerLine> ledger;
    if (settings.parts.stats != StatsPage::Off) ledger = session_.effects->ledger();
    const HintScene hint_scene{.has_flashlight = simulation.description().flashlight.has_value(),
                               .looks_at_model = looks_at_model(session_),
                               .by_pointer = pointer_is_free(input.latch)};
    const bool gives_hints = config.hints && !state_.play.def.unattended;
    overlay.draw({.parts = settings.parts,
                  .hud = hud,
                  .simulation = simulation,
                  .report = state_.report,
                  .clock = state_.clock,
                  .bindings = input.latch.bindings(),
                  .device = input.latch.last_device(),
                  .ledger = ledger,
                  .accuracy = others.world.accuracy,
                  .judge = session_.judge.get(),
                  .best_s = hud.goal ? others.world.results.of(scene_name(session_)) : std::nullopt,
                  .replaying = others.world.stepper.replaying(),
                  .hint = gives_hints ? hints.now(hint_scene) : std::nullopt,
                  .messages = state_.messages.lines(now_s, config.reduce_motion),
                  .faults = std::move(faults),
                  .lines_not_shown = frame.lines.not_shown,
                  .captions = others.sound.captions(now_s),
                  .camera_path = camera_path.status(),
                  .animation = bar_of(simulation)},
                 input.devices,
                 input.menu,
                 requests);
}

void ViewPhase::draw_opening(const SceneOpening& opening) {
    if (!opening.running()) return;
    render::LoadingBar bar = waiting_bar_of(window_, window_.now_s());
    bar.background = render::LoadingBackground::AsItIs;
    render::draw_loading_bar(window_.gl_loader(), bar);
}

void ViewPhase::note_cost(const FrameCost& cost) {
    if (!window_.iconified() && renderer_->stats().new_programs == 0) quality_.add_frame(cost);
    state_.report.set_image({.level = name_of(quality_.level()),
                             .is_automatic = quality_.is_automatic(),
                             .quality = quality_.quality()});
}

void ViewPhase::reload_shaders() {
    if (const Result<Done> reloaded = renderer_->reload_shaders(); !reloaded)
        log_error("{}", reloaded.error().message);
    // A fault stands on the screen until it is mended.
    if (renderer_->shader_fault().empty()) state_.messages.say("shaders reloaded");
}

void ViewPhase::note_saved_files(double now_s, Requests& requests) {
    if (!shader_watch_.take_changed(now_s).empty()) requests.push_back(ReloadShaders{});
}

void ViewPhase::save_image() {
    const auto saved = save_screenshot(
        *renderer_, state_.play.def.user_data_folder / "shots", scene_name(session_));
    state_.messages.say(saved ? "screenshot saved: " + saved->string() : saved.error().message);
}

}  // namespace plumbline::app
