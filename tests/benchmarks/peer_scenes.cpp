// The scenes that other physics engines were measured on, on our solvers and on a bare Bullet loop:
// cost as a ratio to that loop in the same run, and how right each of them is.
//
//   peer_scenes stack heavy100 --solver small_step,bullet_si --substeps 0,4,8
//   peer_scenes all --rounds 5 --phases --csv peers.csv
//   peer_scenes pile --sleep             every body may sleep
//   peer_scenes --list
//
// --substeps 0 is what the scene says; "given" is what islands then got, mean over bodies..most.
// --hz applies to ours, the bare loop runs at 60; --drop-in adds that loop with SmallStepDynamicsWorld in
// it; --threads 1,2 compares numbers of threads (ms/frame is the CPU time of all); --seconds cuts a scene short; --no-bare leaves the loop and the ratios out. Run it on an idle machine:
// memory that others use slows both sides, but not alike.
#include "engine/core/io/files.h"
#include "tests/benchmarks/peer_scenes_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace {

using namespace plumbline;
using namespace plumbline::bench;

struct Options {
    std::vector<std::string> scenes;
    std::vector<physics::Solver> solvers{physics::Solver::SmallStep, physics::Solver::BulletSi};
    std::vector<int> substeps{0};
    std::vector<int> threads{1};
    int hz{60};
    RunSettings run{};
    std::string csv;
    bool bare{true};
    bool drop_in{false};
    bool list{false};
};

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

[[noreturn]] void stop(const std::string& message) {
    std::cerr << fmt::format("peer_scenes: {}\n", message);
    std::exit(2);
}

template <class T>
T number_in(std::string_view text) {
    T value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size() || value < T{0})
        stop(fmt::format("\"{}\" is not a number to use here", text));
    return value;
}

void add_scene(std::string_view name, Options& options) {
    if (name == "all") {
        for (const SceneCase& known : scene_cases()) options.scenes.emplace_back(known.name);
        return;
    }
    if (find_scene_case(name) == nullptr)
        stop(fmt::format("no scene \"{}\"; --list prints them", name));
    options.scenes.emplace_back(name);
}

/// An option that takes a value; false: not one of them.
bool read_value(std::string_view option, std::string_view value, Options& options) {
    if (option == "--solver") {
        options.solvers.clear();
        for (const std::string& name : split(value)) {
            const auto solver = physics::solver_from_name(name);
            if (!solver) stop(fmt::format("no solver \"{}\"", name));
            options.solvers.push_back(*solver);
        }
    } else if (option == "--substeps") {
        options.substeps.clear();
        for (const std::string& count : split(value))
            options.substeps.push_back(number_in<int>(count));
    } else if (option == "--threads") {
        options.threads.clear();
        for (const std::string& count : split(value))
            options.threads.push_back(std::max(1, number_in<int>(count)));
    } else if (option == "--hz") {
        options.hz = std::max(1, number_in<int>(value));
    } else if (option == "--rounds") {
        options.run.rounds = std::max(1, number_in<int>(value));
    } else if (option == "--seconds") {
        options.run.seconds = number_in<double>(value);
    } else if (option == "--csv") {
        options.csv = value;
    } else {
        return false;
    }
    return true;
}

Options options_of(const std::vector<std::string_view>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == "--list") {
            options.list = true;
        } else if (word == "--sleep") {
            options.run.sleep = true;
        } else if (word == "--phases") {
            options.run.phases = true;
        } else if (word == "--no-bare") {
            options.bare = false;
        } else if (word == "--drop-in") {
            options.drop_in = true;
        } else if (!word.starts_with("--")) {
            add_scene(word, options);
        } else if (i + 1 < words.size() && read_value(word, words[i + 1], options)) {
            ++i;
        } else {
            stop(fmt::format("{}: unknown, or its value is missing", word));
        }
    }
    if (options.scenes.empty() && !options.list) stop("name a scene, or all");
    return options;
}

std::vector<Variant> variants_of(const Options& options) {
    std::vector<Variant> variants;
    if (options.bare) variants.push_back({.engine = "bullet32", .bare = true});
    if (options.drop_in) variants.push_back({.engine = "drop_in", .drop_in = true});
    for (const physics::Solver solver : options.solvers) {
        for (const int substeps : options.substeps) {
            for (const int threads : options.threads) {
                variants.push_back({.engine = std::string(physics::solver_name(solver)),
                                    .settings = {.solver = solver,
                                                 .hz = options.hz,
                                                 .substeps = substeps,
                                                 .threads = threads}});
            }
        }
    }
    return variants;
}

using Row = std::vector<std::string>;

