#include "engine/study/scenes/scene_study.h"

#include "engine/core/io/scratch_folder.h"
#include "engine/core/log.h"
#include "engine/study/findings/order.h"
#include "engine/study/findings/pareto.h"
#include "engine/study/played_scene.h"
#include "engine/study/scenes/run_costs.h"
#include "engine/study/scenes/scene_reference.h"
#include "engine/study/scenes/scene_threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plumbline::study {
namespace {

constexpr double kSeconds = 3.0;
constexpr int kLeastSamples = 6;  // 0.2 s
constexpr int kMoments = 5;
constexpr double kWall_s = 50.0;
constexpr double kWallMany_s = 120.0;
constexpr std::size_t kManyBodies = 500;
constexpr double kReferenceShare = 0.45;
/// What is kept free for runs that take longer than foretold.
constexpr double kReserve = 0.85;
/// Settings of the front that effects at other fidelities are tried with.
constexpr std::size_t kFidelitiesOf = 4;
/// Of the time that is left, what is spent before others follow; and how much longer it all may take then.
constexpr double kShare = 0.5;
constexpr double kWithFidelities = 1.5;
/// How much longer it may take for the least of the scene that was asked for.
constexpr double kLonger = 3;
/// CPU time that another engine's run may take: at least, and times what ours took.
constexpr double kEngineLeast_s = 10;
constexpr double kEngineFactor = 30;
/// Its cost predicts the cost of the other rates.
constexpr int kFirst_hz = 60;
/// Measured even where the time is over.
constexpr std::size_t kSettingsLeast = 4;

/// Fixed times, in samples: a fifth of the run each.
std::vector<int> moments_of(int samples) {
    std::vector<int> moments;
    for (int i = 1; i <= kMoments; ++i) {
        const int sample = std::max(1, samples * i / kMoments);
        if (moments.empty() || sample > moments.back()) moments.push_back(sample);
    }
    return moments;
}

class SceneStudyMaker {
public:
    explicit SceneStudyMaker(const SceneStudyOptions& options)
        : options_(options),
          plan_(options.wall_s.value_or(kWall_s), options.workers, options.progress) {}

    Result<SceneStudy> make() {
        if (const Result<Done> there = check_programs(); !there) return there.error();
        if (const Result<Done> done = load_title(); !done) return done.error();
        if (const Result<Done> done = keep_start(); !done) return done.error();
        if (const Result<Done> done = probe(); !done) return done.error();
        if (plan_.interrupted()) return finish();
        Result<std::optional<SceneReference>> reference =
            make_reference(plan_, probe_, kReferenceShare, [&](const SceneReference& rough) {
                return measure_roughly(rough);
            });
        if (!reference) return Error{reference.error().message, ExitCode::Refused};
        if (!*reference) return finish();
        compare_with(std::move(**reference));
        if (const Result<Done> done = measure_grid(); !done) return done.error();
        if (const Result<Done> done = measure_engines(); !done) return done.error();
        Result<std::vector<ThreadsPoint>> threads =
            measure_threads(plan_, probe_, options_.threads);
        if (!threads) return threads.error();
        study_.subject.threads = std::move(*threads);
        return finish();
    }

private:
    Result<Done> load_title() {
        const Result<scene::OpenedScene> opened = open_for_study(options_.scene);
        if (!opened) return opened.error();
        const std::string& title = opened->description.title;
        study_.subject.id = options_.scene.string();
        study_.subject.title = title.empty() ? options_.scene.stem().string() : title;
        return Done{};
    }

    Result<Done> keep_start() {
        if (!options_.start) return Done{};
        Result<ScratchFolder> folder = ScratchFolder::make("study");
        if (!folder) return folder.error();
        folder_ = std::move(*folder);
        probe_.start = folder_->path() / "start";
        study_.from_s = options_.start->time_s;
        return write_start(probe_.start, *options_.start);
    }

