#include "engine/study/report/diagrams/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace plumbline::study {

namespace {

// Where things stand, in pixels from the top left corner.
constexpr double kLeft = 92;
constexpr double kRight = 700;
constexpr double kTop = 26;
constexpr double kBelow = 54;
constexpr int kLeastHeight = 470;
constexpr double kKeyRow = 18;
constexpr double kLetter = 6.1;  ///< mean width of one at 11 px
constexpr double kLine = 13;

struct Spot {
    double x{0};
    double y{0};
};

struct Box {
    double left{0};
    double top{0};
    double right{0};
    double bottom{0};
};

bool meet(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Single quotes: gnuplot reads nothing inside them but their doubling.
std::string in_quotes(std::string_view text) {
    std::string out = "'";
    for (const char letter : text) {
        if (letter == '\'') out += '\'';
        out += static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F ? ' ' : letter;
    }
    return out + "'";
}

/// Tick labels are printf formats.
std::string tick_in_quotes(std::string_view text) {
    std::string out;
    for (const char letter : text) {
        out += letter;
        if (letter == '%') out += '%';
    }
    return in_quotes(out);
}

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char letter) { return (static_cast<unsigned char>(letter) & 0xC0) != 0x80; }));
}

double share(const Axis& axis, double value) {
    return std::log(value / axis.least) / std::log(axis.most / axis.least);
}

bool inside(const Axis& axis, double value) {
    return std::isfinite(value) && value >= axis.least && value <= axis.most;
}

bool inside(const Plot& plot, const PlotPoint& point) {
    return inside(plot.x, point.x) && inside(plot.y, point.y);
}

int height_of(const Plot& plot) {
    const auto named =
        std::ranges::count_if(plot.curves, [](const Curve& curve) { return !curve.name.empty(); });
    const double key = kTop + kBelow + kKeyRow * static_cast<double>(named + 1);
    return std::max(kLeastHeight, static_cast<int>(key));
}

Spot spot_of(const Plot& plot, const PlotPoint& point) {
    const double bottom = height_of(plot) - kBelow;
    return {kLeft + (kRight - kLeft) * share(plot.x, point.x),
            bottom - (bottom - kTop) * share(plot.y, point.y)};
}

/// What labels must not cover: symbols, and the names of the guide lines.
std::vector<Box> obstacles(const Plot& plot) {
    std::vector<Box> boxes;
    for (const Curve& curve : plot.curves) {
        if (curve.symbol == static_cast<int>(Symbol::None)) continue;
        for (const PlotPoint& point : curve.points) {
            if (!inside(plot, point)) continue;
            const Spot spot = spot_of(plot, point);
            boxes.push_back({spot.x - 4, spot.y - 4, spot.x + 4, spot.y + 4});
        }
    }
    for (const GuideLine& guide : plot.y.guides) {
        const Spot spot = spot_of(plot, {plot.x.most, guide.at, {}});
        const double width = kLetter * static_cast<double>(letters(guide.name));
        boxes.push_back({spot.x - width - 4, spot.y - kLine, spot.x, spot.y});
    }
    for (const GuideLine& guide : plot.x.guides) {
        const Spot spot = spot_of(plot, {guide.at, plot.y.most, {}});
        const double length = kLetter * static_cast<double>(letters(guide.name));
        boxes.push_back({spot.x - kLine, spot.y, spot.x + 2, spot.y + length + 8});
    }
    return boxes;
}

struct Label {
    Spot at;  ///< left end, middle height
    std::string text;
    std::string color;
};

/// Each label beside its point where nothing is in the way; those without room are left out.
std::vector<Label> place_labels(const Plot& plot) {
    std::vector<Box> taken = obstacles(plot);
    std::vector<Label> placed;
    const double bottom = height_of(plot) - kBelow;
    for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
        for (const PlotPoint& point : curve->points) {
            if (point.label.empty() || !inside(plot, point)) continue;
            const Spot spot = spot_of(plot, point);
            const double width = kLetter * static_cast<double>(letters(point.label));
            const std::array<Spot, 6> tries{{{spot.x + 9, spot.y - 10},
                                             {spot.x - 9 - width, spot.y + 10},
                                             {spot.x + 9, spot.y + 10},
                                             {spot.x - 9 - width, spot.y - 10},
                                             {spot.x + 10, spot.y},
                                             {spot.x - 10 - width, spot.y}}};
            const auto box_at = [&](const Spot& at) {
                return Box{at.x - 1, at.y - kLine / 2, at.x + width + 1, at.y + kLine / 2};
            };
            const auto fits = [&](const Spot& at) {
                const Box box = box_at(at);
                if (box.left < kLeft || box.right > kRight) return false;
                if (box.top < kTop || box.bottom > bottom) return false;
                return std::ranges::none_of(taken,
                                            [&](const Box& other) { return meet(box, other); });
            };
            const auto found = std::ranges::find_if(tries, fits);
            if (found == tries.end()) continue;
            taken.push_back(box_at(*found));
            placed.push_back({*found, point.label, curve->color});
        }
    }
    return placed;
}

std::string axis_lines(const Axis& axis, char letter) {
    std::string ticks;
    for (const Tick& tick : axis.ticks) {
        if (!inside(axis, tick.at)) continue;
        ticks += fmt::format(
            "{}{} {:.9g}", ticks.empty() ? "" : ", ", tick_in_quotes(tick.text), tick.at);
    }
    const std::string range =
        fmt::format("set {}range [{:.9g}:{:.9g}]\n", letter, axis.least, axis.most);
    if (ticks.empty()) return range + fmt::format("unset {}tics\n", letter);
    return range + fmt::format("set {}tics nomirror ({})\n", letter, ticks);
}