Row head_of(const std::vector<VariantResult>& results) {
    Row head{"engine", "threads", "S", "given", "hz", "wall ms", "ms/frame", "ratio", "min", "max"};
    const bool phases = std::ranges::any_of(
        results, [](const VariantResult& result) { return result.phases.has_value(); });
    if (phases) head.insert(head.end(), {"broad", "narrow", "solve", "integr", "other"});
    for (const Metric& metric : results.front().metrics) head.push_back(metric.name);
    return head;
}

Row row_of(const VariantResult& result, bool phases) {
    const Variant& variant = result.variant;
    const std::string substeps = variant.bare ? std::string("1")
                                 : variant.settings.substeps > 0
                                     ? fmt::format("{}", variant.settings.substeps)
                                     : std::string("auto");
    Row row{variant.engine,
            fmt::format("{}", variant.settings.threads),
            substeps,
            result.given ? fmt::format("{:.1f}..{}", result.given->mean, result.given->most) : "-",
            fmt::format("{}", variant.settings.hz),
            fmt::format("{:.4f}", result.wall_ms_per_frame),
            fmt::format("{:.4f}", result.ms_per_frame)};
    if (result.ratio) {
        for (const double ratio : {*result.ratio, result.ratio_min, result.ratio_max})
            row.push_back(fmt::format("{:.2f}", ratio));
    } else {
        row.insert(row.end(), 3, "-");
    }
    if (phases && result.phases) {
        const Phases& p = *result.phases;
        for (const double ms : {p.broad, p.narrow, p.solve, p.integrate, p.other})
            row.push_back(fmt::format("{:.4f}", ms));
    } else if (phases) {
        row.insert(row.end(), 5, "-");
    }
    for (const Metric& metric : result.metrics) row.push_back(fmt::format("{:.4g}", metric.value));
    return row;
}

void print(const std::string& scene, const std::vector<VariantResult>& results) {
    std::vector<Row> rows{head_of(results)};
    const bool phases = rows.front().size() > results.front().metrics.size() + 10;
    for (const VariantResult& result : results) rows.push_back(row_of(result, phases));
    std::cout << fmt::format("\n{}\n", scene);
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            std::size_t width = 0;
            for (const Row& other : rows) width = std::max(width, other[column].size());
            line += column == 0 ? fmt::format("  {:<{}}", row[column], width)
                                : fmt::format("  {:>{}}", row[column], width);
        }
        std::cout << line << '\n';
    }
    std::cout.flush();
}

/// The columns of the other engines' table first, so that one reader takes both.
std::string csv_lines(const std::string& scene, const std::vector<VariantResult>& results) {
    std::string lines;
    for (const VariantResult& result : results) {
        std::vector<Metric> metrics = result.metrics;
        if (result.phases) {
            const Phases& p = *result.phases;
            metrics.insert(metrics.end(),
                           {{"broad_ms", p.broad},
                            {"narrow_ms", p.narrow},
                            {"solve_ms", p.solve},
                            {"integrate_ms", p.integrate},
                            {"other_ms", p.other}});
        }
        if (result.given) {
            metrics.push_back({"substeps_mean", result.given->mean});
            metrics.push_back({"substeps_max", static_cast<double>(result.given->most)});
        }
        const Variant& variant = result.variant;
        for (const Metric& metric : metrics) {
            lines +=
                fmt::format("{},{},{},{:.5f},{:.3f},{},{:.6g},{},{:.3f},{:.3f}\n",
                            scene,
                            variant.settings.threads == 1
                                ? variant.engine
                                : fmt::format("{}-{}t", variant.engine, variant.settings.threads),
                            variant.bare ? 1 : variant.settings.substeps,
                            result.ms_per_frame,
                            result.ratio.value_or(0),
                            metric.name,
                            metric.value,
                            variant.settings.hz,
                            result.ratio_min,
                            result.ratio_max);
        }
    }
    return lines;
}

void print_list() {
    for (const SceneCase& known : scene_cases()) {
        std::cout << fmt::format("{:<10} {:>3} s  {}\n", known.name, known.seconds, known.metrics);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const Options options =
        options_of(std::vector<std::string_view>(arguments + 1, arguments + count));
    if (options.list) {
        print_list();
        return 0;
    }
    std::string csv =
        "scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value,hz,ratio_min,ratio_max\n";
    for (const std::string& name : options.scenes) {
        const Result<PeerScene> scene = load_peer_scene(
            PL_SOURCE_DIR, name, options.run.sleep ? SleepMode::EveryBody : SleepMode::AsInScene);
        if (!scene) stop(scene.error().message);
        const auto results =
            run_scene(*scene, *find_scene_case(name), variants_of(options), options.run);
        if (!results) stop(results.error().message);
        print(options.run.sleep ? fmt::format("{}, sleep on", name) : name, *results);
        csv += csv_lines(name, *results);
    }
    if (options.csv.empty()) return 0;
    const Result<Done> written = write_file_atomically(options.csv, csv);
    if (!written) stop(written.error().message);
    return 0;
}
