// The stability table as one self-contained HTML page.
#include "engine/scene/state_report.h"
#include "engine/study/gallery/stability.h"
#include "engine/study/report/html_text.h"

#include <fmt/format.h>

#include <cstdint>

namespace plumbline::study {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --line: #8884; --good: #2e7d3233; --bad: #c6282840; --off: #8882; }
body { font: 15px/1.45 system-ui, sans-serif; margin: 0 auto; max-width: 92rem; padding: 1.5rem; }
h1 { margin-bottom: 0.2rem; }
p { max-width: 52rem; }
table { border-collapse: collapse; width: 100%; }
th, td { border: 1px solid var(--line); padding: 0.35rem 0.5rem; vertical-align: top; text-align: left; }
thead th { position: sticky; top: 0; background: Canvas; }
.sum { width: auto; }
.sum td, .num { text-align: right; font-variant-numeric: tabular-nums; }
td.pass { background: var(--good); } td.fail { background: var(--bad); } td.none { background: var(--off); }
td.pass, td.fail, td.none { min-width: 8.2rem; font-size: 0.85rem; }
.case { min-width: 17rem; } .case b { font-size: 1.05rem; }
.who { font-size: 0.85rem; opacity: 0.8; }
img { display: block; width: 240px; height: 150px; border-radius: 4px; }
details { margin: 0.2rem 0; } summary { cursor: pointer; }
.rules { width: auto; font-size: 0.85rem; } .known { font-style: italic; }
)";

constexpr const char* kIntroduction = R"(<p>Each row is a scene that is known to make
physics engines fall over, fly apart, tunnel or creep; the text under its name says what it shows and
who is known to fail it. Each scene states its own pass rules as numbers. A cell is one solver at the game's setting: <b>pass</b> when every rule held to the end,
<b>FAIL</b> when one did not. Below the verdict: how far the worst rule stayed inside its limit, or went
outside, as a share of that limit; then the CPU time that one simulated second cost, so that nobody can
buy a green cell unseen, and what the solver did beside solving: energy that its guard took out, bodies that it slowed. A
case from which the guard took more than 1 % of its energy is red. Red cells are left in, our own too. The images show where small_step
ends.</p>)";

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

const char* cell_class(const CaseResult& result) {
    return result.passed ? "pass" : result.gave_up ? "none" : "fail";
}

std::string cell(const StabilityRun* run) {
    if (run == nullptr || !run->result) return "<td class=\"none\">not run</td>";
    const CaseResult& result = *run->result;
    if (!result.ran)
        return fmt::format("<td class=\"{}\"><b>{}</b><br>{}</td>",
                           cell_class(result),
                           verdict_word(result),
                           escape_html(result.why));
    const RuleResult* worst = result.worst();
    const std::string done = scene::interventions_text(result.interventions);
    return fmt::format("<td class=\"{}\"><b>{}</b> {}<br>{}<br>{:.2f} ms/s{}{}</td>",
                       cell_class(result),
                       verdict_word(result),
                       worst != nullptr ? margin_text(worst->margin) : "",
                       !result.why.empty() ? escape_html(result.why)
                       : worst != nullptr  ? escape_html(worst->text)
                                           : "",
                       result.cpu_ms_per_s,
                       done.empty() ? "" : "<br>",
                       done);
}

std::string summary(const StabilityTable& table) {
    std::string text = "<table class=\"sum\"><thead><tr><th>solver</th>";
    for (const int rate_hz : table.rates_hz) text += fmt::format("<th>{} Hz</th>", rate_hz);
    text += "</tr></thead>";
    for (const physics::Solver solver : table.solvers) {
        text += fmt::format("<tr><th>{}</th>", physics::solver_name(solver));
        for (const int rate_hz : table.rates_hz) {
            int green = 0;
            int ran = 0;
            for (const StabilityRun& run : table.runs) {
                if (run.solver != solver || run.step_hz != rate_hz || !run.result) continue;
                ++ran;
                green += run.green() ? 1 : 0;
            }
            text += fmt::format("<td>{} of {} pass</td>", green, ran);
        }
        text += "</tr>";
    }
    return text + "</table>";
}

