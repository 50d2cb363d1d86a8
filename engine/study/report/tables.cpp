#include "engine/study/report/tables.h"

#include "engine/study/findings/pareto.h"
#include "engine/study/report/contenders.h"
#include "engine/study/report/html_text.h"
#include "engine/study/report/setting_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace plumbline::study {

namespace {

std::string cell(const std::string& text) {
    return fmt::format("<td>{}</td>", text);
}

std::string number_cell(const std::string& text) {
    return fmt::format("<td class=\"n\">{}</td>", text);
}

std::string heading(const std::vector<std::string>& names) {
    std::string row = "<tr>";
    for (const std::string& name : names) row += fmt::format("<th>{}</th>", escape_html(name));
    return row + "</tr>\n";
}

std::string table(const std::string& heads, const std::string& rows) {
    return fmt::format(
        "<div class=\"wide\"><table>\n<thead>{}</thead>\n<tbody>{}</tbody></table></div>\n",
        heads,
        rows);
}

std::string reach_cell(const Point* reached, bool is_best) {
    if (reached == nullptr) return "<td class=\"bad\">not reached</td>";
    const std::string cost = number_text(reached->cost.ms_per_s_min);
    return fmt::format("<td>{} ms/s <span class=\"soft\">{}</span></td>",
                       is_best ? fmt::format("<b>{}</b>", cost) : cost,
                       short_setting(reached->setting));
}

std::string budget_cell(const Point* best, std::size_t metric) {
    if (best == nullptr) return "<td class=\"bad\">nothing so cheap</td>";
    return fmt::format("<td>{} <span class=\"soft\">{}</span></td>",
                       error_text(error_of(*best, metric)),
                       short_setting(best->setting));
}

/// Both tables for one metric, or for the worst of all.
std::string cost_tables_of(const std::vector<Contender>& contenders,
                           std::size_t metric,
                           const std::string& metric_name) {
    std::array<std::size_t, kTolerances.size()> winners{};
    for (std::size_t i = 0; i < winners.size(); ++i) {
        winners[i] = winner_at(contenders, kTolerances[i], metric);
    }
    std::string reach;
    std::string budget;
    for (std::size_t who = 0; who < contenders.size(); ++who) {
        const Contender& contender = contenders[who];
        reach += "<tr>" + cell(contender.name);
        for (std::size_t i = 0; i < winners.size(); ++i) {
            reach += reach_cell(cheapest_at(contender, kTolerances[i], metric), winners[i] == who);
        }
        reach += "</tr>\n";
        budget += "<tr>" + cell(contender.name);
        for (const double budget_ms : kBudgets_ms) {
            budget += budget_cell(best_for(contender, budget_ms, metric), metric);
        }
        budget += "</tr>\n";
    }
    const std::string name = escape_html(metric_name);
    return fmt::format("<h3>Cost to reach an error: {}</h3>\n{}<h3>Error for a budget: {}</h3>\n{}",
                       name,
                       table(heading({"solver", "5 %", "1 %", "0.1 %"}), reach),
                       name,
                       table(heading({"solver", "0.1 ms a frame", "0.5 ms", "2 ms"}), budget));
}

std::string with_sentence(const KnobVerdict& verdict) {
    switch (verdict.trend) {
        case Trend::Converges: {
            if (!verdict.order) return "Pays: the error falls with each doubling.";
            std::string text = fmt::format("Pays: each doubling divides the error by about {}.",
                                           number_text(std::exp2(*verdict.order)));
            if (verdict.theory) {
                const bool agrees = std::abs(*verdict.order - *verdict.theory) <= 0.15;
                text += agrees ? " As theory says."
                               : fmt::format(" Theory says {}.",
                                             number_text(std::exp2(*verdict.theory)));
            }
            return text;
        }
        case Trend::Stalls:
            return "Stops paying: turn it further and the error stays where it is.";
        case Trend::Diverges:
            return "Harms: turn it further and the error grows.";
        case Trend::Exact:
            return "Nothing left to gain: the error is rounding already.";
        case Trend::TooFew:
            return "Too few runs gave an answer to tell.";
    }
    return {};
}

std::string metric_cells(const Subject& subject, const Point& point) {
    std::string cells;
    for (std::size_t i = 0; i < subject.metrics.size(); ++i) {
        const bool has_number = point.status == RunStatus::Done && i < point.errors.size();
        if (!has_number) {
            cells += number_cell("&#8211;");
            continue;
        }
        const double error = point.errors[i];
        cells += std::isfinite(error)
                     ? number_cell(error_text(error))
                     : fmt::format("<td class=\"n bad\">{}</td>", number_text(error));
    }
    return cells;
}

std::string point_row(const Subject& subject, const Point& point) {
    const bool is_done = point.status == RunStatus::Done;
    std::string status(status_name(point.status));
    if (!point.why.empty()) status += fmt::format(": {}", point.why);
    const RunCost& cost = point.cost;
    std::string row = is_done ? "<tr>" : "<tr class=\"bad\">";
    row += cell(escape_html(setting_text(point.setting)));
    row += cell(escape_html(status));
    row += metric_cells(subject, point);
    for (const double value : {cost.ms_per_s_min, cost.ms_per_s_median, cost.ms_per_s_max}) {
        row += number_cell(cost.repeats > 0 ? number_text(value) : "&#8211;");
    }
    row += number_cell(fmt::format("{}", cost.repeats));
    for (const double value : {cost.step_ms_median, cost.step_ms_p99, cost.work_per_s}) {
        row += number_cell(cost.repeats > 0 ? number_text(value) : "&#8211;");
    }
    return row + "</tr>\n";
}

}  // namespace

