#include "engine/study/report/knob_lines.h"

#include "engine/study/report/setting_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {

namespace {

using SettingKnob = int Setting::*;

bool same_but(SettingKnob knob, const Setting& a, Setting b) {
    b.*knob = a.*knob;
    // With a fixed number of sub-steps the most that there may be means nothing.
    if (a.substeps > 0 && b.substeps > 0) b.substeps_max = a.substeps_max;
    return a == b;
}

/// All points that differ from `from` in `knob` alone, itself included, by rising knob.
std::vector<const Point*> along(std::span<const Point> points,
                                const Point& from,
                                SettingKnob knob) {
    std::vector<const Point*> line;
    for (const Point& point : points) {
        // No sub-steps at all means on demand: not a number to sort by.
        if (knob == &Setting::substeps &&
            (point.setting.substeps == 0 || from.setting.substeps == 0)) {
            continue;
        }
        if (same_but(knob, from.setting, point.setting)) line.push_back(&point);
    }
    std::ranges::stable_sort(line, {}, [knob](const Point* point) { return point->setting.*knob; });
    return line;
}

std::string name_of(const std::vector<const Point*>& line, SettingKnob knob) {
    const Setting& first = line.front()->setting;
    const Setting& last = line.back()->setting;
    const std::string who = fmt::format("{} {} Hz", contender_name(first), first.step_hz);
    if (knob == &Setting::substeps) {
        return fmt::format("{} x {} to {}", who, first.substeps, last.substeps);
    }
    return fmt::format("{}, {} to {} it", who, first.iterations, last.iterations);
}

}  // namespace

std::vector<KnobLine> knob_lines(std::span<const Point> points) {
    std::vector<KnobLine> lines;
    std::vector<const Point*> placed;
    const auto is_placed = [&](const Point& point) {
        return std::ranges::find(placed, &point) != placed.end();
    };
    const auto add = [&](KnobLine line) {
        placed.insert(placed.end(), line.points.begin(), line.points.end());
        lines.push_back(std::move(line));
    };
    for (const SettingKnob knob : {&Setting::step_hz, &Setting::substeps, &Setting::iterations}) {
        const bool is_of_rate = knob == &Setting::step_hz;
        for (const Point& point : points) {
            if (is_placed(point)) continue;
            std::vector<const Point*> line = along(points, point, knob);
            if (line.size() < 2) continue;
            std::string name = is_of_rate ? family_name(point.setting) : name_of(line, knob);
            add({std::move(name), is_of_rate, std::move(line)});
        }
    }
    for (const Point& point : points) {
        if (is_placed(point)) continue;
        add({fmt::format(
                 "{} {}", physics::solver_name(point.setting.solver), short_setting(point.setting)),
             false,
             {&point}});
    }
    return lines;
}

}  // namespace plumbline::study