    /// How much of the scene's time the plan has time for.
    int affordable_samples(double second_cpu_s, int wanted) {
        const double cpu_s = second_cpu_s * guessed_cost_of_study(options_.grid);
        plan_.extend_for((options_.least_seconds + kSampleEvery_s) * cpu_s / kReserve, kLonger);
        const double affordable_s = kReserve * plan_.cpu_left_s() / std::max(1e-9, cpu_s);
        const int samples = static_cast<int>(std::min(1e6, affordable_s / kSampleEvery_s));
        return std::clamp(samples, std::min(kLeastSamples, wanted), wanted);
    }

    /// One run at 60 Hz: what there is, and what a second of it costs.
    Result<Done> probe() {
        const double seconds = options_.seconds.value_or(kSeconds);
        const int wanted = std::max(1, static_cast<int>(std::lround(seconds / kSampleEvery_s)));
        const SceneRun run{.scene = options_.scene,
                           .start = probe_.start,
                           .moments = moments_of(wanted),
                           .cpu_limit_s = 0.08 * plan_.left_s()};
        ScenePlan::Finished first;
        const Result<Done> done = plan_.run(
            std::vector{run}, [&](const ScenePlan::Finished& finished) { first = finished; });
        if (!done || plan_.interrupted()) return done;
        if (first.status == RunStatus::Refused)
            return Error{.message = first.why, .exit_code = ExitCode::Refused};
        if (first.status != RunStatus::Done)
            return Error{.message = fmt::format("{}: the first run came to no end: {}",
                                                options_.scene.string(),
                                                first.why)};
        const SceneAnswer& answer = first.answer;
        if (!options_.wall_s && answer.bodies > kManyBodies) plan_.extend(kWallMany_s);
        probe_.scene = options_.scene;
        probe_.effects = answer.effects;
        if (!answer.effects.empty())
            plan_.extend(kWithFidelities * (plan_.left_s() + plan_.spent_s()));
        probe_.second_cpu_s = std::max(1e-6, answer.cost.ms_per_s_min * 1e-3);
        const int samples = affordable_samples(probe_.second_cpu_s, wanted);
        if (samples < wanted)
            study_.subject.notes.push_back(fmt::format(
                "{:.2f} s instead of {:.2f} s of the scene: {} bodies, {:.3g} ms of CPU "
                "time for a second at 60 Hz",
                samples * kSampleEvery_s,
                seconds,
                answer.bodies,
                answer.cost.ms_per_s_min));
        probe_.moments = moments_of(samples);
        study_.seconds = samples * kSampleEvery_s;
        costs_.emplace(study_.subject.points, probe_.second_cpu_s, study_.seconds);
        set_up_ =
            fmt::format("{} bodies, {} joints, {:.2f} s{}",
                        answer.bodies,
                        answer.joints,
                        study_.seconds,
                        options_.start ? fmt::format(" from {:.2f} s on", study_.from_s) : "");
        return Done{};
    }

    SceneRun run_of(const Setting& setting) const {
        const RunCounts& counts = costs_->counts;
        SceneRun run{.scene = options_.scene,
                     .start = probe_.start,
                     .setting = setting,
                     .moments = probe_.moments};
        if (counts.chaotic) {
            run.copies = counts.copies;
            run.seed = 1001;  // others than the reference's
            run.shift_m = reference_->shift_m;
        } else {
            run.repeats = counts.repeats;
            run.repeat_s = counts.repeat_s;
        }
        run.cpu_limit_s = std::max(2.0, 5.0 * costs_->of_one_s(setting));
        return run;
    }

    /// Settings that are worth a first look, against a reference that will become better. Their answers are kept.
    Result<Done> measure_roughly(const SceneReference& rough) {
        reference_ = rough;
        describe();
        const std::vector<Setting> grid = scene_grid(options_.grid);
        costs_->fit(grid, kReserve * plan_.cpu_left_s());
        std::vector<Setting> first = scene_grid(GridSize::Quick);
        std::erase_if(first, [&](const Setting& each) { return each.step_hz != kFirst_hz; });
        plan_.expect(costs_->sum_s(grid) + plan_.cpu_left_s(kReferenceShare));
        return measure(fitting(first), [&](const ScenePlan::Finished& finished) {
            first_answers_.push_back(finished);
        });
    }

