#include "engine/study/scenarios/scenario_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

std::string point_line(const Point& point, std::size_t metrics) {
    std::string line = fmt::format("  {:<42}", setting_text(point.setting));
    if (point.status != RunStatus::Done)
        return fmt::format("{} {}: {}\n", line, word_of(point.status), point.why);
    for (std::size_t i = 0; i < metrics; ++i) line += fmt::format(" {:>10.2e}", point.errors[i]);
    return fmt::format(
        "{} {:>10.4g} {:>10.4g}\n", line, point.cost.ms_per_s_min, point.cost.work_per_s);
}

std::string verdict_line(const Convergence& verdict) {
    const std::string order = verdict.order ? fmt::format("{:.2f}", *verdict.order) : "-";
    const std::string theory =
        verdict.theory ? fmt::format(", theory {:g}", *verdict.theory) : std::string();
    return fmt::format("  {:<14} {:<10} {:<36} {} (order {}{}, {} halvings)\n",
                       physics::solver_name(verdict.solver),
                       verdict.knob,
                       verdict.held,
                       word_of(verdict.trend),
                       order,
                       theory,
                       verdict.halvings);
}

}  // namespace

std::string subject_text(const Subject& subject) {
    std::string text = fmt::format("\n{}  {}  [{}]\n  {}\n  Reference: {}\n",
                                   subject.id,
                                   subject.title,
                                   word_of(subject.tier),
                                   subject.set_up,
                                   subject.reference);
    for (std::size_t i = 0; i < subject.metrics.size(); ++i)
        text += fmt::format("  e{}: {}, relative to {}\n",
                            i + 1,
                            subject.metrics[i].name,
                            subject.metrics[i].scale);
    text += fmt::format("  {:<42}", "setting");
    for (std::size_t i = 0; i < subject.metrics.size(); ++i)
        text += fmt::format(" {:>10}", fmt::format("e{}", i + 1));
    text += fmt::format(" {:>10} {:>10}\n", "ms/s", "work/s");
    for (const Point& point : subject.points) text += point_line(point, subject.metrics.size());
    if (!subject.euler_floor.empty()) {
        text += "  Euler floor of e1:";
        for (const FloorPoint& point : subject.euler_floor)
            text += fmt::format(" {:.2e} at {:.0f} Hz", point.error, 1 / point.step_s);
        text += '\n';
    }
    for (const Convergence& verdict : subject.verdicts) text += verdict_line(verdict);
    for (const std::string& note : subject.notes) text += fmt::format("  Note: {}\n", note);
    return text;
}

}  // namespace plumbline::study
