#include "game/offscreen/frame_files.h"

#include "engine/assets/image/image_import.h"
#include "engine/core/io/output.h"

#include <fmt/format.h>

namespace plumbline::game {
namespace {

std::string name_of_frame(int number) {
    return fmt::format("frame_{:05}.png", number);
}

}  // namespace

Result<FrameFiles> FrameFiles::open(const FrameFilesDef& def) {
    FrameFiles files;
    files.folder_ = def.folder;
    if (!def.folder.empty()) {
        const std::string first = name_of_frame(1);
        const Result<Done> made = make_output_folder(def.folder, {first.c_str()});
        if (!made) return made.error();
    }
    if (def.video.empty()) return files;
    Result<std::unique_ptr<app::VideoFile>> video =
        app::VideoFile::start({.file = def.video,
                               .width_px = def.width_px,
                               .height_px = def.height_px,
                               .frames_per_s = def.frames_per_s});
    if (!video) return video.error();
    files.video_ = std::move(*video);
    return files;
}

Result<Done> FrameFiles::take(const app::OffscreenRun& run) {
    if (folder_.empty() && !video_) return Done{};
    assets::ImageData image = run.pixels(video_ ? video_->spare() : assets::ImageData{});
    if (!folder_.empty()) {
        const Result<Done> written = assets::write_png(folder_ / name_of_frame(++count_), image);
        if (!written) return written;
    }
    if (video_ && !video_->add(std::move(image))) return video_->finish();
    return Done{};
}

Result<Done> FrameFiles::close() {
    return video_ ? video_->finish() : Done{};
}

}  // namespace plumbline::game
