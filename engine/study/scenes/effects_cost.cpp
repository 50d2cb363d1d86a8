#include "engine/study/scenes/effects_cost.h"

#include "engine/core/io/files.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/scene/formats/json_read.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/played_scene.h"
#include "engine/study/workers/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kLimit_s = 120;

/// CPU ms of a step and of a frame's sounds.
struct Passed {
    double step_ms{0};
    double frame_ms{0};
    std::vector<effects::LedgerLine> ledger;
};

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
        simulation.cues.clear();
        passed.frame_ms += frame.ms();
    }
    passed.step_ms /= steps;
    passed.frame_ms /= steps;
    passed.ledger = played->effects().ledger();
    return passed;
}

Json refusal(const std::string& why) {
    return Json{{"refused", why}};
}

/// Whom the scene calls for at all: the names, from one run.
Json list_effects(const scene::OpenedScene& scene, double seconds) {
    const Result<Passed> passed = pass(scene, {}, seconds);
    if (!passed) return refusal(passed.error().message);
    Json effects = Json::array();
    for (std::size_t row = 0; row < passed->ledger.size(); ++row) {
        const effects::LedgerLine& line = passed->ledger[row];
        if (line.constructions == 0) continue;
        effects.push_back({{"name", line.name},
                           {"caller", line.called_for_by.empty() ? "" : line.called_for_by.front()},
                           {"domain", domain_name(effects::effect_table()[row].domain)},
                           {"calls", line.calls},
                           {"bytes_cpu", line.bytes_cpu}});
    }
    return Json{{"refused", ""}, {"effects", std::move(effects)}};
}

/// Turn and turn about; what comes first changes from pair to pair.
Json measure_pairs(const scene::OpenedScene& scene,
                   const std::string& name,
                   double seconds,
                   int pairs) {
    std::array<std::vector<double>, 2> step_ms;
    std::array<std::vector<double>, 2> frame_ms;
    if (const Result<Passed> warm = pass(scene, {}, seconds); !warm)
        return refusal(warm.error().message);
    for (int i = 0; i < 2 * pairs; ++i) {
        const std::size_t without = static_cast<std::size_t>((i + i / 2) % 2);
        const Result<Passed> passed =
            pass(scene, without == 1 ? std::string_view(name) : std::string_view(), seconds);
        if (!passed) return refusal(passed.error().message);
        step_ms[without].push_back(passed->step_ms);
        frame_ms[without].push_back(passed->frame_ms);
    }
    return Json{{"refused", ""},
                {"step_ms", step_ms[0]},
                {"step_ms_without", step_ms[1]},
                {"frame_ms", frame_ms[0]},
                {"frame_ms_without", frame_ms[1]}};
}

Json answer_effect_job(const Json& job) {
    const Result<scene::OpenedScene> scene = open_for_study(job.at("scene").get<std::string>());
    if (!scene) return refusal(scene.error().message);
    const std::string effect = job.at("effect");
    if (effect.empty()) return list_effects(*scene, job.at("seconds"));
    return measure_pairs(*scene, effect, job.at("seconds"), job.at("pairs"));
}

Job job_for(const EffectsRun& run, const std::string& effect) {
    return {.kind = "effect",
            .body = Json{{"scene", run.scene.string()},
                         {"effect", effect},
                         {"seconds", run.seconds},
                         {"pairs", run.pairs}}
                        .dump(-1, ' ', false, Json::error_handler_t::replace),
            .limit_s = kLimit_s};
}

Result<Json> json_from(const Answer& answer) {
    if (answer.status != AnswerStatus::Done) return Error{.message = answer.body};
    Json json;
    try {
        json = scene::read_json<Json>(answer.body);
    } catch (const std::exception&) {
        json = nullptr;
    }
    if (!json.is_object() || !json.contains("refused"))
        return Error{.message = "a worker's answer cannot be read"};
    const std::string refused = json["refused"];
    if (!refused.empty()) return Error{.message = refused, .exit_code = ExitCode::Refused};
    return json;
}

/// Empty where it was interrupted.
Result<std::vector<EffectCost>> called_for(const EffectsRun& run) {
    std::optional<Result<Json>> listed;
    const Result<bool> all =
        run_jobs(std::vector{job_for(run, {})}, 1, [&](std::size_t, const Answer& answer) {
            listed = json_from(answer);
        });
    if (!all) return all.error();
    std::vector<EffectCost> costs;
    if (!listed) return costs;
    if (!*listed) return listed->error();
    for (const Json& effect : (*listed)->at("effects")) {
        costs.push_back({.name = effect.at("name"),
                         .caller = effect.at("caller"),
                         .domain = effect.at("domain"),
                         .calls = effect.at("calls"),
                         .bytes_cpu = effect.at("bytes_cpu")});
    }
    return costs;
}

}  // namespace

std::string_view domain_name(effects::Domain domain) {
    switch (domain) {
        case effects::Domain::Step:
            return "step";
        case effects::Domain::Frame:
            return "image";
        case effects::Domain::Sound:
            return "sound";
    }
    return "";
}

std::string run_effect_job(const std::string& body) {
    Json answer;
    try {
        answer = answer_effect_job(scene::read_json<Json>(body));
    } catch (const std::exception& fault) {
        answer = refusal(fmt::format("expected an effect to measure: {}", fault.what()));
    }
    return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<std::vector<EffectCost>> measure_effects(const EffectsRun& run, int workers) {
    Result<std::vector<EffectCost>> costs = called_for(run);
    if (!costs) return costs;
    std::vector<Job> jobs;
    for (const EffectCost& cost : *costs) jobs.push_back(job_for(run, cost.name));
    std::optional<Error> fault;
    const Result<bool> all = run_jobs(jobs, workers, [&](std::size_t job, const Answer& answer) {
        const Result<Json> measured = json_from(answer);
        if (!measured) {
            fault = measured.error();
            return;
        }
        const auto list = [&](const char* key) {
            return measured->at(key).get<std::vector<double>>();
        };
        EffectCost& cost = (*costs)[job];
        cost.step_ms = paired_difference(list("step_ms"), list("step_ms_without"));
        cost.frame_ms = paired_difference(list("frame_ms"), list("frame_ms_without"));
    });
    if (!all) return all.error();
    if (fault) return *fault;
    std::erase_if(*costs, [](const EffectCost& cost) { return cost.step_ms.pairs == 0; });
    return costs;
}

}  // namespace plumbline::study
