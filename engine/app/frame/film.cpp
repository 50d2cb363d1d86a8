#include "engine/app/frame/film.h"

#include "engine/app/capture/screenshot.h"
#include "engine/core/io/files.h"
#include "engine/core/log.h"

#include <algorithm>

namespace plumbline::app {
namespace {

constexpr int kFramesPer_s = 30;
constexpr double kPeriod_s = 1.0 / kFramesPer_s;

}  // namespace

void Film::start_or_end() {
    if (file_) return end();
    const std::filesystem::path folder = state_.play.def.user_data_folder / "films";
    if (const Result<Done> made = make_folder(folder); !made)
        return state_.messages.say(made.error().message);
    const platform::PixelSize size = window_.framebuffer_size();
    Result<std::unique_ptr<VideoFile>> started =
        VideoFile::start({.file = unused_file(folder, scene_name(state_.play.session), ".mp4"),
                          .width_px = static_cast<std::uint32_t>(size.width),
                          .height_px = static_cast<std::uint32_t>(size.height),
                          .frames_per_s = kFramesPer_s,
                          .live = true});
    if (!started) return state_.messages.say(started.error().message);
    file_ = std::move(*started);
    next_s_ = window_.now_s();
    state_.messages.say("recording video; press the same key to stop");
}

void Film::add_frame(const render::Renderer& renderer) {
    if (!file_) return;
    const platform::PixelSize size = window_.framebuffer_size();
    if (static_cast<std::uint32_t>(size.width) != file_->def().width_px ||
        static_cast<std::uint32_t>(size.height) != file_->def().height_px) {
        state_.messages.say("window resized: video recording stopped");
        return end();
    }
    const double now_s = window_.now_s();
    // Where ffmpeg is slower than we are, the frame before stands longer.
    if (now_s < next_s_ || file_->is_full()) return;
    next_s_ = std::max(next_s_, now_s - kPeriod_s) + kPeriod_s;
    if (!file_->add(renderer.read_pixels(file_->spare()))) end();
}

void Film::end() {
    if (!file_) return;
    const Result<Done> finished = file_->finish();
    const std::string line =
        finished ? "video saved: " + file_->def().file.string() : finished.error().message;
    state_.messages.say(line);
    // The window may be closing.
    if (finished)
        log_note("{}", line);
    else
        log_error("{}", line);
    file_.reset();
}

}  // namespace plumbline::app
