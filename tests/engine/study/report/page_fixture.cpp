// Writes the pages of findings that hold everything awkward at once, for page.py to read: study.html, stability.html
// and empty.html, with the JSON of each beside it.
#include "engine/study/findings/findings_json.h"
#include "engine/study/report/page.h"
#include "tests/engine/study/findings/sample_findings.h"
#include "tests/engine/study/gallery/sample_cells.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

using namespace plumbline;

study::Subject awkward_subject() {
    study::Subject chain =
        test::sample_subject("scenes/of </script><script>alert(1)</script> & 'co'.toml");
    chain.title = "a chain hangs ]]> `date` $x {y}";
    chain.tier = study::Tier::SelfConverged;
    chain.metrics = {{"stretch at the end", "its length"}, {"energy <J>", "m g h"}};
    for (study::Point& point : chain.points) {
        point.cost.ms_per_s_min *= 40;
        point.errors.push_back(0);
    }
    chain.points[0].status = study::RunStatus::Exploded;
    chain.points[0].why = "faster than <1e4> m/s";
    chain.points[0].errors.clear();
    chain.points[1].errors = {std::nan(""), 0};
    chain.points[2].errors = {0, 0};
    chain.points[3].errors = {-3e5, HUGE_VAL};
    chain.points[4].cost = {};
    chain.notes = {"reference converged to 1e-6 & more"};
    return chain;
}

study::Findings awkward_findings() {
    study::Findings findings = test::sample_findings();
    findings.command = "plumbline study 'a & b' <\"c\">\x01\xFF";
    findings.complete = false;
    findings.clock_spread = 0.4;
    findings.subjects[0].peer_scene = "chainv";
    findings.subjects[0].metrics[0].name = "stretch at the end";
    findings.subjects[0].engines = {{.setting = {"jolt", 60, {{"iterations", 50}}},
                                     .title = "Jolt Physics",
                                     .text = "60 Hz, 50 iterations",
                                     .version = "9.9",
                                     .webassembly = true,
                                     .errors = {0.02},
                                     .cost = {.ms_per_s_min = 6}},
                                    {.setting = {"ode", 60, {}},
                                     .title = "ODE",
                                     .text = "60 Hz",
                                     .version = "0.1",
                                     .status = study::RunStatus::Refused,
                                     .why = "it lacks a cone"}};
    findings.subjects.push_back(awkward_subject());
    findings.subjects.emplace_back();
    findings.subjects.push_back(test::sample_subject("one point"));
    findings.subjects.back().points.resize(1);
    findings.images = {
        {.scene = "yard.toml",
         .width_px = 640,
         .height_px = 360,
         .samples_per_pixel = 16,
         .mean_luminance = 0.25,
         .rows = {{.name = "level <high>", .error = {.mean = 0.05, .rms = 0.1}, .cpu_ms = 50},
                  {.name = "level low", .error = {.mean = 0.1, .rms = 0.2}, .cpu_ms = 20}}}};
    judge(findings.images[0]);
    findings.effects = {{.scene = "yard.toml",
                         .seconds = 2,
                         .pairs = 6,
                         .rows = {{.name = "wind <1>",
                                   .caller = "[wind] (a.toml:3)",
                                   .domain = "step",
                                   .step_ms = {.mean = 0.5, .standard_error = 0.1, .pairs = 6},
                                   .frame_ms = {.mean = 0.001, .standard_error = 0.01, .pairs = 6},
                                   .calls = 120}}}};
    return findings;
}

bool write(const std::filesystem::path& file, const Result<std::string>& text) {
    if (!text) std::puts(text.error().message.c_str());
    std::ofstream(file) << (text ? *text : std::string());
    return text.ok();
}

bool write_study(const std::filesystem::path& folder,
                 const char* name,
                 const study::Findings& findings) {
    const std::filesystem::path file = folder / name;
    std::ofstream(file.string() + ".json") << study::findings_to_json(findings);
    return write(file.string() + ".html", study::study_page(findings));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const std::filesystem::path folder = arguments[1];
    const study::StabilityTable table = study::awkward_table();
    std::ofstream(folder / "stability.json") << study::stability_json(table);
    const bool is_written = write_study(folder, "study", awkward_findings()) &&
                            write_study(folder, "empty", {}) &&
                            write(folder / "stability.html", study::stability_page(table));
    return is_written ? 0 : 1;
}
