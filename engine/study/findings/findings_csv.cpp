#include "engine/core/text/csv.h"
#include "engine/study/findings/findings_json.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::study {
namespace {

constexpr std::string_view kCsvHeading =
    "subject,metric,scale,tier,solver,step_hz,substeps,substeps_max,iterations,precision,status,"
    "why,"
    "error,ms_per_s_min,ms_per_s_median,ms_per_s_max,repeats,step_ms_median,step_ms_p99,"
    "work_per_s,step_ms_max,frame_ms_p99,frame_ms_max,bodies,peak_bytes,"
    "clock_ms_per_s,effects\n";

std::string line_of(const Subject& subject,
                    const Metric& metric,
                    const Point& point,
                    double error) {
    const Setting& setting = point.setting;
    const RunCost& cost = point.cost;
    const std::string what = fmt::format("{},{},{},{}",
                                         csv_field(subject.id),
                                         csv_field(metric.name),
                                         csv_field(metric.scale),
                                         word_of(subject.tier));
    const std::string how = fmt::format("{},{},{},{},{},{},{},{}",
                                        physics::solver_name(setting.solver),
                                        setting.step_hz,
                                        setting.substeps,
                                        setting.substeps_max,
                                        setting.iterations,
                                        word_of(setting.precision),
                                        word_of(point.status),
                                        csv_field(point.why));
    const std::string found = std::isfinite(error) ? fmt::format("{}", error) : std::string();
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       what,
                       how,
                       found,
                       cost.ms_per_s_min,
                       cost.ms_per_s_median,
                       cost.ms_per_s_max,
                       cost.repeats,
                       cost.step_ms_median,
                       cost.step_ms_p99,
                       cost.work_per_s,
                       cost.step_ms_max,
                       cost.frame_ms_p99,
                       cost.frame_ms_max,
                       cost.bodies,
                       cost.peak_bytes,
                       cost.clock_ms_per_s,
                       csv_field(fidelity_text(setting)));
}

}  // namespace

std::string findings_to_csv(const Findings& findings) {
    std::string csv(kCsvHeading);
    for (const Subject& subject : findings.subjects) {
        for (const Point& point : subject.points) {
            for (std::size_t i = 0; i < subject.metrics.size(); ++i) {
                const double error = i < point.errors.size() ? point.errors[i] : std::nan("");
                csv += line_of(subject, subject.metrics[i], point, error);
            }
        }
    }
    return csv;
}

}  // namespace plumbline::study
