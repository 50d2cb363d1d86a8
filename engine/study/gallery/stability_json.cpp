// The stability table as JSON, and as the page that shows it.
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/report/page.h"

#include <cstdint>

namespace plumbline::study {
namespace {

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = i + k;
            group = group << 8U | (at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool is_there = i + k <= bytes.size();
            text += is_there ? kDigits[group >> (18U - 6U * k) & 63U] : '=';
        }
    }
    return text;
}

Json known_red(const scene::HardCase& hard) {
    Json reds = Json::array();
    for (const scene::HardCaseRed& red : hard.known_red)
        reds.push_back({{"rule", red.rule},
                        {"reached", red.gone ? Json(nullptr) : Json(red.reached)},
                        {"why", red.why}});
    return reds;
}

Json run_json(const StabilityTable& table, const StabilityRun& run) {
    const scene::HardCase& hard = table.cases[run.entry].hard;
    Json json{{"case", hard.id},
              {"solver", run.stepped_by()},
              {"step_hz", run.step_hz},
              {"tier", hard.nightly ? "nightly" : "ci"}};
    if (run.engine != nullptr)
        json["lacks"] = run.lacks();
    else if (run.solver == physics::Solver::SmallStep && run.step_hz == kGameRate_hz)
        json["known_red"] = known_red(hard);
    json["result"] =
        run.result ? scene::read_json<Json>(case_result_json(*run.result)) : Json(nullptr);
    return json;
}

Json table_json(const StabilityTable& table) {
    Json json{{"command", table.command},
              {"machine", table.machine},
              {"build", table.build},
              {"made_on", table.made_on},
              {"complete", table.complete}};
    if (table.shard) json["shard"] = *table.shard;
    Json& cases = json["cases"] = Json::array();
    for (const CaseEntry& entry : table.cases)
        cases.push_back({{"id", entry.hard.id},
                         {"title", entry.title},
                         {"shows", entry.hard.shows},
                         {"known_to_fail", entry.hard.known_to_fail},
                         {"seconds", entry.hard.seconds},
                         {"nightly", entry.hard.nightly}});
    Json& runs = json["runs"] = Json::array();
    for (const StabilityRun& run : table.runs) runs.push_back(run_json(table, run));
    return json;
}

}  // namespace

std::string stability_json(const StabilityTable& table) {
    return text_of(table_json(table), 1) + "\n";
}

Result<std::string> stability_page(const StabilityTable& table) {
    Json json = table_json(table);
    json["no_images"] = table.no_images;
    Json& images = json["images"] = Json::object();
    for (std::size_t i = 0; i < table.images.size(); ++i) {
        if (!table.images[i].empty()) images[table.cases[i].hard.id] = base64(table.images[i]);
    }
    return report_page(text_of(json) + "\n");
}

}  // namespace plumbline::study
