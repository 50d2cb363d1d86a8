#include "engine/app/frame_report.h"

#include "engine/core/process/process_memory.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/totals.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::app {
namespace {

using nlohmann::json;

constexpr std::size_t kRecentFrames = 120;
constexpr std::size_t kLongFrames = 5;
constexpr double kInterval_s = 5;

std::span<const float> last_of(const std::vector<float>& values) {
    return std::span(values).last(std::min(kRecentFrames, values.size()));
}

json to_json(const scene::Percentiles& values) {
    return {
        {"median", values.median}, {"p95", values.p95}, {"p99", values.p99}, {"max", values.max}};
}

nlohmann::json json_of_presses(const std::array<std::uint64_t, kActionCount>& presses) {
    nlohmann::json seen = nlohmann::json::object();
    for (std::size_t i = 0; i < kActionCount; ++i) {
        if (presses[i] > 0) seen[std::string(action_name(static_cast<Action>(i)))] = presses[i];
    }
    return seen;
}

template <class MenuFrames>
nlohmann::json json_of_menus(const MenuFrames& frames) {
    nlohmann::json menus = nlohmann::json::array();
    for (const auto& opened : frames)
        menus.push_back(
            {{"frame_ms", opened.frame_ms}, {"median_before_ms", opened.median_before_ms}});
    return menus;
}

json json_of_interval(const ReportInterval& interval) {
    return {{"end_s", interval.end_s},
            {"frames", interval.frames},
            {"process_cpu_ms_per_frame", interval.cpu_ms_per_frame},
            {"resident_bytes", interval.resident_bytes}};
}

template <class LongFrames>
nlohmann::json json_of_longest(const LongFrames& frames) {
    nlohmann::json longest = nlohmann::json::array();
    for (const auto& frame : frames) {
        nlohmann::json passes = nlohmann::json::object();
        for (const render::PassTiming& pass : frame.passes)
            passes[std::string(pass.name)] = pass.cpu_ms;
        longest.push_back({{"at_s", frame.at_s},
                           {"frame_ms", frame.frame_ms},
                           {"new_programs", frame.new_programs},
                           {"cpu_ms", passes}});
    }
    return longest;
}

}  // namespace

void FrameReport::add_frame(double wall_ms, const render::FrameStats& stats) {
    last_wall_s_ = wall_s();
    last_cpu_s_ = process_cpu_s();
    if (frames_ == 0) {
        startup_ms_ = (chosen_s_ ? last_wall_s_ - *chosen_s_ : seconds_since_process_start()) * 1e3;
        first_frame_wall_s_ = last_wall_s_;
        first_frame_cpu_s_ = last_cpu_s_;
        interval_cpu_s_ = last_cpu_s_;
    }
    if (std::exchange(opens_menu_, false) && frames_ > 0)
        menu_frames_.push_back({.frame_ms = static_cast<float>(wall_ms),
                                .median_before_ms = static_cast<float>(recent_frame_ms().median)});
    if (frames_ > 0) keep_if_long(static_cast<float>(wall_ms), stats);
    ++frames_;
    frame_ms_.push_back(static_cast<float>(wall_ms));
    for (const render::PassTiming& pass : stats.passes) {
        const auto [known, is_new] = passes_.try_emplace(std::string(pass.name));
        PassTotal& total = known->second;
        const double share = is_new ? 1.0 : scene::kShareOfNewest;
        total.recent_cpu_ms += share * (pass.cpu_ms - total.recent_cpu_ms);
        total.recent_gpu_ms += share * (pass.gpu_ms - total.recent_gpu_ms);
        total.cpu_ms += pass.cpu_ms;
        if (pass.gpu_ms >= 0.0) {
            total.gpu_ms += pass.gpu_ms;
            ++total.gpu_samples;
        }
    }
    shadow_rendered_ += stats.shadow_passes_rendered;
    shadow_cached_ += stats.shadow_passes_cached;
    last_ = stats;
    const double began_s = intervals_.empty() ? 0.0 : intervals_.back().end_s;
    if (last_wall_s_ - first_frame_wall_s_ - began_s < kInterval_s) return;
    intervals_.push_back(open_interval());
    interval_cpu_s_ = last_cpu_s_;
    interval_frames_ = frames_;
}

