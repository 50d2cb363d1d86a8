#include "engine/study/engines/engine_table.h"

#include "engine/core/io/files.h"
#include "engine/core/log.h"
#include "engine/core/text/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

/// The defaults at three rates, then each list of knobs at 60 Hz.
std::vector<EngineSetting> ladder(const std::string& engine,
                                  const std::vector<std::vector<EngineKnob>>& others) {
    std::vector<EngineSetting> settings;
    for (const int step_hz : {60, 120, 240}) settings.push_back({engine, step_hz, {}});
    for (const std::vector<EngineKnob>& knobs : others) settings.push_back({engine, 60, knobs});
    return settings;
}

/// A line that npm understands; folders with spaces in their names want quotes.
std::string install_line(const EngineRow& engine) {
    return fmt::format(
        "npm install --prefix \"{}\" {}", engine_packages_folder().string(), engine.package);
}

Result<ChildDef> program_of(const EngineRow& engine) {
    namespace fs = std::filesystem;
    if (!engine.webassembly()) {
        std::error_code error;
        const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
        const fs::path beside = folder / "plumbline-engines";
        const fs::path installed =
            folder.parent_path() / "libexec" / "plumbline" / "plumbline-engines";
        return ChildDef{.program = fs::exists(beside, error) ? beside : installed,
                        .arguments = {std::string(engine.name)},
                        .own_group = true,
                        .silent = true};
    }
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    return ChildDef{.program = "node",
                    .arguments = {(folders->assets / "engines" / "run.mjs").string(),
                                  std::string(engine.name),
                                  engine_packages_folder().string()},
                    .own_group = true,
                    .silent = true};
}

}  // namespace

std::span<const EngineRow> engine_table() {
    static const std::vector<EngineRow> kRows{
        {"jolt", "Jolt Physics", "jolt-physics", ladder("jolt", {{{"iterations", 50}}})},
        {"rapier", "Rapier", "@dimforge/rapier3d-compat", ladder("rapier", {{{"iterations", 16}}})},
        {"physx",
         "PhysX",
         "physx-js-webidl",
         ladder("physx", {{{"iterations", 16}}, {{"pgs", 1}}})},
        {"havok", "Havok", "@babylonjs/havok", ladder("havok", {})},
        {"bullet", "Bullet", "", ladder("bullet", {{{"iterations", 50}}})},
        {"ode", "ODE", "", ladder("ode", {{{"iterations", 100}}, {{"direct", 1}}})}};
    return kRows;
}

const EngineRow* engine_of(std::string_view name) {
    const std::span<const EngineRow> rows = engine_table();
    const auto found = std::ranges::find(rows, name, &EngineRow::name);
    return found == rows.end() ? nullptr : &*found;
}

std::string engine_setting_text(const EngineSetting& setting) {
    std::string text = fmt::format("{} Hz", setting.step_hz);
    for (const EngineKnob& knob : setting.knobs) {
        // What is there or not is a word, the rest is counted.
        const bool is_word = knob.value == 1;
        text += is_word ? fmt::format(", {}", knob.name)
                        : fmt::format(", {} {}", knob.value, knob.name);
    }
    return text;
}

Result<std::vector<const EngineRow*>> engines_from(std::string_view names) {
    std::vector<const EngineRow*> engines;
    if (names == "all") {
        for (const EngineRow& row : engine_table()) engines.push_back(&row);
        return engines;
    }
    while (true) {
        const std::size_t comma = names.find(',');
        const std::string_view name = names.substr(0, comma);
        const EngineRow* engine = engine_of(name);
        if (engine == nullptr) {
            std::vector<std::string_view> known;
            for (const EngineRow& row : engine_table()) known.push_back(row.name);
            return Error{.message = fmt::format("no engine is called \"{}\"{}; expected names with "
                                                "commas between them, of {}, or all",
                                                name,
                                                nearest_words(std::string(name), known),
                                                fmt::join(known, ", ")),
                         .exit_code = ExitCode::BadUsage};
        }
        if (std::ranges::find(engines, engine) == engines.end()) engines.push_back(engine);
        if (comma == std::string_view::npos) return engines;
        names.remove_prefix(comma + 1);
    }
}

std::filesystem::path engine_packages_folder() {
    return user_data_folder() / "engines";
}

Result<EngineProcess> start_engine(const EngineSetting& setting) {
    const EngineRow* engine = engine_of(setting.engine);
    if (engine == nullptr)
        return Error{.message = fmt::format("no engine is called \"{}\"", setting.engine)};
    const Result<ChildDef> program = program_of(*engine);
    if (!program) return program.error();
    return EngineProcess::start(*program);
}

Result<Done> check_engine(const EngineRow& engine) {
    const Result<ChildDef> program = program_of(engine);
    if (!program) return program.error();
    const Result<EngineProcess> process = EngineProcess::start(*program);
    if (process) return Done{};
    const std::string why = fmt::format("{}: {}", engine.title, process.error().message);
    if (!engine.webassembly()) return Error{.message = why, .exit_code = ExitCode::Refused};
    return Error{.message = fmt::format("{}; install it: {}", why, install_line(engine)),
                 .exit_code = ExitCode::Refused};
}

Result<std::vector<const EngineRow*>> installed_engines(std::string_view names) {
    if (names.empty()) return std::vector<const EngineRow*>{};
    Result<std::vector<const EngineRow*>> engines = engines_from(names);
    if (!engines) return engines;
    std::erase_if(*engines, [](const EngineRow* engine) {
        const Result<Done> there = check_engine(*engine);
        if (!there) log_warning("{}", there.error().message);
        return !there;
    });
    if (engines->empty())
        return Error{.message = "none of the engines that were asked for is installed",
                     .exit_code = ExitCode::Refused};
    return engines;
}

}  // namespace plumbline::study
