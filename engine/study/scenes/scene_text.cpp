#include "engine/study/scenes/scene_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

/// Another run of the same setting, or an hour later, took up to a tenth more.
constexpr double kOfBudget = 0.9;

std::string percent(double share) {
    return fmt::format("{:.3g} %", share * 100.0);
}

std::size_t widest_setting(const std::vector<Point>& points) {
    std::size_t width = std::string_view("setting").size();
    for (const Point& point : points) width = std::max(width, setting_text(point.setting).size());
    return width;
}

std::string table_of_points(const Subject& subject) {
    const std::size_t width = widest_setting(subject.points);
    std::string text = fmt::format("{:<{}}  {:>9}", "setting", width, "ms/frame");
    for (const Metric& metric : subject.metrics) text += fmt::format("  {:>14}", metric.name);
    text += fmt::format("  {:>10}\n", "worst");
    const std::vector<std::size_t> front = pareto_front(subject.points);
    for (std::size_t i = 0; i < subject.points.size(); ++i) {
        const Point& point = subject.points[i];
        text += fmt::format("{:<{}}", setting_text(point.setting), width);
        if (point.status != RunStatus::Done) {
            text += fmt::format("  {}: {}\n", word_of(point.status), point.why);
            continue;
        }
        text += fmt::format("  {:>9.4f}", ms_per_frame(point));
        for (const double error : point.errors) text += fmt::format("  {:>14}", percent(error));
        const bool in_front = std::ranges::find(front, i) != front.end();
        text += fmt::format("  {:>10}{}\n", percent(error_of(point)), in_front ? "  *" : "");
    }
    return fmt::format("{}* no other setting is both cheaper and more accurate\n", text);
}

/// Of other engines: what each setting costs and errs.
std::string table_of_engines(const Subject& subject) {
    if (subject.engines.empty()) return {};
    const auto name = [](const EnginePoint& point) {
        return fmt::format("{}{}{}, {}",
                           point.title,
                           point.version.empty() ? "" : " " + point.version,
                           point.webassembly ? " (wasm)" : "",
                           point.text);
    };
    std::size_t width = 0;
    for (const EnginePoint& point : subject.engines) width = std::max(width, name(point).size());
    std::string text = fmt::format("{:<{}}  {:>9}", "other engine", width, "ms/frame");
    for (const Metric& metric : subject.metrics) text += fmt::format("  {:>14}", metric.name);
    text += "\n";
    bool has_webassembly = false;
    for (const EnginePoint& point : subject.engines) {
        has_webassembly |= point.webassembly;
        text += fmt::format("{:<{}}", name(point), width);
        if (point.status != RunStatus::Done) {
            text += fmt::format("  {}: {}\n", word_of(point.status), point.why);
            continue;
        }
        text += fmt::format("  {:>9.4f}", point.cost.ms_per_s_min / kFrames_per_s);
        for (const double error : point.errors) text += fmt::format("  {:>14}", percent(error));
        text += "\n";
    }
    if (has_webassembly)
        text +=
            "wasm costs 1.3 to 2 times a native build; Jolt's package, built without SIMD, 5 to 6 "
            "times\n";
    return text + "\n";
}

/// What each number of threads takes of the cores and of the clock.
std::string table_of_threads(const Subject& subject) {
    if (subject.threads.empty()) return {};
    std::string text = fmt::format("{:>7}  {:>12}  {:>14}  {:>8}  result\n",
                                   "threads",
                                   "CPU ms/frame",
                                   "clock ms/frame",
                                   "speed-up");
    for (const ThreadsPoint& point : subject.threads) {
        text += fmt::format("{:>7}", point.threads);
        if (point.status != RunStatus::Done) {
            text += fmt::format("  {}: {}\n", word_of(point.status), point.why);
            continue;
        }
        const double first_ms = subject.threads.front().cost.clock_ms_per_s;
        text += fmt::format("  {:>12.4f}  {:>14.4f}  {:>8.2f}  {}\n",
                            point.cost.ms_per_s_min / kFrames_per_s,
                            point.cost.clock_ms_per_s / kFrames_per_s,
                            first_ms / point.cost.clock_ms_per_s,
                            point.same ? "same" : "another");
    }
    return text + "\n";
}

std::string pick_text(const Subject& subject, std::optional<std::size_t> pick) {
    return pick ? point_text(subject.points[*pick]) : std::string("none of these");
}