    /// From now on; and those that were measured before, where they can be.
    void compare_with(SceneReference reference) {
        reference_ = std::move(reference);
        describe();
        std::vector<Point>& points = study_.subject.points;
        if (reference_->chaotic) points.clear();  // copies are needed
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = point_of(points[i].setting, first_answers_[i]);
        costs_->counts = {.chaotic = reference_->chaotic};
        tell();
    }

    void tell() const {
        if (options_.tell) options_.tell(study_);
    }

    /// Those of `settings` that fit into a share of the time that is left, cheapest first.
    std::vector<Setting> fitting(std::vector<Setting> settings, double share = 1) {
        std::ranges::stable_sort(
            settings, {}, [&](const Setting& each) { return costs_->of_all_s(each); });
        double sum_s = 0;
        std::size_t fit = 0;
        const double left_s = share * kReserve * plan_.cpu_left_s();
        const std::size_t least = study_.subject.points.empty() ? kSettingsLeast : 0;
        while (fit < settings.size() &&
               (fit < least || sum_s + costs_->of_all_s(settings[fit]) <= left_s))
            sum_s += costs_->of_all_s(settings[fit++]);
        left_out_ += settings.size() - fit;
        settings.resize(fit);
        return settings;
    }

    /// A few at a time, so that a machine that turns slow ends it in time all the same.
    Result<Done> measure(const std::vector<Setting>& settings,
                         const std::function<void(const ScenePlan::Finished&)>& look = {}) {
        constexpr std::size_t kAtATime = 8;
        for (std::size_t first = 0; first < settings.size(); first += kAtATime) {
            const std::size_t end = std::min(first + kAtATime, settings.size());
            if (plan_.left_s() <= 0 && !study_.subject.points.empty()) {
                left_out_ += settings.size() - first;
                break;
            }
            std::vector<SceneRun> runs;
            for (std::size_t i = first; i < end; ++i) runs.push_back(run_of(settings[i]));
            const Result<Done> done = plan_.run(runs, [&](const ScenePlan::Finished& finished) {
                study_.subject.points.push_back(point_of(settings[first + finished.run], finished));
                if (look) look(finished);
                tell();
            });
            if (!done) return done;
        }
        return Done{};
    }

    Result<Done> measure_grid() {
        std::vector<Setting> grid = scene_grid(options_.grid);
        std::erase_if(grid, [&](const Setting& each) { return is_measured(each); });
        costs_->fit(grid, kReserve * plan_.cpu_left_s());
        std::vector<Setting> first;
        std::vector<Setting> rest;
        for (const Setting& setting : grid)
            (setting.step_hz == kFirst_hz ? first : rest).push_back(setting);
        expect(grid);
        Result<Done> done = measure(fitting(first));
        if (done) done = measure(fitting(other_fidelities(), kShare));
        if (!done) return done;
        rest = fitting(rest, probe_.effects.empty() ? 1.0 : kShare);
        expect(rest);
        done = measure(rest);
        return done ? measure(fitting(other_fidelities())) : done;
    }

    /// Some settings that no other beats, evenly along their front.
    std::vector<Setting> other_fidelities() const {
        std::vector<Setting> all;
        if (probe_.effects.empty()) return all;
        const std::vector<Point>& points = study_.subject.points;
        std::vector<std::size_t> front = pareto_front(points);
        std::erase_if(front, [&](std::size_t i) {
            return points[i].setting.precision != Precision::Float32 ||
                   !points[i].setting.fidelity.empty();
        });
        for (std::size_t i = 0; i < std::min(front.size(), kFidelitiesOf); ++i) {
            const std::size_t spread = (2 * i + 1) * front.size() / (2 * kFidelitiesOf);
            const std::size_t at = front.size() > kFidelitiesOf ? spread : i;
            const std::vector<Setting> others =
                with_fidelities(points[front[at]].setting, probe_.effects);
            std::ranges::copy_if(others, std::back_inserter(all), [&](const Setting& each) {
                return !is_measured(each);
            });
        }
        return all;
    }

    bool is_measured(const Setting& setting) const {
        const std::vector<Point>& points = study_.subject.points;
        return std::ranges::find(points, setting, &Point::setting) != points.end();
    }

    void expect(const std::vector<Setting>& settings) { plan_.expect(costs_->sum_s(settings)); }

