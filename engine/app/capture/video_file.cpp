#include "engine/app/capture/video_file.h"

#include "engine/core/io/files.h"
#include "engine/core/io/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::size_t kMostWaiting = 4;
constexpr double kGrace_s = 20;

bool is_installed(std::string_view program) {
    const char* path = std::getenv("PATH");
    std::string_view rest = path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        std::error_code failed;
        const std::filesystem::path folder(rest.substr(0, end));
        if (!folder.empty() && std::filesystem::is_regular_file(folder / program, failed))
            return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

std::vector<std::string> words_for(const VideoDef& def, const std::filesystem::path& written) {
    const std::string rate = fmt::format("{}", def.frames_per_s);
    // What comes: bare images, one after the other; by the clock, or at an even pace.
    std::vector<std::string> words{"-loglevel", "error", "-y", "-f", "rawvideo"};
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more);
    };
    if (def.live) add({"-use_wallclock_as_timestamps", "1", "-framerate", rate});
    if (!def.live) add({"-r", rate});
    add({"-pix_fmt", "rgb24", "-s", fmt::format("{}x{}", def.width_px, def.height_px), "-i", "-"});
    if (def.live) add({"-fps_mode", "vfr"});
    // H.264 wants even sides; the least work a frame, as we draw meanwhile.
    add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-preset", "ultrafast"});
    add({"-crf", "20", "-pix_fmt", "yuv420p", "-g", fmt::format("{}", def.frames_per_s / 2)});
    // A file in fragments, each of which plays by itself; no name is taken for an option or an address.
    add({"-movflags", "frag_keyframe+empty_moov+default_base_moof", "file:" + written.string()});
    return words;
}

enum class Left { Nothing, Part, All };

/// Cuts off a fragment that was begun and not finished: players stumble over half of one. An MP4 file
/// is a row of boxes, each a length of four bytes and a name of four; a fragment is a `moof`, which
/// says what is in the `mdat` behind it. Other kinds of files stay as they are. Says what is left.
Left keep_whole_fragments(const std::filesystem::path& file) {
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    if (failed || size == 0) return Left::Nothing;
    std::ifstream stream(file, std::ios::binary);
    std::uintmax_t whole = 0;
    bool has_images = false;
    std::array<char, 8> head{};
    for (std::uintmax_t at = 0; stream.read(head.data(), head.size());) {
        const std::string_view name(&head[4], 4);
        if (at == 0 && name != "ftyp") return Left::All;
        std::uintmax_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8U | static_cast<unsigned char>(head[i]);
        if (length < head.size() || length > size - at) break;
        at += length;
        if (name != "moof") whole = at;
        has_images = has_images || name == "mdat";
        stream.seekg(static_cast<std::streamoff>(at));
    }
    if (!has_images) return Left::Nothing;
    if (whole == size) return Left::All;
    std::filesystem::resize_file(file, whole, failed);
    return Left::Part;
}

/// How it ended, with what it said first: later lines follow from that.
std::string words_of(const ChildEnd& end) {
    const std::string said = end.said.substr(0, end.said.find('\n'));
    return said.empty() ? end.words : fmt::format("{} ({})", end.words, said);
}

}  // namespace

Result<std::unique_ptr<VideoFile>> VideoFile::start(const VideoDef& def) {
    if (!is_installed("ffmpeg")) {
        return Error{
            "films are written by ffmpeg, which is not installed (package ffmpeg); "
            "images can be had without: render --frames N --out FOLDER"};
    }
    if (const Result<Done> open = check_output(def.file); !open) return open.error();
    std::filesystem::path written = def.file;
    std::error_code failed;
    if (std::filesystem::is_regular_file(def.file, failed)) {
        const Result<std::filesystem::path> beside = make_file_beside(def.file);
        if (!beside) return beside.error();
        written = *beside;
    }
    Result<ChildProcess> ffmpeg = ChildProcess::start({.program = "ffmpeg",
                                                       .arguments = words_for(def, written),
                                                       .own_group = true,
                                                       .tells_us = true});
    if (!ffmpeg) return ffmpeg.error();
    return std::unique_ptr<VideoFile>(new VideoFile(def, std::move(written), std::move(*ffmpeg)));
}

VideoFile::VideoFile(const VideoDef& def, std::filesystem::path written, ChildProcess ffmpeg)
    : def_(def),
      written_(std::move(written)),
      ffmpeg_(std::move(ffmpeg)),
      writer_([this] { write_images(); }) {}

VideoFile::~VideoFile() {
    if (ended_) return;
    static_cast<void>(end());
    if (replaces()) remove_written();
}

void VideoFile::remove_written() const {
    std::error_code ignored;
    std::filesystem::remove(written_, ignored);
}

bool VideoFile::is_full() const {
    const std::scoped_lock lock(mutex_);
    return !broken_ && waiting_.size() >= kMostWaiting;
}

assets::ImageData VideoFile::spare() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(shown_, {});
}

bool VideoFile::add(assets::ImageData image) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return broken_ || waiting_.size() < kMostWaiting; });
    if (broken_ || ended_) return false;
    waiting_.push_back(std::move(image));
    changed_.notify_all();
    return true;
}

void VideoFile::write_images() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        assets::ImageData image = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        const std::string_view text(reinterpret_cast<const char*>(image.bytes.data()),
                                    image.bytes.size());
        const bool read = ffmpeg_.send(text);
        lock.lock();
        shown_ = std::move(image);
        if (read) continue;
        broken_ = true;
        changed_.notify_all();
        return;
    }
}

ChildEnd VideoFile::end() {
    {
        const std::scoped_lock lock(mutex_);
        ended_ = true;
        changed_.notify_all();
    }
    writer_.join();
    ffmpeg_.close_input();
    return ffmpeg_.end(kGrace_s);
}

Result<Done> VideoFile::finish() {
    if (ended_) return Done{};
    const ChildEnd end = this->end();
    const Left left = keep_whole_fragments(written_);
    // A disk that is full at the very end is no failure to ffmpeg.
    if (end.good && !broken_ && left != Left::Part)
        return replaces() ? replace_by(def_.file, written_) : Done{};
    const std::string words = end.words.empty() ? "read no more" : words_of(end);
    if (replaces()) {
        remove_written();
        return Error{fmt::format("the film {} was not written: ffmpeg {}; the earlier one stays",
                                 def_.file.string(),
                                 words)};
    }
    if (left == Left::Nothing) {
        std::error_code failed;
        if (std::filesystem::is_regular_file(written_, failed)) remove_written();
        return Error{
            fmt::format("the film {} was not written: ffmpeg {}", def_.file.string(), words)};
    }
    return Error{
        fmt::format("the film {} is not whole: ffmpeg {}; what was written until then plays",
                    def_.file.string(),
                    words)};
}

}  // namespace plumbline::app
