// One diagram on two logarithmic axes, as plain data, and the gnuplot script that draws it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

struct PlotPoint {
    double x{1};
    double y{1};
    std::string label;  ///< written beside it where there is room; may be empty
};

enum class Dash { None, Solid, Dashed, Dotted };

/// Symbols by gnuplot's numbers (`test` in gnuplot draws them).
enum class Symbol { None = 0, Cross = 2, Ring = 6, Dot = 7 };

struct Curve {
    std::string name;  ///< in the key; empty: not in the key
    std::string color{"#000000"};
    Dash dash{Dash::Solid};
    int symbol{static_cast<int>(Symbol::None)};
    double symbol_size{0.6};
    double width{1.4};
    std::vector<PlotPoint> points;
};

/// A line across the whole diagram, named at its end.
struct GuideLine {
    double at{1};
    std::string name;
};

struct Tick {
    double at{1};
    std::string text;
};

struct Axis {
    std::string name;
    double least{0.1};
    double most{10};
    std::vector<Tick> ticks;
    std::vector<GuideLine> guides;
};

struct Plot {
    std::string name;  ///< what it shows, for those who cannot see it
    Axis x;
    Axis y;
    std::vector<Curve> curves;  ///< drawn in this order, later ones on top
};

/// Width of every diagram; the height follows the key.
inline constexpr int kPlotWidth_px = 940;

/// The range widened to show at least `least_ratio` between its ends, with room at both; and the
/// powers of ten (1, 2, 5 in between where there are few) as ticks. `text` writes a tick.
Axis log_axis(
    std::string name, double least, double most, double least_ratio, std::string (*text)(double));

/// For gnuplot 5: writes SVG to its standard output. Points outside of the axes are left out; all
/// text is quoted so that none of it is read as a command.
std::string gnuplot_script(const Plot& plot);

}  // namespace plumbline::study