/// Files cannot choose the precision: the program has one.
std::vector<Point> pastable(const std::vector<Point>& points) {
    std::vector<Point> own = points;
    std::erase_if(own,
                  [](const Point& point) { return point.setting.precision != Precision::Float32; });
    return own;
}

bool nothing_measured(const Subject& subject) {
    return std::ranges::none_of(subject.points,
                                [](const Point& point) { return point.status == RunStatus::Done; });
}

}  // namespace

std::string point_text(const Point& point) {
    return fmt::format("{}: {} off, {:.4f} ms a frame",
                       setting_text(point.setting),
                       percent(error_of(point)),
                       ms_per_frame(point));
}

std::optional<Choice> choose(const SceneStudy& study, const Wish& wish) {
    const std::vector<Point> own = pastable(study.subject.points);
    std::optional<Choice> found;
    if (wish.budget_ms) {
        found = choose_for_budget(own, kOfBudget * *wish.budget_ms);
        if (found && !found->met) found = choose_for_budget(own, *wish.budget_ms);
    } else {
        const double tolerance = wish.tolerance.value_or(kUsualTolerance);
        found = choose_for_tolerance(
            own, std::max(0.5 * tolerance, tolerance - study.subject.uncertainty));
        // Nothing within the tightened one: then what is within the one asked for.
        if (found && !found->met) found = choose_for_tolerance(own, tolerance);
    }
    if (!found) return {};
    const Setting& setting = own[found->point].setting;
    const auto place = std::ranges::find(study.subject.points, setting, &Point::setting);
    return Choice{static_cast<std::size_t>(place - study.subject.points.begin()), found->met};
}

std::string wish_text(const SceneStudy& study, const Wish& wish) {
    const std::optional<Choice> choice = choose(study, wish);
    if (!choice) return "# no setting completed this scene, so none is recommended\n";
    const Point& point = study.subject.points[choice->point];
    std::string head;
    if (!choice->met) {
        head = wish.budget_ms
                   ? fmt::format("# no setting stays under {:g} ms a frame; this is the cheapest\n",
                                 *wish.budget_ms)
                   : fmt::format("# no setting stays under {}; this is the best seen\n",
                                 percent(wish.tolerance.value_or(kUsualTolerance)));
    }
    return fmt::format("{}# {}\n{}", head, point_text(point), accuracy_lines(point.setting));
}

std::string scene_study_text(const SceneStudy& study) {
    const Subject& subject = study.subject;
    std::string text = fmt::format("{} ({})\n{}\n", subject.title, subject.id, subject.set_up);
    text += fmt::format("Reference: {} ({})\n", subject.reference, word_of(subject.tier));
    for (const std::string& note : subject.notes) text += fmt::format("  {}\n", note);
    if (subject.points.empty()) return text + "No setting was measured.\n";
    if (nothing_measured(subject)) {
        text += "Every setting ended early, so there is nothing to compare:\n";
        for (const Point& point : subject.points)
            text += fmt::format(
                "  {}: {}, {}\n", setting_text(point.setting), word_of(point.status), point.why);
        return text;
    }
    text += "Errors are shares of: ";
    for (std::size_t i = 0; i < subject.metrics.size(); ++i)
        text += fmt::format(
            "{}{} of {}", i == 0 ? "" : "; ", subject.metrics[i].name, subject.metrics[i].scale);
    text += fmt::format(".\n\n{}\n{}{}Cost to reach\n",
                        table_of_points(subject),
                        table_of_engines(subject),
                        table_of_threads(subject));
    for (const double tolerance : {0.05, 0.01, 0.001})
        text += fmt::format("  {:>6}  {}\n",
                            percent(tolerance),
                            pick_text(subject, cheapest_within(subject.points, tolerance)));
    text += "Error at a budget\n";
    for (const double budget_ms : {0.1, 0.5, 2.0})
        text += fmt::format("  {:>3} ms a frame  {}\n",
                            budget_ms,
                            pick_text(subject, most_accurate_within(subject.points, budget_ms)));
    text += "Settings that no other beats\n";
    for (const std::size_t i : pareto_front(subject.points))
        text += fmt::format("  {}\n", point_text(subject.points[i]));
    return fmt::format("{}Paste under [accuracy]\n{}", text, wish_text(study, {}));
}

}  // namespace plumbline::study