std::string anchor_of(std::size_t subject_index) {
    return fmt::format("s{}", subject_index + 1);
}

std::string_view tier_words(Tier tier) {
    switch (tier) {
        case Tier::ClosedForm:
            return "the exact answer is a formula";
        case Tier::TwoIntegrators:
            return "two independent integrators of high order agree on it to ten digits";
        case Tier::Conserved:
            return "something that must stay the same: energy, momentum, a symmetry";
        case Tier::SelfConverged:
            return "this engine itself, in float64 at a far smaller step, shown to converge: says "
                   "that a "
                   "result is consistent, not that it is right";
        case Tier::Spread:
            return "no truth at all: how far apart copies end that began a hair apart";
    }
    return {};
}

std::string tier_table() {
    std::string rows;
    for (const Tier tier : {Tier::ClosedForm,
                            Tier::TwoIntegrators,
                            Tier::Conserved,
                            Tier::SelfConverged,
                            Tier::Spread}) {
        rows += fmt::format("<tr>{}{}</tr>\n",
                            cell(escape_html(tier_name(tier))),
                            cell(escape_html(tier_words(tier))));
    }
    return table(heading({"tier", "what results are held against"}), rows);
}

std::string verdict_line(const Subject& subject) {
    const auto contenders = contenders_of(subject);
    if (contenders.empty()) return "No runs.";
    constexpr double kTolerance = 0.01;
    const std::size_t best = winner_at(contenders, kTolerance, kFirstMetric);
    if (best == contenders.size()) return "Nobody reaches 1 %.";
    const Point& point = *cheapest_at(contenders[best], kTolerance, kFirstMetric);
    std::string text = fmt::format("1 % costs {} ms/s with {} at {}",
                                   number_text(point.cost.ms_per_s_min),
                                   contenders[best].name,
                                   short_setting(point.setting));
    std::string missing;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        if (i == best) continue;
        const Point* reached = cheapest_at(contenders[i], kTolerance, kFirstMetric);
        if (reached == nullptr) {
            missing += fmt::format("{}{}", missing.empty() ? "" : ", ", contenders[i].name);
            continue;
        }
        text += fmt::format("; {} {}", contenders[i].name, number_text(reached->cost.ms_per_s_min));
    }
    text += missing.empty() ? "." : fmt::format("; not with {}.", missing);
    return text;
}

