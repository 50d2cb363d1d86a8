#include "engine/study/report/report.h"

#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/study/report/diagrams/diagrams.h"
#include "engine/study/report/diagrams/gnuplot.h"
#include "engine/study/report/html_text.h"
#include "engine/study/report/image_section.h"
#include "engine/study/report/page_parts.h"
#include "engine/study/report/peers.h"
#include "engine/study/report/scores.h"
#include "engine/study/report/tables.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

namespace {

constexpr double kDrawingLimit_s = 20;
constexpr std::size_t kMostPeerBytes = 16 * 1024 * 1024;

/// What a page is made with, and what turned out to be missing.
struct Tools {
    std::string gnuplot;
    std::vector<PeerRow> peers;
    std::string missing_drawing;  ///< why there are no diagrams; empty as long as they work
    std::string missing_peers;
};

Tools find_tools() {
    Tools tools;
    tools.gnuplot = gnuplot_program();
    // Asked once: a page of sixty subjects must not fail sixty times.
    const auto answer =
        run_gnuplot(tools.gnuplot, "set print '-'\nprint 'drawing'\n", kDrawingLimit_s);
    if (!answer) tools.missing_drawing = answer.error().message;

    const auto folders = find_data_folders();
    if (!folders) {
        tools.missing_peers = folders.error().message;
        return tools;
    }
    const auto csv = read_file(folders->assets / "data" / "peers.csv", kMostPeerBytes);
    if (!csv) {
        tools.missing_peers = csv.error().message;
        return tools;
    }
    auto rows = parse_peers(*csv);
    if (rows) {
        tools.peers = std::move(*rows);
    } else {
        tools.missing_peers = rows.error().message;
    }
    return tools;
}

std::string figure(const Plot& plot,
                   const std::string& id,
                   const std::string& caption,
                   const Tools& tools) {
    if (!tools.missing_drawing.empty()) return {};
    auto drawn = run_gnuplot(tools.gnuplot, gnuplot_script(plot), kDrawingLimit_s);
    if (drawn) drawn = inline_svg(*drawn, id, plot.name);
    if (!drawn) {
        return fmt::format("<p class=\"bad\">This diagram is missing: {}.</p>\n",
                           escape_html(drawn.error().message));
    }
    return fmt::format("<figure id=\"{}\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
                       id,
                       *drawn,
                       escape_html(caption));
}

std::string first_metric(const Subject& subject) {
    return subject.metrics.empty() ? std::string("no metric") : subject.metrics.front().name;
}

std::string figures(const Subject& subject,
                    std::span<const PeerPoint> peers,
                    const std::string& anchor,
                    const Tools& tools) {
    const std::string metric = first_metric(subject);
    std::string html;
    if (const auto plot = work_precision_plot(subject, peers)) {
        std::string caption = fmt::format("Error of the {} against cost.", metric);
        if (!peers.empty()) {
            caption += fmt::format(
                " Grey: other engines on the scene {}, measured elsewhere (assets/data/README.md).",
                subject.peer_scene);
        }
        html += figure(*plot, anchor + "-cost", caption, tools);
    }
    if (const auto plot = step_plot(subject)) {
        html += figure(*plot,
                       anchor + "-step",
                       fmt::format("Error of the {} against the step.", metric),
                       tools);
    }
    return html;
}

std::string metric_list(const Subject& subject) {
    std::string items;
    for (const Metric& metric : subject.metrics) {
        items += fmt::format("<li>{}{}</li>\n",
                             escape_html(metric.name),
                             metric.scale.empty()
                                 ? std::string()
                                 : fmt::format(", relative to {}", escape_html(metric.scale)));
    }
    return items.empty() ? items : fmt::format("<ul>\n{}</ul>\n", items);
}

std::string section(const Subject& subject, std::size_t index, const Tools& tools) {
    const std::string anchor = anchor_of(index);
    std::string html = fmt::format(
        "<section>\n<h2 id=\"{}\">{}{}{}</h2>\n<p>{}</p>\n"
        "<dl><dt>held against</dt><dd>{}</dd><dt>tier</dt><dd>{}: {}</dd>"
        "<dt>what is measured</dt><dd>{}</dd></dl>\n",
        anchor,
        escape_html(subject.id),
        subject.id.empty() || subject.title.empty() ? "" : ": ",
        escape_html(subject.title),
        escape_html(subject.set_up),
        escape_html(subject.reference),
        escape_html(tier_name(subject.tier)),
        escape_html(tier_words(subject.tier)),
        metric_list(subject));
    html += fmt::format("<p><b>{}</b></p>\n", escape_html(verdict_line(subject)));
    html += failure_line(subject);
    for (const std::string& note : subject.notes) {
        html += fmt::format("<p class=\"soft\">{}</p>\n", escape_html(note));
    }
    const auto peers = comparable_peers(tools.peers, subject.peer_scene, first_metric(subject));
    html += figures(subject, peers, anchor, tools);
    const std::string verdicts = verdict_table(subject);
    if (!verdicts.empty()) html += fmt::format("<h3>What turning a knob does</h3>\n{}", verdicts);
    html += cost_tables(subject);
    html += points_table(subject);
    html += peer_table(peers);
    return html + "</section>\n";
}

std::string section(const ImageFindings& findings, std::size_t index, const Tools& tools) {
    const std::string anchor = fmt::format("image{}", index);
    std::string html = fmt::format(
        "<section>\n<h2 id=\"{}\">The image of {}</h2>\n", anchor, escape_html(findings.scene));
    if (const auto plot = image_plot(findings))
        html += figure(*plot, anchor + "-cost", "Error of the image against cost.", tools);
    return html + image_table(findings) + "</section>\n";
}

std::string head(const Findings& findings, const Tools& tools) {
    std::string html = fmt::format(
        "<h1>What accuracy costs in time</h1>\n"
        "<dl><dt>machine</dt><dd>{}</dd><dt>build</dt><dd>{}</dd><dt>date</dt><dd>{}</dd>"
        "<dt>clock</dt><dd>the median of the repeats lies {} above the least (median over all "
        "runs)</dd>"
        "<dt>the same numbers</dt><dd><a href=\"findings.json\">findings.json</a>, "
        "<a href=\"findings.csv\">findings.csv</a></dd></dl>\n"
        "<p>To repeat it:</p>\n<pre>{}</pre>\n",
        escape_html(findings.machine),
        escape_html(findings.build),
        escape_html(findings.made_on),
        error_text(findings.clock_spread),
        escape_html(findings.command));
    if (!findings.complete) {
        html += "<p class=\"bad\">Interrupted: this page has what was done by then.</p>\n";
    }
    constexpr double kNoisy = 0.15;
    if (findings.clock_spread > kNoisy) {
        html +=
            "<p class=\"bad\">The clock of this machine was noisy while this ran: read the costs "
            "as "
            "rough, the errors and the work counts as exact.</p>\n";
    }
    if (!tools.missing_drawing.empty()) {
        html += fmt::format(
            "<p class=\"bad\">No diagrams: {}. The tables are complete; Debian's package "
            "gnuplot-nox "
            "draws the rest.</p>\n",
            escape_html(tools.missing_drawing));
    }
    if (!tools.missing_peers.empty()) {
        html += fmt::format("<p class=\"bad\">No grey points of other engines: {}.</p>\n",
                            escape_html(tools.missing_peers));
    }
    return html;
}

/// What all subjects came to, and how their sections are read.
std::string overview(const Findings& findings) {
    std::string html = "<h2 id=\"contents\">What came of it</h2>\n";
    html +=
        "<p>ms/s: milliseconds of one core for each second simulated. All errors are relative: 1 % "
        "of the scale that each section names.</p>\n";
    html += score_table(findings);
    html += findings.subjects.empty()
                ? std::string("<p class=\"bad\">No subject was studied.</p>\n")
                : contents_table(findings);
    html += how_to_read();
    return html + "<h3>What results are held against</h3>\n" + tier_table();
}

}  // namespace

Result<Done> write_report(const Findings& findings, const std::filesystem::path& folder) {
    const Tools tools = find_tools();
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>Plumbline: what accuracy costs in "
        "time</title>\n<style>{}</style>\n</head>\n<body>\n",
        page_style());
    html += head(findings, tools);
    if (!findings.subjects.empty() || findings.images.empty()) html += overview(findings);
    for (std::size_t i = 0; i < findings.images.size(); ++i) {
        html += section(findings.images[i], i, tools);
    }
    for (std::size_t i = 0; i < findings.subjects.size(); ++i) {
        html += section(findings.subjects[i], i, tools);
    }
    html += "</body>\n</html>\n";
    return write_output(folder / "report.html", html);
}

}  // namespace plumbline::study