    Point point_of(const Setting& setting, const ScenePlan::Finished& finished) const {
        Point point{.setting = setting};
        judge(point, finished);
        return point;
    }

    /// All settings of the other engines.
    Result<Done> measure_engines() {
        if (options_.engines.empty() || plan_.interrupted()) return Done{};
        std::vector<SceneRun> runs;
        std::vector<EnginePoint> points;
        for (const EngineRow* engine : options_.engines) {
            for (const EngineSetting& setting : engine->ladder) {
                SceneRun& run = runs.emplace_back(run_of({.step_hz = setting.step_hz}));
                run.engine = setting;
                run.cpu_limit_s = std::max(
                    kEngineLeast_s,
                    kEngineFactor * probe_.second_cpu_s * study_.seconds * setting.step_hz / 60.0);
                points.push_back({.setting = setting,
                                  .title = std::string(engine->title),
                                  .text = engine_setting_text(setting),
                                  .webassembly = engine->webassembly()});
            }
        }
        const Result<Done> done = plan_.run(runs, [&](const ScenePlan::Finished& finished) {
            EnginePoint& point = points[finished.run];
            point.version = finished.answer.engine_version;
            judge(point, finished);
        });
        if (!plan_.interrupted()) study_.subject.engines = std::move(points);
        return done;
    }

    /// Status, errors and cost of a point, from its run.
    void judge(auto& point, const ScenePlan::Finished& finished) const {
        point.status = finished.status;
        point.why = finished.why;
        point.cost = finished.answer.cost;
        if (point.status != RunStatus::Done) return;
        for (const Trace& trace : finished.answer.traces) {
            point.status = trace.status;
            point.why = trace.why;
            if (point.status != RunStatus::Done) return;
            point.why = explosion_in(trace, reference_->answer.traces.front(), reference_->scales);
            if (point.why.empty()) continue;
            point.status = RunStatus::Exploded;
            return;
        }
        point.errors = errors_against(*reference_, finished.answer);
    }

    /// What the reference says of the scene.
    void describe() {
        Subject& subject = study_.subject;
        study_.chaotic = reference_->chaotic;
        subject.uncertainty = reference_->uncertainty;
        subject.tier = reference_->chaotic ? Tier::Spread : Tier::SelfConverged;
        subject.reference = reference_->text;
        subject.metrics = metrics_of(*reference_);
        std::string times;
        for (const int moment : probe_.moments)
            times += fmt::format("{}{:.2f}", times.empty() ? "" : ", ", moment * kSampleEvery_s);
        subject.set_up = fmt::format("{}, compared at {} s", set_up_, times);
    }

    SceneStudy finish() {
        Subject& subject = study_.subject;
        study_.complete = !plan_.interrupted();
        if (reference_)
            subject.notes.insert(
                subject.notes.begin(), reference_->notes.begin(), reference_->notes.end());
        if (left_out_ > 0)
            subject.notes.push_back(
                fmt::format("{} settings left out: there was no time for them", left_out_));
        if (std::string note = clock_note(subject.points); !note.empty())
            subject.notes.push_back(std::move(note));
        std::ranges::stable_sort(subject.points, {}, [](const Point& point) {
            return std::tuple(point.setting.precision,
                              point.setting.solver,
                              point.setting.step_hz,
                              point.setting.iterations,
                              point.setting.substeps == 0 ? 1000 : point.setting.substeps,
                              setting_text(point.setting));
        });
        if (!study_.chaotic)
            subject.verdicts = verdicts_of(subject.points, [](const Setting&, std::string_view) {
                return std::optional<double>{};
            });
        return std::move(study_);
    }

    const SceneStudyOptions& options_;
    ScenePlan plan_;
    SceneProbe probe_;
    std::string set_up_;
    std::optional<SceneReference> reference_;
    std::optional<RunCosts> costs_;  ///< once the first run has told
    std::vector<ScenePlan::Finished> first_answers_;
    std::optional<ScratchFolder> folder_;
    std::size_t left_out_{0};
    SceneStudy study_;
};

}  // namespace

Result<SceneStudy> study_scene(const SceneStudyOptions& options) {
    return SceneStudyMaker(options).make();
}

}  // namespace plumbline::study
