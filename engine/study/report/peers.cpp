#include "engine/study/report/peers.h"

#include "engine/study/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace plumbline::study {

namespace {

constexpr std::string_view kHeading =
    "scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value";
constexpr std::size_t kFields = 7;

/// A figure of a peer scene that has the meaning of a metric of ours. `factor` makes it relative to
/// the metric's scale, which the comment names where it is not in the figure.
struct Comparable {
    std::string_view scene;
    std::string_view figure;
    std::string_view metric;
    double factor;
};

constexpr std::array<Comparable, 18> kComparable{{
    {"chainv", "stretch_end_pct", "stretch at the end", 0.01},
    {"chainh", "stretch_max_pct", "largest stretch", 0.01},
    {"bounce", "apex_end_err_pct", "last apex", 0.01},
    {"slideroll", "v_final_err_pct", "speed at the end", 0.01},
    {"slideroll", "x_err_max_mm", "place", 0.001 / 11.0610},  // of the way in 3 s, 11.0610 m
    {"dzhani", "orient_err_10s_deg", "orientation at 10 s", 1.0 / 180},  // of half a turn
    {"dzhani", "E_max_pct", "energy", 0.01},
    {"dzhani", "L_max_pct", "angular momentum", 0.01},
    {"stack", "drift_h_all", "sideways drift", 1},         // of an edge, 1 m
    {"pyramid", "drift_h_after1s", "creep after 1 s", 1},  // of an edge, 1 m
    {"heavy1", "pen_max", "largest penetration", 1},       // of an edge, 1 m
    {"heavy10", "pen_max", "largest penetration", 1},
    {"heavy100", "pen_max", "largest penetration", 1},
    {"heavy1000", "pen_max", "largest penetration", 1},
    {"arch", "sag_mm", "sag", 0.001},  // of a stone's depth, 1 m
    {"meshroll", "speed_err_pct", "speed at the end", 0.01},
    {"flatroll", "speed_err_pct", "speed at the end", 0.01},
    {"meshslide", "speed_err_pct", "speed at the end", 0.01},
}};

Error problem(std::size_t line, const std::string& what) {
    return {fmt::format("peers.csv line {}: {}", line, what), ExitCode::Refused};
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t comma = line.find(',');
        fields.push_back(line.substr(0, comma));
        if (comma == std::string_view::npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

template <class T>
std::optional<T> number_of(std::string_view text) {
    T value{};
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

Result<PeerRow> row_of(std::string_view line, std::size_t number) {
    const auto fields = fields_of(line);
    if (fields.size() != kFields) {
        return problem(number,
                       fmt::format("{} fields, expected {}: {}", fields.size(), kFields, kHeading));
    }
    for (const std::size_t text : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
        if (fields[text].empty())
            return problem(number, fmt::format("field {} is empty", text + 1));
    }
    const auto substeps = number_of<int>(fields[2]);
    const auto cost = number_of<double>(fields[3]);
    const auto ratio = number_of<double>(fields[4]);
    const auto value = number_of<double>(fields[6]);
    if (!substeps || *substeps < 1) {
        return problem(number, fmt::format("'{}' is no number of sub-steps", fields[2]));
    }
    if (!cost || !(*cost >= 0)) return problem(number, fmt::format("'{}' is no cost", fields[3]));
    if (!ratio) return problem(number, fmt::format("'{}' is no cost ratio", fields[4]));
    if (!value) return problem(number, fmt::format("'{}' is no value", fields[6]));
    return PeerRow{std::string(fields[0]),
                   std::string(fields[1]),
                   *substeps,
                   *cost,
                   *ratio,
                   std::string(fields[5]),
                   *value};
}

}  // namespace

Result<std::vector<PeerRow>> parse_peers(std::string_view csv) {
    std::vector<PeerRow> rows;
    bool has_heading = false;
    for (std::size_t number = 1; !csv.empty(); ++number) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        std::string_view line = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.empty() || line.front() == '#') continue;
        if (!has_heading) {
            if (line != kHeading)
                return problem(number, fmt::format("expected the heading {}", kHeading));
            has_heading = true;
            continue;
        }
        auto row = row_of(line, number);
        if (!row) return row.error();
        rows.push_back(std::move(*row));
    }
    if (!has_heading) return Error{"peers.csv is empty", ExitCode::Refused};
    return rows;
}

std::vector<PeerPoint> comparable_peers(std::span<const PeerRow> rows,
                                        std::string_view scene,
                                        std::string_view metric) {
    std::vector<PeerPoint> points;
    const auto same = std::ranges::find_if(kComparable, [&](const Comparable& one) {
        return one.scene == scene && one.metric == metric;
    });
    if (same == kComparable.end()) return points;
    const auto fell = [&](const PeerRow& row) {
        return std::ranges::any_of(rows, [&](const PeerRow& other) {
            return other.metric == "stands" && other.value == 0 && other.scene == row.scene &&
                   other.engine == row.engine && other.substeps == row.substeps;
        });
    };
    for (const PeerRow& row : rows) {
        if (row.scene != scene || row.metric != same->figure) continue;
        points.push_back({row.engine,
                          row.substeps,
                          row.cpu_ms_per_frame * kFrames_per_s,
                          std::max(std::abs(row.value) * same->factor, fell(row) ? 1.0 : 0.0)});
    }
    return points;
}

}  // namespace plumbline::study
