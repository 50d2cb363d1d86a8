// What a frame shows and sounds like: the world read, the overlay over it, the cues of its steps.
#include "engine/app/frame_parts_impl.h"
#include "engine/app/overlay/loading_screen.h"
#include "engine/scene/extract.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::app {
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

/// What was done with the bar; it moves no body.
void apply_bar(const AnimationBar& bar, scene::Simulation& simulation) {
    for (auto [entity, playing] : simulation.registry.view<scene::PlayingModel>()) {
        playing.paused = bar.paused;
        if (bar.next || bar.time_s != playing.time_s) playing.latest_step_s = 0;  // it jumps there
        playing.time_s = bar.next ? 0.0 : bar.time_s;
        if (bar.next) ++playing.animation;
    }
}

}  // namespace

scene::ViewPoint FrameParts::view(Real blend) {
    scene::ViewPoint view = session_.game->view(
        *session_.simulation, blend, latch.pending_yaw_rad(), latch.pending_pitch_rad());
    view.fov_y_rad = fov_with_setting_rad(view.fov_y_rad, Real{config_.current().fov_deg});
    return camera_path_.see(view, window_.now_s(), menu_.open());
}

std::optional<std::array<float, 2>> FrameParts::pointer_of(const InputSnapshot& input) const {
    const platform::PixelSize size = window_.framebuffer_size();
    if (!pointer_is_free() || size.width <= 0 || size.height <= 0) return {};
    const scene::ViewPoint seen = session_.game->view(*session_.simulation, Real{1}, 0.0F, 0.0F);
    const Real fov_y_rad = fov_with_setting_rad(seen.fov_y_rad, Real{config_.current().fov_deg});
    const double height = size.height;
    const double per_px = 2.0 * std::tan(static_cast<double>(fov_y_rad) / 2) / height;
    return std::array{static_cast<float>((input.cursor_px[0] - size.width / 2.0) * per_px),
                      static_cast<float>((height / 2.0 - input.cursor_px[1]) * per_px)};
}

render::RenderFrame FrameParts::extract(const scene::ViewPoint& view) {
    const platform::PixelSize size = window_.framebuffer_size();
    render::RenderFrame frame = scene::extract(*session_.simulation,
                                               view,
                                               static_cast<std::uint32_t>(size.width),
                                               static_cast<std::uint32_t>(size.height));
    frame.fill_mode = controls_.fill_mode;
    frame.depth_test = controls_.depth_test;
    frame.quality = quality_control_.quality();
    session_.effects->extract(*session_.simulation, view, frame);
    accuracy_.take_answers();
    accuracy_.add_ghost_lines(frame.lines, Vec3f(view.world_from_camera.position));
    if (controls_.parts.hud && !menu_.open())
        session_.game->add_lines(*session_.simulation, view.blend, frame.lines);
    if (controls_.collision_shapes)
        session_.simulation->physics.add_debug_lines(frame.lines, view.world_from_camera.position);
    if (controls_.collision_boxes)
        session_.simulation->physics.add_box_lines(frame.lines, view.world_from_camera.position);
    return frame;
}

void FrameParts::draw_overlay(const render::RenderFrame& frame) {
    if (frame.width_px == 0 || frame.height_px == 0) return;
    const scene::HudContent hud = session_.game->hud(*session_.simulation);
    const double now_s = window_.now_s();
    // It would lie over the start page.
    if (renderer->draws_in_software() && !menu_.open() && !std::exchange(said_software_, true))
        overlay_.say("software rendering (no GPU driver): expect a low frame rate", now_s);
    for (const std::string& message : hud.messages) overlay_.say_latest(message, now_s);
    if (controls_.parts.stats != StatsPage::Off) ledger_ = session_.effects->ledger();
    const bool hints = config_.current().hints && !def_.unattended;
    const HintScene hint_scene{
        .has_flashlight = session_.simulation->description().flashlight.has_value(),
        .looks_at_model = looks_at_model(),
        .by_pointer = pointer_is_free()};
    std::optional<AnimationBar> bar = bar_of(*session_.simulation);
    const AccuracyRequest asked =
        overlay_.draw({.parts = controls_.parts,
                       .hud = hud,
                       .simulation = *session_.simulation,
                       .report = report,
                       .clock = clock,
                       .bindings = latch.bindings(),
                       .device = latch.last_device(),
                       .ledger = ledger_,
                       .accuracy = accuracy_,
                       .judge = session_.judge.get(),
                       .hint = hints ? first_minute_.now(hint_scene) : std::nullopt,
                       .sound_silent = mixer_ && mixer_->silent(),
                       .reduce_motion = config_.current().reduce_motion,
                       .faults = standing_faults(),
                       .lines_not_shown = frame.lines.not_shown,
                       .captions = captions_.lines(now_s),
                       .camera_path = camera_path_.status(),
                       .animation = bar ? &*bar : nullptr,
                       .now_s = now_s},
                      devices_,
                      menu_);
    if (bar) apply_bar(*bar, *session_.simulation);
    do_accuracy(asked);
}

void FrameParts::draw_opening() {
    if (!opening_.valid()) return;
    render::LoadingBar bar = waiting_bar_of(window_, window_.now_s());
    bar.background = render::LoadingBackground::AsItIs;
    render::draw_loading_bar(window_.gl_loader(), bar);
}

bool FrameParts::looks_at_model() const {
    return session_.description().shows_model && session_.game->frees_pointer();
}

std::vector<std::string> FrameParts::standing_faults() const {
    std::vector<std::string> faults;
    for (const std::string& fault :
         {bindings_fault_, config_fault_, renderer->shader_fault(), scene_fault_})
        if (!fault.empty()) faults.push_back(fault);
    return faults;
}

void FrameParts::do_accuracy(const AccuracyRequest& asked) {
    const std::string said = accuracy_.apply(asked, clock);
    if (!said.empty()) say(said);
    if (asked.adopt) scenes_ = scene::list_scenes(scene::scene_folders(session_.folders().assets));
}

void FrameParts::play_sound(const scene::ViewPoint& view, double now_s) {
    if (!mixer_) return;
    effects::SoundFrame sound = session_.effects->sound(*session_.simulation, view);
    const audio::Listener listener{.position_world = Vec3f(view.world_from_camera.position),
                                   .orientation = Quatf(view.world_from_camera.orientation),
                                   .velocity_mps = Vec3f(view.velocity_mps),
                                   .room = sound.room};
    if (!config_.current().captions)
        captions_.clear();
    else if (!clock.paused())
        captions_.add(sound, listener, now_s);
    for (audio::SoundCue& cue : sound.cues) cue.gain *= config_.current().effects_gain;
    for (audio::LoopCue& loop : sound.loops) loop.gain *= config_.current().ambience_gain;
    menu_sounds_.add(menu_.menu().use(), config_.current().ui_gain, sound.cues);
    mixer_->set_paused(clock.paused());
    mixer_->play(sound.cues, sound.loops, listener, now_s);
}

}  // namespace plumbline::app
