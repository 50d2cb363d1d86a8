// Other engines that run our scenes: how each is started, and which of its settings are tried.
#pragma once

#include "engine/core/result.h"
#include "engine/study/engine_setting.h"
#include "engine/study/engines/engine_process.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

struct EngineRow {
    std::string_view name;     ///< of the command line
    std::string_view title;    ///< as its makers write it
    std::string_view package;  ///< of npm, run as WebAssembly; empty: built into plumbline-engines
    std::vector<EngineSetting> ladder;  ///< its defaults at several rates, then its own knobs

    bool webassembly() const { return !package.empty(); }
};
std::span<const EngineRow> engine_table();
/// Null: there is none of that name.
const EngineRow* engine_of(std::string_view name);

/// "60 Hz, 50 iterations"; "60 Hz" are its defaults.
std::string engine_setting_text(const EngineSetting& setting);

/// "jolt,rapier"; "all". Refused: names that are not in the table.
Result<std::vector<const EngineRow*>> engines_from(std::string_view names);

/// Where npm's packages are looked for.
std::filesystem::path engine_packages_folder();
/// Refused: no such engine, and what EngineProcess::start() refuses.
Result<EngineProcess> start_engine(const EngineSetting& setting);
/// Before anything is measured: refused is an engine that is not installed; the message says how to install it.
Result<Done> check_engine(const EngineRow& engine);

/// The engines of these names. One that is not installed is left out with a warning. Refused: as engines_from(), and where none
/// is installed. No names: none.
Result<std::vector<const EngineRow*>> installed_engines(std::string_view names);

}  // namespace plumbline::study
