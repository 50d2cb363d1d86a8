// A film of what the window shows, from one press to the next.
#include "engine/app/capture/screenshot.h"
#include "engine/app/frame_parts_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/log.h"

#include <algorithm>

namespace plumbline::app {
namespace {

constexpr int kFramesPer_s = 30;
constexpr double kPeriod_s = 1.0 / kFramesPer_s;

}  // namespace

void FrameParts::start_or_end_film() {
    if (film_) {
        end_film();
        return;
    }
    const std::filesystem::path folder = def_.user_data_folder / "films";
    if (const Result<Done> made = make_folder(folder); !made) {
        say(made.error().message);
        return;
    }
    const platform::PixelSize size = window_.framebuffer_size();
    Result<std::unique_ptr<VideoFile>> film =
        VideoFile::start({.file = unused_file(folder, scene_name(), ".mp4"),
                          .width_px = static_cast<std::uint32_t>(size.width),
                          .height_px = static_cast<std::uint32_t>(size.height),
                          .frames_per_s = kFramesPer_s,
                          .live = true});
    if (!film) {
        say(film.error().message);
        return;
    }
    film_ = std::move(*film);
    film_next_s_ = window_.now_s();
    say("recording video; press the same key to stop");
}

void FrameParts::film_frame() {
    if (!film_) return;
    const platform::PixelSize size = window_.framebuffer_size();
    if (static_cast<std::uint32_t>(size.width) != film_->def().width_px ||
        static_cast<std::uint32_t>(size.height) != film_->def().height_px) {
        say("window resized: video recording stopped");
        end_film();
        return;
    }
    const double now_s = window_.now_s();
    // Where ffmpeg is slower than we are, the frame before stands longer.
    if (now_s < film_next_s_ || film_->is_full()) return;
    film_next_s_ = std::max(film_next_s_, now_s - kPeriod_s) + kPeriod_s;
    if (!film_->add(renderer->read_pixels(film_->spare()))) end_film();
}

void FrameParts::end_film() {
    const Result<Done> finished = film_->finish();
    const std::string line =
        finished ? "video saved: " + film_->def().file.string() : finished.error().message;
    say(line);
    // The window may be closing.
    if (finished) {
        log_note("{}", line);
    } else {
        log_error("{}", line);
    }
    film_.reset();
}

}  // namespace plumbline::app
