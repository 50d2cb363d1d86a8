// The images of the asset library while they are decoded. Private to engine/assets.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace plumbline::assets {
namespace fs = std::filesystem;

inline Error out_of_memory(std::string_view kind, const fs::path& file) {
    return {.message = fmt::format("there is not enough memory for {} {}", kind, file.string()),
            .exit_code = ExitCode::Refused};
}

/// Whether it did not come with the program; nothing does, and nothing else either, without a folder.
inline bool is_foreign(const fs::path& file, const fs::path& installed) {
    return !installed.empty() && !is_inside(installed, file);
}

/// Images being decoded, and the threads that do it. What stands before `workers` is guarded by
/// `mutex`; the rest belongs to the library's own thread.
struct AssetLibrary::Images {
    using Pixels = std::shared_ptr<const Result<ImageData>>;

    fs::path installed;  ///< set before any other thread knows this

    std::mutex mutex;
    std::condition_variable work_added;
    std::condition_variable image_ready;
    std::deque<fs::path> waiting;
    std::set<fs::path> in_work;
    std::map<fs::path, Pixels> ready;
    std::map<fs::path, std::shared_ptr<const std::string>> embedded;  // by EmbeddedImage::name
    std::set<fs::path> warned;
    bool closing{false};

    std::map<fs::path, std::size_t> decoded_bytes;  // of every image decoded so far
    std::size_t decoded_sum{0};

    std::vector<std::thread> workers;
    std::set<fs::path> prefetched;  // ever, so that a second call does not decode again

    ~Images() {
        {
            const std::lock_guard lock(mutex);
            closing = true;
        }
        work_added.notify_all();
        for (std::thread& worker : workers) worker.join();
    }

    void work() {
        std::unique_lock lock(mutex);
        while (true) {
            work_added.wait(lock, [this] { return closing || !waiting.empty(); });
            if (closing) return;
            const fs::path file = std::move(waiting.front());
            waiting.pop_front();
            in_work.insert(file);
            lock.unlock();
            Pixels pixels = decode(file);
            lock.lock();
            in_work.erase(file);
            ready.emplace(file, std::move(pixels));
            image_ready.notify_all();
        }
    }

    /// Counts the image's bytes among the scene's; once, however often it is decoded. False when
    /// there is no room for it.
    bool count_bytes(const fs::path& file, std::size_t bytes) {
        const std::lock_guard lock(mutex);
        std::size_t& counted = decoded_bytes[file];
        const std::size_t others = decoded_sum - counted;
        const bool fits = bytes <= limits::kSceneImageBytes - others;
        counted = fits ? bytes : 0;
        decoded_sum = others + counted;
        return fits;
    }

    /// From the model file that holds it, or from its own; without the lock.
    Pixels decode(const fs::path& file);

    /// The result if it is ready or being made; null if nobody has begun.
    Pixels claim(const fs::path& file) {
        std::unique_lock lock(mutex);
        const auto place = std::find(waiting.begin(), waiting.end(), file);
        if (place != waiting.end()) {
            waiting.erase(place);  // whoever asks has time to decode it himself
            return nullptr;
        }
        image_ready.wait(lock, [&] { return !in_work.contains(file); });
        const auto found = ready.find(file);
        if (found == ready.end()) return nullptr;
        Pixels pixels = std::move(found->second);
        ready.erase(found);
        return pixels;
    }
};

}  // namespace plumbline::assets
