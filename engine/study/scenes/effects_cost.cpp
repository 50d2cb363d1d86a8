#include "engine/study/scenes/effects_cost.h"

#include "engine/core/io/files.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/played_scene.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::study {

struct EffectJob {
    std::filesystem::path scene;
    std::string effect;  ///< empty: all that the scene calls for are listed
    double seconds{0};
    int pairs{0};
};

void fields(const auto& field, Like<EffectJob> auto& job) {
    field("scene", job.scene);
    field("effect", job.effect);
    field("seconds", job.seconds);
    field("pairs", job.pairs);
}

/// CPU ms of a step and of a frame's sounds, pass by pass.
struct Passes {
    std::vector<double> step_ms;
    std::vector<double> frame_ms;
};
struct MeasuredPairs {
    Passes with;
    Passes without;
    std::vector<FidelityCost> fidelities;
};

void fields(const auto& field, Like<MeasuredPairs> auto& pairs) {
    field("step_ms", pairs.with.step_ms);
    field("step_ms_without", pairs.without.step_ms);
    field("frame_ms", pairs.with.frame_ms);
    field("frame_ms_without", pairs.without.frame_ms);
    field("fidelities", pairs.fidelities);
}

namespace {

constexpr double kLimit_s = 120;
constexpr int kTurns = 3;  // of runs at each fidelity

/// CPU ms of a step and of a frame's sounds.
struct Passed {
    double step_ms{0};
    double frame_ms{0};
    std::vector<effects::LedgerLine> ledger;
    std::vector<Vec3d> places_m;  ///< of all that moves but pieces of ropes, in the end
};

std::vector<Vec3d> places_of(const scene::Simulation& simulation) {
    const std::set<physics::BodyId> pieces = rope_pieces(simulation);
    std::vector<Vec3d> places_m;
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (!pieces.contains(moving.body) && simulation.physics.contains(moving.body))
            places_m.emplace_back(simulation.physics.state(moving.body).world_from_body.position);
    }
    return places_m;
}

/// One run from the start, a frame's sounds per step.
Result<Passed> pass(const scene::OpenedScene& scene, std::string_view without, double seconds) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    assets::AssetLibrary library(folders->assets);
    Result<PlayedScene> played = PlayedScene::create(scene, library);
    if (!played) return played.error();
    scene::Simulation& simulation = played->simulation();
    played->start({.sound = true, .without = without});
    const auto steps = std::max(1, static_cast<int>(std::lround(seconds / simulation.step_s())));
    Passed passed;
    for (int i = 0; i < steps; ++i) {
        const CpuTimer step;
        played->step();
        passed.step_ms += step.ms();
        const CpuTimer frame;
        played->effects().sound(simulation, played->game().view(simulation, Real{1}, 0.0F, 0.0F));
        passed.frame_ms += frame.ms();
    }
    passed.step_ms /= steps;
    passed.frame_ms /= steps;
    passed.ledger = played->effects().ledger();
    passed.places_m = places_of(simulation);
    return passed;
}

/// Whom the scene calls for at all, from one run.
Result<std::string> list_effects(const scene::OpenedScene& scene, double seconds) {
    const Result<Passed> passed = pass(scene, {}, seconds);
    if (!passed) return passed.error();
    std::vector<EffectCost> costs;
    for (std::size_t row = 0; row < passed->ledger.size(); ++row) {
        const effects::LedgerLine& line = passed->ledger[row];
        if (line.constructions == 0) continue;
        costs.push_back({.name = std::string(line.name),
                         .caller = line.called_for_by.empty() ? "" : line.called_for_by.front(),
                         .domain = std::string(word_of(effects::effect_table()[row].domain)),
                         .calls = line.calls,
                         .bytes_cpu = line.bytes_cpu});
    }
    return text_of(Json(costs));
}