/// At fixed places: gnuplot would push the upright one out of the image by long ticks.
std::string axis_names(const Plot& plot) {
    const double height = height_of(plot);
    return fmt::format(
        "set label {} at screen {:.5f}, screen {:.5f} center noenhanced\n"
        "set label {} at screen {:.5f}, screen {:.5f} center rotate by 90 noenhanced\n",
        in_quotes(plot.x.name),
        (kLeft + kRight) / 2 / kPlotWidth_px,
        12 / height,
        in_quotes(plot.y.name),
        16.0 / kPlotWidth_px,
        0.5 + (kBelow - kTop) / 2 / height);
}

std::string guide_lines(const Plot& plot) {
    std::string lines;
    const std::string_view style = "nohead back dt 2 lw 1 lc rgb '#999999'";
    const std::string_view text = "noenhanced tc rgb '#777777' font ',10'";
    for (const GuideLine& guide : plot.x.guides) {
        if (!inside(plot.x, guide.at)) continue;
        lines +=
            fmt::format("set arrow from first {0:.9g}, graph 0 to first {0:.9g}, graph 1 {1}\n",
                        guide.at,
                        style);
        lines += fmt::format(
            "set label {} at first {:.9g}, graph 0.99 right rotate by 90 offset char -1.1,0 {}\n",
            in_quotes(guide.name),
            guide.at,
            text);
    }
    for (const GuideLine& guide : plot.y.guides) {
        if (!inside(plot.y, guide.at)) continue;
        lines +=
            fmt::format("set arrow from graph 0, first {0:.9g} to graph 1, first {0:.9g} {1}\n",
                        guide.at,
                        style);
        lines +=
            fmt::format("set label {} at graph 0.995, first {:.9g} right offset 0,char 0.5 {}\n",
                        in_quotes(guide.name),
                        guide.at,
                        text);
    }
    return lines;
}

std::string label_lines(const Plot& plot) {
    std::string lines;
    const double height = height_of(plot);
    for (const Label& label : place_labels(plot)) {
        lines += fmt::format(
            "set label {} at screen {:.5f}, screen {:.5f} left noenhanced tc rgb {} font ',10'\n",
            in_quotes(label.text),
            label.at.x / kPlotWidth_px,
            1 - label.at.y / height,
            in_quotes(label.color));
    }
    return lines;
}

std::string curve_style(const Curve& curve) {
    const bool has_symbol = curve.symbol != static_cast<int>(Symbol::None);
    const bool has_line = curve.dash != Dash::None;
    const std::string_view with = has_symbol && has_line ? "linespoints"
                                  : has_symbol           ? "points"
                                                         : "lines";
    std::string style =
        fmt::format("with {} lc rgb {} lw {}", with, in_quotes(curve.color), curve.width);
    if (curve.dash == Dash::Dashed) style += " dt (8,5)";
    if (curve.dash == Dash::Dotted) style += " dt (2,4)";
    if (has_symbol) style += fmt::format(" pt {} ps {}", curve.symbol, curve.symbol_size);
    return style;
}

}  // namespace

Axis log_axis(
    std::string name, double least, double most, double least_ratio, std::string (*text)(double)) {
    double low = std::log10(least);
    double high = std::log10(most);
    const double missing = std::max(0.0, std::log10(least_ratio) - (high - low));
    const double room = 0.05 * (high - low + missing);
    low -= missing / 2 + room;
    high += missing / 2 + room;
    Axis axis{std::move(name), std::pow(10, low), std::pow(10, high), {}, {}};
    const bool is_wide = high - low > 2.2;
    const int stride = high - low > 9 ? 2 : 1;
    for (int decade = static_cast<int>(std::floor(low)); decade <= static_cast<int>(high) + 1;
         ++decade) {
        if (decade % stride != 0) continue;
        for (const double first : {1.0, 2.0, 5.0}) {
            if (first > 1 && is_wide) break;
            const double at = first * std::pow(10, decade);
            if (inside(axis, at)) axis.ticks.push_back({at, text(at)});
        }
    }
    return axis;
}

std::string gnuplot_script(const Plot& plot) {
    const int height = height_of(plot);
    std::string script = fmt::format(
        "set encoding utf8\n"
        "set terminal svg size {0},{1} noenhanced font 'sans-serif,11'\n"
        "set lmargin at screen {2:.5f}\nset rmargin at screen {3:.5f}\n"
        "set tmargin at screen {4:.5f}\nset bmargin at screen {5:.5f}\n"
        "set logscale xy\nset border 3\nset tics scale 0.6,0.3\n"
        "set key at screen {6:.5f}, screen {4:.5f} left top Left reverse samplen 2.4 spacing "
        "1.15\n",
        kPlotWidth_px,
        height,
        kLeft / kPlotWidth_px,
        kRight / kPlotWidth_px,
        1 - kTop / height,
        kBelow / height,
        (kRight + 14) / kPlotWidth_px);
    script += axis_lines(plot.x, 'x') + axis_lines(plot.y, 'y') + axis_names(plot);
    script += guide_lines(plot) + label_lines(plot);

    std::string curves;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        std::string rows;
        for (const PlotPoint& point : plot.curves[i].points) {
            if (inside(plot, point)) rows += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
        }
        if (rows.empty()) continue;
        script += fmt::format("$c{} << EOD\n{}EOD\n", i, rows);
        const std::string& name = plot.curves[i].name;
        curves += fmt::format("{}$c{} using 1:2 {} {}",
                              curves.empty() ? "plot " : ", \\\n  ",
                              i,
                              curve_style(plot.curves[i]),
                              name.empty() ? "notitle" : fmt::format("title {}", in_quotes(name)));
    }
    // Axes alone where there is nothing to draw.
    return script + (curves.empty() ? "plot 1/0 notitle" : curves) + "\n";
}

}  // namespace plumbline::study
