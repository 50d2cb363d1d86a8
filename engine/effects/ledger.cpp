#include "engine/effects/effect_runtime.h"
#include "engine/scene/formats/json_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::effects {

std::string ledger_json(const std::vector<LedgerLine>& ledger) {
    scene::JsonText json(scene::JsonLayout::OneLine);
    json.begin_array();
    for (const LedgerLine& line : ledger) {
        json.begin_object();
        json.key("name").text(line.name);
        json.key("called_for_by").begin_array();
        for (const std::string& caller : line.called_for_by) json.text(caller);
        json.end_array();
        json.key("constructions").number(line.constructions);
        json.key("calls").number(line.calls);
        json.key("cpu_ms").number(line.cpu_ms);
        json.key("gpu_ms").number(line.gpu_ms);
        json.key("bytes_cpu").number(line.bytes_cpu);
        json.key("bytes_gpu").number(line.bytes_gpu);
        json.end_object();
    }
    json.end_array();
    return json.str();
}

std::string ledger_table(const std::vector<LedgerLine>& ledger) {
    std::size_t width = std::string_view("effect").size();
    for (const LedgerLine& line : ledger) width = std::max(width, line.name.size());
    std::string table = fmt::format("{:<{}}  {:>5}  {:>8}  {:>9}  {:>9}  {:>10}  {:>10}  {}\n",
                                    "effect",
                                    width,
                                    "made",
                                    "calls",
                                    "CPU ms",
                                    "GPU ms",
                                    "CPU bytes",
                                    "GPU bytes",
                                    "called for by");
    for (const LedgerLine& line : ledger) {
        const std::string gpu_ms =
            line.gpu_ms < 0.0 ? std::string("unknown") : fmt::format("{:.3f}", line.gpu_ms);
        table += fmt::format("{:<{}}  {:>5}  {:>8}  {:>9.3f}  {:>9}  {:>10}  {:>10}  ",
                             line.name,
                             width,
                             line.constructions,
                             line.calls,
                             line.cpu_ms,
                             gpu_ms,
                             line.bytes_cpu,
                             line.bytes_gpu);
        if (line.called_for_by.empty()) table += "-";
        for (std::size_t i = 0; i < line.called_for_by.size(); ++i) {
            table += (i == 0 ? "" : ", ") + line.called_for_by[i];
        }
        table += '\n';
    }
    return table;
}

}  // namespace plumbline::effects