/// Each fidelity in turn, all else as the scene says. Empty: it has but one, or does not act on steps.
Result<std::vector<FidelityCost>> measure_fidelities(const scene::OpenedScene& scene,
                                                     const EffectJob& job) {
    std::vector<FidelityCost> costs;
    const auto table = effects::effect_table();
    const auto row = std::ranges::find(table, job.effect, &effects::EffectRow::name);
    if (row == table.end() || row->domain != effects::Domain::Step ||
        scene::fidelity_of(scene.description, job.effect) == nullptr)
        return costs;
    std::vector<std::vector<Vec3d>> places_m;
    for (const std::string_view word : kWords<scene::Fidelity>)
        costs.push_back({.fidelity = std::string(word), .step_ms = HUGE_VAL});
    for (int turn = 0; turn < kTurns; ++turn) {
        for (std::size_t i = 0; i < costs.size(); ++i) {
            scene::OpenedScene at = scene;
            at.overrides.fidelity = {{job.effect, static_cast<scene::Fidelity>(i)}};
            Result<Passed> passed = pass(at, {}, job.seconds);
            if (!passed) return passed.error();
            costs[i].step_ms = std::min(costs[i].step_ms, passed->step_ms);
            if (turn == 0) places_m.push_back(std::move(passed->places_m));
        }
    }
    for (std::size_t i = 0; i < costs.size(); ++i) {
        // What broke or was removed in one of them has no place to compare.
        const std::size_t count = std::min(places_m[i].size(), places_m.back().size());
        for (std::size_t k = 0; k < count; ++k) {
            const double off_m = glm::distance(places_m[i][k], places_m.back()[k]);
            costs[i].largest_m = std::max(costs[i].largest_m, off_m);
            costs[i].mean_m += off_m / static_cast<double>(count);
        }
    }
    return costs;
}

/// Turn and turn about; what comes first changes from pair to pair.
Result<std::string> measure_pairs(const scene::OpenedScene& scene, const EffectJob& job) {
    if (const Result<Passed> warm = pass(scene, {}, job.seconds); !warm) return warm.error();
    std::array<Passes, 2> passes;
    for (int i = 0; i < 2 * job.pairs; ++i) {
        const std::size_t without = static_cast<std::size_t>((i + i / 2) % 2);
        const Result<Passed> passed =
            pass(scene, without == 1 ? job.effect : std::string(), job.seconds);
        if (!passed) return passed.error();
        passes[without].step_ms.push_back(passed->step_ms);
        passes[without].frame_ms.push_back(passed->frame_ms);
    }
    Result<std::vector<FidelityCost>> fidelities = measure_fidelities(scene, job);
    if (!fidelities) return fidelities.error();
    return text_of(Json(MeasuredPairs{
        .with = passes[0], .without = passes[1], .fidelities = std::move(*fidelities)}));
}

Job job_for(const EffectsRun& run, const std::string& effect) {
    return {.kind = "effect",
            .body = text_of(Json(EffectJob{
                .scene = run.scene, .effect = effect, .seconds = run.seconds, .pairs = run.pairs})),
            .limit_s = kLimit_s};
}

template <class T>
Result<T> read_answer(const Answer& answer) {
    if (answer.status == RunStatus::Done)
        return read_text<T>(answer.body, "a worker's answer cannot be read");
    const bool is_refused = answer.status == RunStatus::Refused;
    return Error{.message = answer.body,
                 .exit_code = is_refused ? ExitCode::Refused : ExitCode::RunFailed};
}

/// Empty where it was interrupted.
Result<std::vector<EffectCost>> called_for(const EffectsRun& run) {
    Result<std::vector<EffectCost>> listed(std::vector<EffectCost>{});
    const Result<bool> all = run_jobs(
        std::vector{job_for(run, {})}, {.count = 1}, [&](std::size_t, const Answer& answer) {
            listed = read_answer<std::vector<EffectCost>>(answer);
        });
    if (!all) return all.error();
    return listed;
}

}  // namespace

Result<std::string> run_effect_job(const std::string& body) {
    const Result<EffectJob> job = read_text<EffectJob>(body, "expected an effect to measure");
    if (!job) return job.error();
    const Result<scene::OpenedScene> scene = open_for_study(job->scene);
    if (!scene) return scene.error();
    return job->effect.empty() ? list_effects(*scene, job->seconds) : measure_pairs(*scene, *job);
}

Result<std::vector<EffectCost>> measure_effects(const EffectsRun& run, int workers) {
    Result<std::vector<EffectCost>> costs = called_for(run);
    if (!costs) return costs;
    std::vector<Job> jobs;
    for (const EffectCost& cost : *costs) jobs.push_back(job_for(run, cost.name));
    std::optional<Error> fault;
    const Result<bool> all =
        run_jobs(jobs, {.count = workers}, [&](std::size_t job, const Answer& answer) {
            const Result<MeasuredPairs> measured = read_answer<MeasuredPairs>(answer);
            if (!measured) {
                fault = measured.error();
                return;
            }
            const auto& [with, without, fidelities] = *measured;
            EffectCost& cost = (*costs)[job];
            cost.step_ms = paired_difference(with.step_ms, without.step_ms);
            cost.frame_ms = paired_difference(with.frame_ms, without.frame_ms);
            cost.fidelities = fidelities;
        });
    if (!all) return all.error();
    if (fault) return *fault;
    std::erase_if(*costs, [](const EffectCost& cost) { return cost.step_ms.pairs == 0; });
    return costs;
}

}  // namespace plumbline::study
