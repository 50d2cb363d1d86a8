#include "engine/study/report/scores.h"

#include "engine/study/report/contenders.h"
#include "engine/study/report/html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace plumbline::study {

namespace {

double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace

std::vector<Score> scores_of(const Findings& findings) {
    constexpr double kMiddle = 0.01;
    std::map<std::string, Score> scores;
    std::map<std::string, std::vector<double>> prices;
    for (const Subject& subject : findings.subjects) {
        const auto contenders = contenders_of(subject);
        const std::size_t winner = winner_at(contenders, kMiddle, kFirstMetric);
        for (std::size_t i = 0; i < contenders.size(); ++i) {
            const Contender& contender = contenders[i];
            const auto reaches = [&](double tolerance) {
                return cheapest_at(contender, tolerance, kFirstMetric) != nullptr ? 1 : 0;
            };
            Score& score = scores[contender.name];
            score.name = contender.name;
            ++score.subjects;
            score.reached_5 += reaches(0.05);
            score.reached_1 += reaches(kMiddle);
            score.reached_01 += reaches(0.001);
            score.cheapest_at_1 += i == winner ? 1 : 0;
            score.runs += static_cast<int>(contender.points.size());
            score.no_answer +=
                static_cast<int>(std::ranges::count_if(contender.points, [](const Point& point) {
                    return point.status != RunStatus::Done;
                }));
            const Point* own = cheapest_at(contender, kMiddle, kFirstMetric);
            if (own == nullptr) continue;
            const Point* least = cheapest_at(contenders[winner], kMiddle, kFirstMetric);
            if (least->cost.ms_per_s_min > 0) {
                prices[contender.name].push_back(own->cost.ms_per_s_min / least->cost.ms_per_s_min);
            }
        }
    }
    std::vector<Score> sorted;
    for (auto& [name, score] : scores) {
        score.median_price = median_of(prices[name]);
        sorted.push_back(score);
    }
    std::ranges::stable_sort(sorted, [](const Score& a, const Score& b) {
        return std::tuple(-a.reached_1, a.median_price) < std::tuple(-b.reached_1, b.median_price);
    });
    return sorted;
}

std::string score_table(const Findings& findings) {
    std::string rows;
    for (const Score& score : scores_of(findings)) {
        const auto number = [](const std::string& text) {
            return fmt::format("<td class=\"n\">{}</td>", text);
        };
        const auto share = [&](int reached) {
            return number(fmt::format("{} of {}", reached, score.subjects));
        };
        rows += fmt::format(
            "<tr><td>{}</td>{}{}{}{}{}<td class=\"n{}\">{} of {}</td></tr>\n",
            escape_html(score.name),
            share(score.reached_5),
            share(score.reached_1),
            share(score.reached_01),
            number(fmt::format("{}", score.cheapest_at_1)),
            number(score.median_price > 0 ? number_text(score.median_price) : "&#8211;"),
            score.no_answer > 0 ? " bad" : "",
            score.no_answer,
            score.runs);
    }
    if (rows.empty()) return rows;
    return fmt::format(
        "<div class=\"wide\"><table>\n<thead><tr><th>solver</th><th class=\"n\">within 5 %</th>"
        "<th class=\"n\">1 %</th><th class=\"n\">0.1 %</th><th class=\"n\">cheapest at 1 %</th>"
        "<th class=\"n\">price of 1 %</th><th class=\"n\">runs without answer</th></tr></thead>\n"
        "<tbody>{}</tbody></table></div>\n"
        "<p class=\"soft\">In how many subjects a setting of the solver comes within an error; in "
        "how many "
        "nobody does it cheaper; what it takes for 1 % where it gets there, as a multiple of the "
        "cheapest "
        "solver's cost (median of the subjects).</p>\n",
        rows);
}

}  // namespace plumbline::study
