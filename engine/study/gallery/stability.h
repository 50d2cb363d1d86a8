// The stability table: every hard case, every solver, one verdict a cell; as text, JSON and a page.
#pragma once

#include "engine/core/io/files.h"
#include "engine/core/result.h"
#include "engine/scene/scene_description.h"
#include "engine/study/engines/engine_table.h"
#include "engine/study/findings/findings.h"
#include "engine/study/gallery/gallery.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

/// One scene of assets/scenes/hard.
struct CaseEntry {
    std::filesystem::path scene;
    std::string title;  ///< without the id
    scene::HardCase hard;
};

/// All of them, by id. Refused: a folder that is not there, a scene that does not load or has no
/// [hard_case].
Result<std::vector<CaseEntry>> find_cases(const DataFolders& folders);

/// Those called `ids` (any case, "hard/H05" too), or with none of them all of the tier. Refused (exit
/// code 2): an id that nothing has; the message names the nearest.
Result<std::vector<CaseEntry>> select_cases(const std::vector<CaseEntry>& all,
                                            const std::vector<std::string>& ids,
                                            bool with_nightly);

/// The rate of the game, at which known red rules are held against what is measured.
inline constexpr int kGameRate_hz = 60;
/// How much farther outside than measured the limit of a known red rule may lie, as a factor.
inline constexpr double kRedRoom = 1.5;

/// One cell. `result` is empty while it has not run, or was interrupted.
struct StabilityRun {
    std::size_t entry{0};  ///< into StabilityTable::cases
    physics::Solver solver{physics::Solver::SmallStep};
    int step_hz{60};
    const EngineRow* engine{nullptr};  ///< another one, with its defaults, in place of the solver
    std::optional<CaseResult> result{};

    std::string_view stepped_by() const {
        return engine != nullptr ? engine->name : physics::solver_name(solver);
    }
    /// Neither passed nor failed: the engine has not what the case needs, or is not asked for it.
    bool lacks() const { return engine != nullptr && result && result->refused; }
    bool green() const { return result && result->passed; }
};

struct StabilityTable {
    std::string command;  ///< to repeat it
    std::string machine;
    std::string build;
    std::string made_on;
    bool complete{true};           ///< false: interrupted
    std::optional<Shard> shard{};  ///< its runs only; none: all
    std::vector<CaseEntry> cases;
    std::vector<StabilityRun> runs;
    std::vector<std::string> images;  ///< PNG bytes, one per case; empty where there is none
    std::string no_images;            ///< why there are none, or empty

    const StabilityRun* find(std::size_t entry, physics::Solver solver, int step_hz) const;
    /// Where small_step's runs at 60 Hz are not what the cases' known_red says, one sentence each:
    /// a broken rule that is not listed, a listed one that holds, got worse, or whose limit lies
    /// kRedRoom times as far outside as what was measured. Runs that were given up say nothing.
    std::vector<std::string> known_red_faults() const;
};

/// A table with a run, not yet made, for every case, solver and rate, and for every engine.
StabilityTable plan_table(std::vector<CaseEntry> cases,
                          const std::vector<physics::Solver>& solvers,
                          const std::vector<int>& rates_hz,
                          const std::vector<const EngineRow*>& engines = {});

/// Runs what has no result yet in worker processes; `ended` after each, with how many are done.
/// False, and complete false, when interrupted. Refused: what run_jobs() refuses.
Result<bool> run_table(StabilityTable& table,
                       int workers,
                       const std::function<void(const StabilityRun& run, std::size_t done)>& ended);

/// The tables of all shards, as stability_json() wrote them, as one. `all`: every case there is.
/// Refused: what order_of_shards() refuses, text that is no table, a case that is not in `all`, a
/// run that no shard has made.
Result<StabilityTable> merged_tables(std::span<const std::string> jsons,
                                     const std::vector<CaseEntry>& all);

/// An image of small_step's end state of each case, `width_px` x `height_px`, by `plumbline render`
/// in child processes. Where the first fails, none is made and no_images says why.
void take_images(StabilityTable& table, int workers, int width_px, int height_px);

/// "pass", "FAIL", "slow": given up before it had failed, or "-": lacks(). The run has a result.
std::string_view verdict_word(const StabilityRun& run);
/// "H05  small_step  60 Hz  pass  92 % inside  3.2 ms/s  sag_m of box_1 at most 0.1".
std::string run_line(const StabilityTable& table, const StabilityRun& run);
/// All lines and how many are green for each solver.
std::string stability_text(const StabilityTable& table);
std::string stability_json(const StabilityTable& table);
/// One self-contained page. Refused: what report_page() refuses.
Result<std::string> stability_page(const StabilityTable& table);

}  // namespace plumbline::study
