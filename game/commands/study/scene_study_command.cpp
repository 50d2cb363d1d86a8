#include "game/commands/study/scene_study_command.h"

#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/study/auto_preset/study_cache.h"
#include "engine/study/machine.h"
#include "engine/study/progress.h"
#include "game/commands/study/saved_start.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

namespace plumbline::game {
namespace {

Result<scene::OpenedScene> opened(const std::filesystem::path& scene) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    Diagnostics faults;
    Result<scene::OpenedScene> opened = scene::open_scene(scene, {.folders = *folders}, faults);
    log_faults(faults);
    return opened;
}

/// The kept one serves where it is whole and of the asked-for length.
std::optional<study::SceneStudy> kept_study(const SceneStudyCommand& command,
                                            const std::filesystem::path& folder,
                                            const study::StudyKey& key) {
    if (!command.engines.empty() || !command.threads.empty() || !command.load_file.empty())
        return {};
    if (!command.wish.tolerance && !command.wish.budget_ms) return {};
    std::optional<study::CachedStudy> kept = study::find_study(folder, key);
    if (!kept || kept->grid != study::GridSize::Full || kept->study.from_s > 0) return {};
    if (command.seconds && std::abs(*command.seconds - kept->study.seconds) > 1e-3) return {};
    std::cerr << fmt::format("from the cached study {}\n", kept->made_on);
    return std::move(kept->study);
}

void print(const SceneStudyCommand& command, const study::SceneStudy& study) {
    if (!study.complete) std::cout << "Interrupted: partial results.\n";
    if (command.wish.tolerance || command.wish.budget_ms) {
        std::cout << study::wish_text(study, command.wish);
    } else {
        std::cout << study::scene_study_text(study);
    }
    std::cout << std::flush;
}

}  // namespace

Result<study::SceneStudy> run_scene_study(const SceneStudyCommand& command) {
    const Result<scene::OpenedScene> scene = opened(command.scene);
    if (!scene) return scene.error();
    const study::StudyKey key = study::study_key(*scene);
    const std::filesystem::path folder = study::study_cache_folder();
    if (std::optional<study::SceneStudy> kept = kept_study(command, folder, key)) {
        print(command, *kept);
        return std::move(*kept);
    }
    std::optional<study::SceneStart> start;
    if (!command.load_file.empty()) {
        Result<study::SceneStart> saved = saved_start(command.load_file, command.scene);
        if (!saved) return saved.error();
        start = std::move(*saved);
    }
    Result<study::SceneStudy> made = [&] {
        study::ProgressBar bar(study::ProgressBar::Shown::Yes);
        return study::study_scene({.scene = command.scene,
                                   .start = start,
                                   .seconds = command.seconds,
                                   .workers = {.count = study::default_workers()},
                                   .engines = command.engines,
                                   .threads = command.threads,
                                   .progress = [&](const study::StudyProgress& progress) {
                                       bar.show(progress.share, progress.left_s);
                                   }});
    }();
    if (!made) return made;
    print(command, *made);
    if (!made->complete || made->subject.points.empty()) return made;
    const Result<Done> kept = study::keep_study(
        folder,
        key,
        {.study = *made, .grid = study::GridSize::Full, .made_on = study::today_text()});
    if (!kept) log_warning("the study could not be cached: {}", kept.error().message);
    return made;
}

}  // namespace plumbline::game
