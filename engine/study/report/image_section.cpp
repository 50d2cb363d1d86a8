#include "engine/study/report/image_section.h"

#include "engine/study/report/html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace plumbline::study {
namespace {

constexpr double kLeastRatio = 4.0;

bool can_be_drawn(const ImageRow& row) {
    return row.error.rms > 0.0 && row.cpu_ms > 0.0;
}

Curve curve_of(const ImageFindings& findings, bool unbeaten) {
    Curve curve{.name = unbeaten ? "nothing beats these" : "something else is cheaper and nearer",
                .color = unbeaten ? "#1f77b4" : "#888888",
                .dash = unbeaten ? Dash::Dotted : Dash::None,
                .symbol = static_cast<int>(unbeaten ? Symbol::Dot : Symbol::Ring)};
    for (const ImageRow& row : findings.rows) {
        if (row.unbeaten == unbeaten && can_be_drawn(row))
            curve.points.push_back({.x = row.cpu_ms, .y = row.error.rms, .label = row.name});
    }
    std::ranges::sort(curve.points, {}, &PlotPoint::x);
    return curve;
}

}  // namespace

std::optional<Plot> image_plot(const ImageFindings& findings) {
    std::vector<double> costs;
    std::vector<double> errors;
    for (const ImageRow& row : findings.rows) {
        if (!can_be_drawn(row)) continue;
        costs.push_back(row.cpu_ms);
        errors.push_back(row.error.rms);
    }
    if (costs.size() < 2) return {};
    const auto axis = [](std::string name, const std::vector<double>& values, auto text) {
        const auto [least, most] = std::ranges::minmax(values);
        return log_axis(std::move(name), least, most, kLeastRatio, text);
    };
    return Plot{.name = fmt::format("Error of the image of {} against its cost", findings.scene),
                .x = axis("CPU ms a frame", costs, number_text),
                .y = axis("rms error of light", errors, error_text),
                .curves = {curve_of(findings, false), curve_of(findings, true)}};
}

std::string image_table(const ImageFindings& findings) {
    std::string html = fmt::format(
        "<p>{} by {} pixels of level high, and what differs from it in one thing, against the mean "
        "of {} "
        "samples a pixel of which each is in the sun or not as an exact ray says. Errors are of "
        "linear "
        "light, relative to the mean luminance of the reference ({:.3f} of the screen's white). "
        "Rows "
        "in bold: none other is both cheaper and nearer to the reference.</p>\n"
        "<div class=\"wide\"><table>\n<thead><tr><th></th><th>rms error</th><th>mean error</th>"
        "<th>CPU ms a frame</th><th></th></tr></thead>\n<tbody>",
        findings.width_px,
        findings.height_px,
        findings.samples_per_pixel,
        findings.mean_luminance);
    for (const ImageRow& row : findings.rows) {
        const std::string name = escape_html(row.name);
        html += fmt::format(
            "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
            "<td>{}</td></tr>\n",
            row.unbeaten ? fmt::format("<b>{}</b>", name) : name,
            error_text(row.error.rms),
            error_text(row.error.mean),
            number_text(row.cpu_ms),
            escape_html(row.verdict));
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace plumbline::study
