// Small images of end states, by `plumbline render` in child processes: a machine without OpenGL, or
// a driver that crashes, costs the images and nothing else.
#include "engine/core/io/files.h"
#include "engine/core/io/scratch_folder.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/process/process.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kImageBytes = 4 * 1024 * 1024;
constexpr double kLongestDrawing_s = 0.2;  // until the interrupt flag is looked at again

/// A child that draws one case.
struct Drawing {
    ChildProcess process;
    std::size_t entry;
    fs::path file;
};

Result<Drawing> start_drawing(const StabilityTable& table,
                              std::size_t entry,
                              const fs::path& folder,
                              const std::string& size) {
    const CaseEntry& drawn = table.cases[entry];
    const fs::path file = folder / (drawn.hard.id + ".png");
    Result<ChildProcess> process =
        ChildProcess::start({.program = sibling_programs().float32,
                             .arguments = {"render",
                                           drawn.scene.string(),
                                           "--at",
                                           fmt::format("{}", drawn.hard.seconds),
                                           "--size",
                                           size,
                                           "--out",
                                           file.string(),
                                           "--quiet"},
                             .own_group = true});
    if (!process) return process.error();
    return Drawing{std::move(*process), entry, file};
}

/// Waits until one of them has closed its pipe; false when interrupted.
bool wait_for_any(std::vector<Drawing>& drawings, std::size_t& which) {
    while (!interrupted()) {
        std::vector<const ChildProcess*> children;
        for (const Drawing& drawing : drawings) children.push_back(&drawing.process);
        const std::vector<bool> ready = wait_for_output(children, kLongestDrawing_s);
        for (which = 0; which < ready.size(); ++which) {
            std::string ignored;
            if (ready[which] && !drawings[which].process.receive(ignored)) return true;
        }
    }
    return false;
}

void draw_all(StabilityTable& table, int workers, const fs::path& folder, const std::string& size) {
    std::vector<Drawing> drawings;
    std::size_t next = 0;
    while (next < table.cases.size() || !drawings.empty()) {
        while (next < table.cases.size() && std::ssize(drawings) < std::max(1, workers)) {
            Result<Drawing> started = start_drawing(table, next++, folder, size);
            if (!started) {
                table.no_images = started.error().message;
                return;
            }
            drawings.push_back(std::move(*started));
        }
        std::size_t which = 0;
        if (!wait_for_any(drawings, which)) return;
        Drawing& drawing = drawings[which];
        // The pipe closes when it exits; the file was put in place, whole, before.
        const std::string how = drawing.process.end().words;
        Result<std::string> png = read_file(drawing.file, kImageBytes);
        if (png) {
            table.images[drawing.entry] = std::move(*png);
        } else if (std::ranges::all_of(table.images, &std::string::empty)) {
            table.no_images = fmt::format("no images: plumbline render {}", how);
            return;
        }
        drawings.erase(drawings.begin() + static_cast<std::ptrdiff_t>(which));
    }
}

}  // namespace

void take_images(StabilityTable& table, int workers, int width_px, int height_px) {
    const Result<ScratchFolder> folder = ScratchFolder::make("images");
    if (!folder) {
        table.no_images = "no images: " + folder.error().message;
        return;
    }
    draw_all(table, workers, folder->path(), fmt::format("{}x{}", width_px, height_px));
}

}  // namespace plumbline::study
