// Stability tables that several machines made, as one.
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/workers/shard.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {

/// What every run in a table begins with.
struct RunHead {
    std::string id;  ///< of its case
    physics::Solver solver{};
    int step_hz{0};
};

void fields(const auto& field, Like<RunHead> auto& run) {
    field("case", run.id);
    field("solver", run.solver);
    field("step_hz", run.step_hz);
}

namespace {

Error no_table(std::string_view why) {
    return {.message = fmt::format("not what `plumbline stability` writes: {}", why),
            .exit_code = ExitCode::Refused};
}

ShardHead head_of(const Json& table) {
    ShardHead head{.build = table.at("build"), .complete = table.at("complete")};
    FieldReader{table}("shard", head.shard);
    return head;
}

template <class T>
void add_new(std::vector<T>& all, const T& one) {
    if (std::ranges::find(all, one) == all.end()) all.push_back(one);
}

/// The whole's plan: every shard lists all runs, and the results of its own.
StabilityTable plan_of(const Json& json, const std::vector<CaseEntry>& all) {
    std::vector<std::string> ids;
    std::vector<physics::Solver> solvers;
    std::vector<int> rates_hz;
    for (const auto& run : json.at("runs").get<std::vector<RunHead>>()) {
        add_new(ids, run.id);
        add_new(solvers, run.solver);
        add_new(rates_hz, run.step_hz);
    }
    std::vector<CaseEntry> cases;
    for (const std::string& id : ids) {
        const auto found = std::ranges::find(all, id, [](const CaseEntry& e) { return e.hard.id; });
        if (found == all.end())
            throw std::invalid_argument(fmt::format("there is no case \"{}\" here", id));
        cases.push_back(*found);
    }
    StabilityTable table = plan_table(std::move(cases), solvers, rates_hz);
    table.machine = json.at("machine");
    table.build = json.at("build");
    table.made_on = json.at("made_on");
    return table;
}

void take_results(StabilityTable& table, const Json& json) {
    for (const Json& run : json.at("runs")) {
        if (run.at("result").is_null()) continue;
        const auto head = run.get<RunHead>();
        const auto own = std::ranges::find_if(table.runs, [&](const StabilityRun& each) {
            return table.cases[each.entry].hard.id == head.id && each.solver == head.solver &&
                   each.step_hz == head.step_hz;
        });
        Result<CaseResult> result = parse_case_result(run.at("result").dump());
        if (!result || own == table.runs.end())
            throw std::invalid_argument(result ? "a run that the others do not know"
                                               : result.error().message);
        own->result = std::move(*result);
    }
}

}  // namespace

Result<StabilityTable> merged_tables(std::span<const std::string> jsons,
                                     const std::vector<CaseEntry>& all) {
    try {
        std::vector<Json> tables;
        std::vector<ShardHead> heads;
        for (const std::string& json : jsons) {
            tables.push_back(scene::read_json<Json>(json));
            heads.push_back(head_of(tables.back()));
        }
        const Result<std::vector<std::size_t>> order = order_of_shards(heads);
        if (!order) return order.error();
        StabilityTable whole = plan_of(tables.front(), all);
        whole.command = heads.front().shard->what;
        for (const std::size_t at : *order) take_results(whole, tables[at]);
        for (const StabilityRun& run : whole.runs) {
            if (!run.result)
                return no_table(fmt::format("no shard has made {} with {} at {} Hz",
                                            whole.cases[run.entry].hard.id,
                                            physics::solver_name(run.solver),
                                            run.step_hz));
        }
        return whole;
    } catch (const std::exception& fault) {
        return no_table(fault.what());
    }
}

}  // namespace plumbline::study