std::string rules_of(const StabilityTable& table, std::size_t entry) {
    std::string text =
        "<details><summary>every rule, every solver</summary><table class=\"rules\">";
    text +=
        "<tr><th>solver</th><th>rule</th><th>worst value</th><th>margin</th><th>of, at</th></tr>";
    for (const StabilityRun& run : table.runs) {
        if (run.entry != entry || !run.result) continue;
        for (const RuleResult& rule : run.result->rules) {
            text += fmt::format(
                "<tr><td>{} {} Hz</td><td>{}</td><td class=\"num\">{}</td><td class=\"{}\">{}</td>"
                "<td>{} {:.2f} s</td></tr>",
                physics::solver_name(run.solver),
                run.step_hz,
                escape_html(rule.text),
                number_text(rule.value),
                rule.passed ? "pass" : "fail",
                margin_text(rule.margin),
                escape_html(rule.worst_of),
                rule.worst_at_s);
        }
    }
    return text + "</table></details>";
}

std::string row(const StabilityTable& table, std::size_t entry) {
    const CaseEntry& shown = table.cases[entry];
    const std::string& png = table.images[entry];
    std::string text = fmt::format("<tr id=\"{}\"><td>", shown.hard.id);
    if (!png.empty())
        text += fmt::format("<img alt=\"{} at the end\" src=\"data:image/png;base64,{}\">",
                            escape_html(shown.title),
                            base64(png));
    text += fmt::format(
        "</td><td class=\"case\"><b>{}</b> {}<br>{} <span class=\"who\">{:g} s{}.</span>",
        shown.hard.id,
        escape_html(shown.title),
        escape_html(shown.hard.shows),
        shown.hard.seconds,
        shown.hard.nightly ? ", nightly" : "");
    if (!shown.hard.known_to_fail.empty())
        text += fmt::format("<p class=\"who\">Known to fail: {}.</p>",
                            escape_html(shown.hard.known_to_fail));
    for (const scene::HardCaseRed& red : shown.hard.known_red)
        text += fmt::format("<p class=\"known\">small_step fails \"{}\", it reaches {}: {}</p>",
                            escape_html(red.rule),
                            red.gone ? "nothing: a body is gone" : number_text(red.reached),
                            escape_html(red.why));
    text += rules_of(table, entry) + "</td>";
    for (const physics::Solver solver : table.solvers) {
        for (const int rate_hz : table.rates_hz) text += cell(table.find(entry, solver, rate_hz));
    }
    return text + "</tr>\n";
}

}  // namespace

std::string stability_page(const StabilityTable& table) {
    std::string page = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width\">"
        "<title>Plumbline: hard cases</title><style>{}</style></head><body>\n"
        "<h1>Which hard cases hold</h1>\n",
        kStyle);
    page += kIntroduction;
    page += fmt::format("<p class=\"who\">{}, {}; {}; {}<br>To repeat: <code>{}</code></p>\n",
                        escape_html(table.made_on),
                        escape_html(table.machine),
                        escape_html(table.build),
                        table.complete ? "complete" : "interrupted: what was done by then",
                        escape_html(table.command));
    if (!table.no_images.empty())
        page += fmt::format("<p><b>{}</b></p>\n", escape_html(table.no_images));
    page += summary(table);
    page += "<p></p>\n<table><thead><tr><th>small_step at the end</th><th>case</th>";
    for (const physics::Solver solver : table.solvers) {
        for (const int rate_hz : table.rates_hz)
            page += fmt::format("<th>{}<br>{} Hz</th>", physics::solver_name(solver), rate_hz);
    }
    page += "</tr></thead><tbody>\n";
    for (std::size_t entry = 0; entry < table.cases.size(); ++entry) page += row(table, entry);
    return page + "</tbody></table></body></html>\n";
}

}  // namespace plumbline::study
