#include "engine/study/report/diagrams/gnuplot.h"

#include "engine/core/process/process.h"
#include "engine/study/report/html_text.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>
#include <utility>

namespace plumbline::study {

namespace {

constexpr std::size_t kMostBytes = 64ULL * 1024 * 1024;  // of an image

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// Without every <tag ...>...</tag> of that name.
std::string without(std::string text, const std::string& tag) {
    const std::string opening = fmt::format("<{}>", tag);
    const std::string closing = fmt::format("</{}>", tag);
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening)) {
        const std::size_t end = text.find(closing, at);
        if (end == std::string::npos) break;
        text.erase(at, end + closing.size() - at);
    }
    return text;
}

}  // namespace

std::string gnuplot_program() {
    const char* named = std::getenv("PLUMBLINE_GNUPLOT");
    return named != nullptr && *named != '\0' ? named : "gnuplot";
}

Result<std::string> run_gnuplot(const std::string& program,
                                const std::string& script,
                                double limit_s) {
    const Result<ChildOutput> drawn =
        output_of({.program = program, .arguments = {"-d", "-"}, .silent = true},
                  script,
                  kMostBytes,
                  limit_s);
    if (!drawn) return drawn.error();
    if (!drawn->end.good) return Error{fmt::format("{} {}", program, drawn->end.words)};
    if (drawn->bytes.empty()) return Error{fmt::format("{} drew nothing", program)};
    return drawn->bytes;
}

Result<std::string> inline_svg(const std::string& svg,
                               const std::string& prefix,
                               const std::string& name) {
    const std::size_t begin = svg.find("<svg");
    const std::size_t box = svg.find("viewBox=", begin);
    const std::size_t end = svg.rfind("</svg>");
    if (begin == std::string::npos || box == std::string::npos || end == std::string::npos ||
        box > end) {
        return Error{"gnuplot wrote something else than an image"};
    }
    std::string body = without(without(svg.substr(box, end - box), "title"), "desc");
    body = replaced(std::move(body), "id='", fmt::format("id='{}-", prefix));
    body = replaced(std::move(body), "id=\"", fmt::format("id=\"{}-", prefix));
    body = replaced(std::move(body), "href='#", fmt::format("href='#{}-", prefix));
    return fmt::format("<svg role=\"img\" aria-label=\"{}\" {}</svg>", escape_html(name), body);
}

}  // namespace plumbline::study
