#include "engine/study/auto_preset/auto_accuracy.h"

#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::study {
namespace {

constexpr double kCalibration_s = 9.0;
constexpr double kCalibrationMost_s = 40.0;
/// A study of less of the scene may not have seen the first thing land.
constexpr double kSecondsLeast = 1.0;

Wish wish_of(const scene::Accuracy& accuracy) {
    return {.tolerance = accuracy.tolerance, .budget_ms = accuracy.budget_ms};
}

std::string wish_words(const scene::Accuracy& accuracy) {
    if (accuracy.budget_ms) return fmt::format("{:g} ms a frame", *accuracy.budget_ms);
    return fmt::format("{:g} %", 100.0 * accuracy.tolerance.value_or(kUsualTolerance));
}

/// Whether a setting is what the file says beside the preset.
bool agrees(const Setting& setting, const scene::Accuracy& asked) {
    const scene::SimulationOverrides own = overrides(setting);
    return (!asked.step_hz_given || setting.step_hz == asked.step_hz) &&
           (!asked.solver_given || setting.solver == asked.solver) &&
           (!asked.substeps || own.substeps == asked.substeps) &&
           (!asked.substeps_max || own.substeps_max == asked.substeps_max) &&
           (!asked.iterations || own.iterations == asked.iterations);
}

Result<SceneStudy> calibrate(const scene::SceneDescription& description) {
    log_note(
        "{}: preset \"auto\" looks for the cheapest setting that serves; this takes some {:.0f} s "
        "once, up to {:.0f} s where there is much to simulate",
        description.file.filename().string(),
        kCalibration_s,
        kCalibrationMost_s);
    return study_scene({.scene = description.file,
                        .grid = GridSize::Quick,
                        .wall_s = kCalibration_s,
                        .least_seconds = kSecondsLeast,
                        .workers = {.count = default_workers()}});
}

/// Kept, or made now.
Result<SceneStudy> study_of(const scene::OpenedScene& scene) {
    const scene::SceneDescription& description = scene.description;
    const StudyKey key = study_key(scene);
    const std::filesystem::path folder = study_cache_folder();
    if (std::optional<CachedStudy> kept = find_study(folder, key)) return std::move(kept->study);
    const std::vector<Setting> grid = scene_grid(GridSize::Quick);
    const auto fits = [&](const Setting& each) { return agrees(each, description.accuracy); };
    if (std::ranges::none_of(grid, fits))
        return Error{.message =
                         "of the settings that it tries none is as the rest of [accuracy] "
                         "or the command line asks"};
    Result<SceneStudy> made = calibrate(description);
    if (!made) return made;
    if (!made->complete) return Error{.message = "it was interrupted"};
    const CachedStudy cached{.study = *made, .grid = GridSize::Quick, .made_on = today_text()};
    if (const Result<Done> kept = keep_study(folder, key, cached); !kept)
        log_warning("the study is not kept: {}", kept.error().message);
    return made;
}

}  // namespace

std::optional<AutoChoice> auto_choice(const SceneStudy& study, const scene::Accuracy& asked) {
    SceneStudy open = study;
    std::erase_if(open.subject.points,
                  [&](const Point& point) { return !agrees(point.setting, asked); });
    const std::optional<Choice> choice = choose(open, wish_of(asked));
    if (!choice) return {};
    AutoChoice chosen{
        .accuracy = asked, .point = open.subject.points[choice->point], .met = choice->met};
    const scene::SimulationOverrides own = overrides(chosen.point.setting);
    chosen.accuracy.solver = chosen.point.setting.solver;
    chosen.accuracy.step_hz = chosen.point.setting.step_hz;
    chosen.accuracy.substeps = own.substeps;
    chosen.accuracy.substeps_max = own.substeps_max;
    chosen.accuracy.iterations = own.iterations;
    chosen.accuracy.fidelity = chosen.point.setting.fidelity;
    return chosen;
}

Result<scene::Accuracy> studied_accuracy(const scene::OpenedScene& scene) {
    const scene::Accuracy& asked = scene.description.accuracy;
    const Result<SceneStudy> study = study_of(scene);
    if (!study) return study.error();
    if (study->seconds < kSecondsLeast)
        return Error{.message =
                         fmt::format("there was time for {:.2f} s of it only; `plumbline study` of "
                                     "this scene takes longer and sees more",
                                     study->seconds)};
    const std::optional<AutoChoice> choice = auto_choice(*study, asked);
    if (!choice) return Error{.message = "no setting that it could choose got through the scene"};
    if (choice->met) {
        log_note("preset \"auto\" for {}: {}", wish_words(asked), point_text(choice->point));
    } else {
        log_warning("preset \"auto\" found nothing within {}; the best it saw is {}",
                    wish_words(asked),
                    point_text(choice->point));
    }
    return choice->accuracy;
}

}  // namespace plumbline::study