std::string contents_table(const Findings& findings) {
    std::string rows;
    for (std::size_t i = 0; i < findings.subjects.size(); ++i) {
        const Subject& subject = findings.subjects[i];
        rows += fmt::format("<tr><td><a href=\"#{}\">{}</a></td>{}{}{}</tr>\n",
                            anchor_of(i),
                            escape_html(subject.id.empty() ? "(no name)" : subject.id),
                            cell(escape_html(subject.title)),
                            cell(escape_html(tier_name(subject.tier).substr(0, 2))),
                            cell(escape_html(verdict_line(subject)) + failure_line(subject)));
    }
    return table(heading({"subject", "", "tier", "in one line"}), rows);
}

std::string verdict_table(const Subject& subject) {
    if (subject.verdicts.empty()) return {};
    std::string rows;
    for (const KnobVerdict& verdict : subject.verdicts) {
        const bool is_bad = verdict.trend == Trend::Diverges || verdict.trend == Trend::Stalls;
        rows += "<tr>" + cell(escape_html(physics::solver_name(verdict.solver)));
        rows += cell(escape_html(verdict.knob)) + cell(escape_html(verdict.held));
        rows += number_cell(verdict.order ? fmt::format("{:.2f}", *verdict.order) : "&#8211;");
        rows += number_cell(verdict.theory ? number_text(*verdict.theory) : "&#8211;");
        rows += number_cell(fmt::format("{}", verdict.halvings));
        rows += fmt::format("<td{}>{}</td>",
                            is_bad ? " class=\"bad\"" : "",
                            escape_html(trend_name(verdict.trend)));
        rows += cell(escape_html(with_sentence(verdict))) + "</tr>\n";
    }
    return table(
        heading({"solver", "knob", "held", "order", "theory", "doublings", "verdict", "in words"}),
        rows);
}

std::string cost_tables(const Subject& subject) {
    const auto contenders = contenders_of(subject);
    if (contenders.empty() || subject.metrics.empty()) return {};
    std::string tables = cost_tables_of(contenders, kFirstMetric, subject.metrics.front().name);
    if (subject.metrics.size() == 1) return tables;
    return fmt::format(
        "{}<details><summary>The same for the worst of all {} metrics</summary>\n{}"
        "</details>\n",
        tables,
        subject.metrics.size(),
        cost_tables_of(contenders, kWorstMetric, "the worst metric"));
}

std::string points_table(const Subject& subject) {
    if (subject.points.empty()) return "<p class=\"bad\">No run was made.</p>\n";
    std::vector<std::string> names{"setting", "status"};
    for (const Metric& metric : subject.metrics) names.push_back(metric.name);
    for (const char* name :
         {"ms/s least", "median", "most", "repeats", "step ms", "p99", "work/s"}) {
        names.emplace_back(name);
    }
    std::string rows;
    for (const Point& point : subject.points) rows += point_row(subject, point);
    return fmt::format("<details><summary>All {} runs</summary>\n{}</details>\n",
                       subject.points.size(),
                       table(heading(names), rows));
}

std::string peer_table(std::span<const PeerPoint> peers) {
    if (peers.empty()) return {};
    std::vector<PeerPoint> sorted(peers.begin(), peers.end());
    std::ranges::stable_sort(sorted, {}, &PeerPoint::cpu_ms_per_s);
    std::string rows;
    for (const PeerPoint& peer : sorted) {
        rows += fmt::format("<tr>{}{}{}{}</tr>\n",
                            cell(escape_html(peer.engine)),
                            number_cell(fmt::format("{}", 60 * peer.substeps)),
                            number_cell(number_text(peer.cpu_ms_per_s)),
                            number_cell(error_text(peer.error)));
    }
    return fmt::format(
        "<details><summary>All {} figures of other engines</summary>\n{}</details>\n",
        peers.size(),
        table(heading({"engine", "steps/s", "ms/s", "error"}), rows));
}

std::string failure_line(const Subject& subject) {
    std::map<std::string, int> failures;
    for (const Point& point : subject.points) {
        if (point.status != RunStatus::Done) ++failures[std::string(status_name(point.status))];
    }
    if (failures.empty()) return {};
    int total = 0;
    std::string kinds;
    for (const auto& [name, count] : failures) {
        total += count;
        kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, name);
    }
    return fmt::format("<p class=\"bad\">{} of {} runs failed: {}.</p>\n",
                       total,
                       subject.points.size(),
                       escape_html(kinds));
}

}  // namespace plumbline::study