ReportInterval FrameReport::open_interval() const {
    const std::uint64_t frames = frames_ - interval_frames_;
    return {.end_s = last_wall_s_ - first_frame_wall_s_,
            .frames = frames,
            .cpu_ms_per_frame = (last_cpu_s_ - interval_cpu_s_) * 1e3 /
                                static_cast<double>(std::max<std::uint64_t>(frames, 1)),
            .resident_bytes = resident_bytes()};
}

void FrameReport::keep_if_long(float frame_ms, const render::FrameStats& stats) {
    const auto place = std::ranges::find_if(
        long_frames_, [&](const LongFrame& f) { return f.frame_ms < frame_ms; });
    if (place == long_frames_.end() && long_frames_.size() >= kLongFrames) return;
    long_frames_.insert(place,
                        {.at_s = last_wall_s_ - first_frame_wall_s_,
                         .frame_ms = frame_ms,
                         .new_programs = stats.new_programs,
                         .passes = stats.passes});
    if (long_frames_.size() > kLongFrames) long_frames_.pop_back();
}

scene::Percentiles FrameReport::recent_frame_ms() const {
    const std::span<const float> recent = recent_frames();
    return scene::percentiles_of({recent.begin(), recent.end()});
}

std::span<const float> FrameReport::recent_frames() const {
    return last_of(frame_ms_);
}

std::span<const float> FrameReport::recent_steps() const {
    return last_of(physics_.step_ms);
}

std::vector<render::PassTiming> FrameReport::recent_passes() const {
    std::vector<render::PassTiming> passes = last_.passes;
    for (render::PassTiming& pass : passes) {
        const PassTotal& total = passes_.at(std::string(pass.name));
        pass.cpu_ms = total.recent_cpu_ms;
        if (pass.gpu_ms >= 0.0) pass.gpu_ms = total.recent_gpu_ms;
    }
    return passes;
}

std::string FrameReport::json(const ReportContext& context) const {
    using nlohmann::json;
    const auto frames = static_cast<double>(std::max<std::uint64_t>(frames_, 1));
    json cpu = json::object();
    json gpu = json::object();
    for (const auto& [name, total] : passes_) {
        cpu[name] = total.cpu_ms / frames;
        // -1 where the driver has no timer: "not measured" must not look like "free".
        gpu[name] =
            total.gpu_samples > 0 ? total.gpu_ms / static_cast<double>(total.gpu_samples) : -1.0;
    }
    const double between_frames = std::max(1.0, frames - 1.0);
    json report = {
        {"scene", context.simulation.description().file.filename().string()},
        {"frames", frames_},
        {"seconds", last_wall_s_ - first_frame_wall_s_},
        {"startup_ms", startup_ms_},
        {"frame_ms", to_json(scene::percentiles_of(frame_ms_))},
        {"longest_frames", json_of_longest(long_frames_)},
        {"menu_opened", json_of_menus(menu_frames_)},
        {"cpu_ms", cpu},
        {"gpu_ms", gpu},
        {"process_cpu_ms_per_frame", (last_cpu_s_ - first_frame_cpu_s_) * 1e3 / between_frames},
        {"image",
         {{"level", image_.level},
          {"automatic", image_.is_automatic},
          {"render_scale",
           std::round(static_cast<double>(image_.quality.render_scale) * 1e3) / 1e3},
          {"gave_way", render::what_gave_way(image_.quality)}}},
        {"draw_calls", last_.draw_calls},
        {"triangles", last_.triangles},
        {"instances", last_.instances},
        {"shadow_passes_rendered", shadow_rendered_},
        {"shadow_passes_cached", shadow_cached_},
        {"shadowed_lights", last_.shadowed_lights},
        {"unshadowed_lights", last_.unshadowed_lights},
        {"physics", json::parse(scene::cost_json(physics_))},
        {"lost_time_s", context.lost_s},
        {"peak_rss_bytes", peak_resident_bytes()},
        {"bodies", body_count(context.simulation.physics)},
        {"gl",
         {{"vendor", context.gl.vendor},
          {"renderer", context.gl.renderer},
          {"version", context.gl.version}}},
        {"effects", json::parse(effects::ledger_json(context.ledger))},
        {"actions_seen", json_of_presses(context.presses_seen)}};
    for (const ReportInterval& interval : intervals_)
        report["intervals"].push_back(json_of_interval(interval));
    report["intervals"].push_back(json_of_interval(open_interval()));
    if (!context.before.empty()) report["before"] = json::parse(context.before);
    // A file's name may be no text.
    return report.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::app
