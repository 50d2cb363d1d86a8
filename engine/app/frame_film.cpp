// A film of what the window shows, from one press to the next.
#include "engine/app/frame_parts_impl.h"
#include "engine/app/screenshot.h"
#include "engine/core/files.h"
#include "engine/core/log.h"

namespace plumbline::app {
namespace {

constexpr int kFramesPer_s = 30;

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
                          .frames_per_s = kFramesPer_s});
    if (!film) {
        say(film.error().message);
        return;
    }
    film_ = std::move(*film);
    film_start_s_ = window_.now_s();
    film_frames_ = 0;
    say("a film is taken until the same key is pressed again");
}

void FrameParts::film_frame() {
    if (!film_) return;
    const platform::PixelSize size = window_.framebuffer_size();
    if (static_cast<std::uint32_t>(size.width) != film_->def().width_px ||
        static_cast<std::uint32_t>(size.height) != film_->def().height_px) {
        say("the window has another size: the film ends");
        end_film();
        return;
    }
    const double due = (window_.now_s() - film_start_s_) * kFramesPer_s + 1.0;
    const int times = static_cast<int>(due) - film_frames_;
    // Where ffmpeg is slower than we are, later pictures stand for those in between.
    if (times <= 0 || film_->is_full()) return;
    film_frames_ += times;
    if (!film_->add(renderer->read_pixels(), times)) end_film();
}

void FrameParts::end_film() {
    const Result<Done> finished = film_->finish();
    const std::string line =
        finished ? "film saved: " + film_->def().file.string() : finished.error().message;
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
