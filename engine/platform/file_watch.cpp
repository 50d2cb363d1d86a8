#include "engine/platform/file_watch.h"

#include "engine/core/log.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <string>

namespace plumbline::platform {
namespace fs = std::filesystem;
namespace {

constexpr double kSettle_s = 0.15;
constexpr double kLook_s = 1.0;  // for folders that are not there, or no longer the same
constexpr std::uint32_t kFolderEvents = IN_CLOSE_WRITE | IN_MODIFY | IN_CREATE | IN_DELETE |
                                        IN_MOVED_FROM | IN_MOVED_TO | IN_ATTRIB | IN_DELETE_SELF |
                                        IN_MOVE_SELF;
constexpr std::uint32_t kFolderGone = IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED;

/// What a file looks like from outside: enough to know that it is another one now.
struct Observation {
    bool exists{false};
    std::uintmax_t bytes{0};
    fs::file_time_type written{};

    friend bool operator==(const Observation&, const Observation&) = default;
};

Observation observe(const fs::path& path) {
    std::error_code error;
    Observation observed;
    observed.exists = fs::exists(path, error);
    if (!observed.exists) return observed;
    if (fs::is_regular_file(path, error)) observed.bytes = fs::file_size(path, error);
    observed.written = fs::last_write_time(path, error);
    return observed;
}

struct WatchedFile {
    fs::path path;    ///< as it was asked for
    fs::path folder;  ///< absolute
    std::string name;
    Observation seen;
    double changed_s{0.0};
    bool changed{false};
};

}  // namespace

struct FileWatch::Impl {
    std::vector<WatchedFile> files;
    std::map<int, fs::path> folder_by_watch;
    std::set<fs::path> folders_watched;
    int inotify{-1};
    double next_look_s{0.0};

    void watch_folders();
    void read_events(double now_s);
    void on_event(const inotify_event& event, std::string_view name, double now_s);
    void mark(WatchedFile& file, double now_s);
    void look_around(double now_s);
};

void FileWatch::Impl::watch_folders() {
    if (inotify < 0) return;
    for (const WatchedFile& file : files) {
        if (folders_watched.contains(file.folder)) continue;
        const int watch = inotify_add_watch(inotify, file.folder.c_str(), kFolderEvents);
        if (watch < 0) continue;  // not there yet: looked for again
        folder_by_watch[watch] = file.folder;
        folders_watched.insert(file.folder);
    }
}

void FileWatch::Impl::mark(WatchedFile& file, double now_s) {
    file.changed = true;
    file.changed_s = now_s;
}

void FileWatch::Impl::on_event(const inotify_event& event, std::string_view name, double now_s) {
    if ((event.mask & IN_Q_OVERFLOW) != 0) {
        for (WatchedFile& file : files) mark(file, now_s);
        return;
    }
    const auto folder = folder_by_watch.find(event.wd);
    if (folder == folder_by_watch.end()) return;
    for (WatchedFile& file : files) {
        if (file.folder != folder->second) continue;
        if (file.name == name || (event.mask & kFolderGone) != 0) mark(file, now_s);
    }
    if ((event.mask & kFolderGone) != 0) {
        folders_watched.erase(folder->second);
        if ((event.mask & IN_IGNORED) == 0) inotify_rm_watch(inotify, event.wd);
        folder_by_watch.erase(folder);
        next_look_s = now_s;
    }
}

void FileWatch::Impl::read_events(double now_s) {
    alignas(inotify_event) std::array<char, 16 * 1024> buffer{};
    while (inotify >= 0) {
        const ssize_t length = ::read(inotify, buffer.data(), buffer.size());
        if (length <= 0) return;
        std::size_t at = 0;
        while (at + sizeof(inotify_event) <= static_cast<std::size_t>(length)) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof(event));
            const char* text = buffer.data() + at + sizeof(event);
            const std::string_view name = event.len == 0
                                              ? std::string_view{}
                                              : std::string_view{text, ::strnlen(text, event.len)};
            on_event(event, name, now_s);
            at += sizeof(event) + event.len;
        }
    }
}

// Once a second, for what inotify cannot tell: folders that come into being, file systems without
// events, links that point elsewhere.
void FileWatch::Impl::look_around(double now_s) {
    if (now_s < next_look_s) return;
    next_look_s = now_s + kLook_s;
    watch_folders();
    for (WatchedFile& file : files)
        if (!file.changed && !(observe(file.path) == file.seen)) mark(file, now_s);
}

FileWatch::FileWatch(const std::vector<fs::path>& files) : impl_(std::make_unique<Impl>()) {
    impl_->inotify = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (impl_->inotify < 0)
        log_note("file changes are looked for once a second ({})", std::strerror(errno));
    for (const fs::path& path : files) {
        std::error_code error;
        const fs::path absolute = fs::absolute(path, error);
        impl_->files.push_back({.path = path,
                                .folder = absolute.parent_path(),
                                .name = absolute.filename().string(),
                                .seen = observe(path)});
    }
    impl_->watch_folders();
}

FileWatch::~FileWatch() {
    if (impl_->inotify >= 0) ::close(impl_->inotify);
}

std::vector<fs::path> FileWatch::take_changed(double now_s) {
    impl_->read_events(now_s);
    impl_->look_around(now_s);
    std::vector<fs::path> changed;
    for (WatchedFile& file : impl_->files) {
        if (!file.changed || now_s - file.changed_s < kSettle_s) continue;
        file.changed = false;
        const Observation now = observe(file.path);
        // Touched and put back the same, or gone before it was there: nothing to read again.
        if (now == file.seen) continue;
        file.seen = now;
        changed.push_back(file.path);
    }
    return changed;
}

}  // namespace plumbline::platform
