#include "engine/study/scenarios/scenario_study.h"

#include "engine/core/time/stopwatch.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/workers/worker_pool.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kScenarioLimit_s = 60;

struct Planned {
    std::size_t scenario;
    Setting setting;
    Job job;
    double weight;  ///< what it will take, compared with others
};

/// Repeats that are worth their time; the budget counts where a run is long.
Repeats repeats_of(Effort effort) {
    return effort == Effort::Quick ? Repeats{.wanted = 3, .budget_s = 0.1}
                                   : Repeats{.wanted = 5, .budget_s = 0.25};
}

std::vector<Planned> plan(const ScenarioStudyOptions& options) {
    const Repeats repeats = repeats_of(options.effort);
    std::vector<Planned> planned;
    for (std::size_t i = 0; i < options.scenarios.size(); ++i) {
        for (const Setting& setting : grid_of(*options.scenarios[i], options.effort)) {
            const Json body{{"scenario", options.scenarios[i]->id},
                            {"setting", setting},
                            {"repeats", repeats.wanted},
                            {"budget_s", repeats.budget_s}};
            planned.push_back({.scenario = i,
                               .setting = setting,
                               .job = {.kind = "scenario",
                                       .body = body.dump(),
                                       .precision = setting.precision,
                                       .limit_s = kScenarioLimit_s},
                               .weight = static_cast<double>(setting.step_hz)});
        }
    }
    return planned;
}

std::vector<Planned> those_of(const Shard& shard, std::vector<Planned> all) {
    std::vector<Planned> own;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (shard.has(i)) own.push_back(std::move(all[i]));
    }
    return own;
}

Point point_of(const Setting& setting, const Answer& answer) {
    if (answer.status != RunStatus::Done)
        return {.setting = setting, .status = answer.status, .why = answer.body};
    Result<Point> point = read_text<Point>(answer.body, "its worker's answer cannot be read");
    if (point) return std::move(*point);
    return {.setting = setting, .status = RunStatus::Refused, .why = point.error().message};
}

Subject subject_of(const Scenario& scenario, std::vector<Point> points) {
    Subject subject{.id = scenario.id,
                    .title = scenario.title,
                    .set_up = scenario.set_up,
                    .reference = scenario.reference,
                    .tier = scenario.tier,
                    .peer_scene = scenario.peer_scene,
                    .metrics = scenario.metrics,
                    .points = std::move(points),
                    .notes = scenario.notes};
    if (scenario.euler_floor) {
        for (int hz = scenario.knobs.least_hz; hz <= scenario.knobs.most_hz; hz *= 2)
            subject.euler_floor.push_back(
                {.step_s = 1.0 / hz, .error = scenario.euler_floor(1.0 / hz)});
    }
    subject.verdicts = verdicts_of(subject.points, scenario.theory);
    return subject;
}

}  // namespace

double clock_spread_of(std::span<const Subject> subjects) {
    std::vector<double> spreads;
    for (const Subject& subject : subjects) {
        for (const Point& point : subject.points) {
            if (point.cost.repeats > 2)
                spreads.push_back(point.cost.ms_per_s_median / point.cost.ms_per_s_min - 1);
        }
    }
    if (spreads.empty()) return 0;
    const auto middle = spreads.begin() + static_cast<std::ptrdiff_t>(spreads.size() / 2);
    std::ranges::nth_element(spreads, middle);
    return *middle;
}

Result<ScenarioStudy> study_scenarios(const ScenarioStudyOptions& options) {
    std::vector<Planned> planned = plan(options);
    const std::size_t runs = planned.size();
    if (options.shard) planned = those_of(*options.shard, std::move(planned));
    std::vector<Job> jobs;
    double all = 0;
    for (const Planned& each : planned) {
        jobs.push_back(each.job);
        all += each.weight;
    }
    std::vector<std::optional<Point>> points(planned.size());
    const double start_s = wall_s();
    double done = 0;
    const Result<bool> ended =
        run_jobs(jobs, {.count = options.workers}, [&](std::size_t index, const Answer& answer) {
            points[index] = point_of(planned[index].setting, answer);
            done += planned[index].weight;
            if (options.progress)
                options.progress(done / all, (wall_s() - start_s) * (all / done - 1));
        });
    if (!ended) return ended.error();

    ScenarioStudy study{.runs = runs, .complete = *ended};
    for (std::size_t i = 0; i < options.scenarios.size(); ++i) {
        std::vector<Point> own;
        for (std::size_t k = 0; k < planned.size(); ++k) {
            if (planned[k].scenario == i && points[k]) own.push_back(*points[k]);
        }
        if (!own.empty())
            study.subjects.push_back(subject_of(*options.scenarios[i], std::move(own)));
    }
    study.clock_spread = clock_spread_of(study.subjects);
    return study;
}

Result<std::string> run_scenario_job(const std::string& body) {
    const Json job = scene::read_json<Json>(body);
    const std::string id = job.at("scenario");
    const Scenario* scenario = scenario_of(id);
    if (!scenario) throw std::runtime_error("there is no scenario " + id);
    const Repeats repeats{.wanted = job.at("repeats"), .budget_s = job.at("budget_s")};
    const auto setting = job.at("setting").get<Setting>();
    return text_of(Json(run_scenario(*scenario, setting, repeats)));
}

}  // namespace plumbline::study
