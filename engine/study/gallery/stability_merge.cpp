// Stability tables that several machines made, as one.
#include "engine/scene/formats/json_read.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/workers/shard.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace plumbline::study {
namespace {

using TableJson = nlohmann::json;

Error no_table(std::string_view why) {
    return {.message = fmt::format("not what `plumbline stability` writes: {}", why),
            .exit_code = ExitCode::Refused};
}

Result<std::vector<TableJson>> read_tables(std::span<const std::string> texts) {
    std::vector<TableJson> tables;
    for (const std::string& text : texts) {
        try {
            tables.push_back(scene::read_json<TableJson>(text));
        } catch (const std::exception& fault) {
            return no_table(fault.what());
        }
    }
    return tables;
}

ShardHead head_of(const TableJson& table) {
    ShardHead head{.build = table.at("build"), .complete = table.at("complete")};
    if (!table.contains("shard")) return head;
    const TableJson& shard = table.at("shard");
    head.shard = Shard{.index = shard.at("index"), .of = shard.at("of"), .what = shard.at("what")};
    return head;
}

template <class T>
void add_new(std::vector<T>& all, const T& one) {
    if (std::ranges::find(all, one) == all.end()) all.push_back(one);
}

physics::Solver solver_called(const std::string& name) {
    const auto solver = physics::solver_from_name(name);
    if (!solver) throw std::invalid_argument(fmt::format("unknown solver \"{}\"", name));
    return *solver;
}

/// The whole's plan: every shard lists all runs, and the results of its own.
StabilityTable plan_of(const TableJson& json, const std::vector<CaseEntry>& all) {
    std::vector<std::string> ids;
    std::vector<physics::Solver> solvers;
    std::vector<int> rates_hz;
    for (const TableJson& run : json.at("runs")) {
        add_new(ids, run.at("case").get<std::string>());
        add_new(solvers, solver_called(run.at("solver")));
        add_new(rates_hz, run.at("step_hz").get<int>());
    }
    std::vector<CaseEntry> cases;
    for (const std::string& id : ids) {
        const auto found = std::ranges::find(all, id, [](const CaseEntry& e) { return e.hard.id; });
        if (found == all.end())
            throw std::invalid_argument(fmt::format("there is no case \"{}\" here", id));
        cases.push_back(*found);
    }
    StabilityTable table = plan_table(std::move(cases), std::move(solvers), std::move(rates_hz));
    table.machine = json.at("machine");
    table.build = json.at("build");
    table.made_on = json.at("made_on");
    return table;
}

void take_results(StabilityTable& table, const TableJson& json) {
    for (const TableJson& run : json.at("runs")) {
        const auto is_it = [&](const StabilityRun& own) {
            return table.cases[own.entry].hard.id == run.at("case") &&
                   physics::solver_name(own.solver) == run.at("solver") &&
                   own.step_hz == run.at("step_hz");
        };
        if (run.at("result").is_null()) continue;
        Result<CaseResult> result = parse_case_result(run.at("result").dump());
        const auto own = std::ranges::find_if(table.runs, is_it);
        if (!result || own == table.runs.end())
            throw std::invalid_argument(result ? "a run that the others do not know"
                                               : result.error().message);
        own->result = std::move(*result);
    }
}

}  // namespace

Result<StabilityTable> merged_tables(std::span<const std::string> jsons,
                                     const std::vector<CaseEntry>& all) {
    const Result<std::vector<TableJson>> tables = read_tables(jsons);
    if (!tables) return tables.error();
    try {
        std::vector<ShardHead> heads;
        for (const TableJson& table : *tables) heads.push_back(head_of(table));
        const Result<std::vector<std::size_t>> order = order_of_shards(heads);
        if (!order) return order.error();
        StabilityTable whole = plan_of(tables->front(), all);
        whole.command = heads.front().shard->what;
        for (const std::size_t at : *order) take_results(whole, (*tables)[at]);
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
