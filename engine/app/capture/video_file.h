// Images to a film, by ffmpeg where it is installed, on a thread of its own.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/process/process.h"
#include "engine/core/result.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace plumbline::app {

struct VideoDef {
    std::filesystem::path file;  ///< its name's ending says the kind: .mp4
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    int frames_per_s{60};
    /// Images come as they are drawn, frames_per_s at most, and each is shown until the next one came.
    /// Else each is shown for 1 / frames_per_s.
    bool live{false};
};

/// However it ends, what was written until then plays: the film is in fragments of half a second. A film
/// that was there before stays until the new one is whole.
class VideoFile {
public:
    /// The error (exit code 1) says that ffmpeg is not there, or that the file cannot be written.
    static Result<std::unique_ptr<VideoFile>> start(const VideoDef& def);
    /// A film that finish() did not end is not whole: one that was there before stays.
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    const VideoDef& def() const { return def_; }
    /// A few images wait at most; then this one has to, or be left out.
    bool is_full() const;
    /// One that was shown, for its memory; an empty one where there is none.
    assets::ImageData spare();
    /// Shows an RGB image of the film's size. False, without waiting, once nobody reads them any
    /// more: finish() says why.
    bool add(assets::ImageData image);
    /// Waits for what is still to be written. The error tells what went wrong, and that what was
    /// written plays.
    Result<Done> finish();

private:
    VideoFile(const VideoDef& def, std::filesystem::path written, ChildProcess ffmpeg);
    void write_images();
    bool replaces() const { return written_ != def_.file; }
    void remove_written() const;
    ChildEnd end();

    VideoDef def_;
    std::filesystem::path written_;  ///< by ffmpeg: the file, or one beside it that replaces it
    ChildProcess ffmpeg_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<assets::ImageData> waiting_;
    assets::ImageData shown_;
    bool ended_{false};   ///< no more will come
    bool broken_{false};  ///< ffmpeg reads no more
    std::thread writer_;  // last: it uses all the others
};

}  // namespace plumbline::app
