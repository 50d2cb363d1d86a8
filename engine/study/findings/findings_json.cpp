#include "engine/study/findings/findings_json.h"

#include "engine/core/hash.h"
#include "engine/scene/formats/json_read.h"
#include "engine/study/findings/findings_json_impl.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace plumbline::study {
namespace {

constexpr std::array kTiers{
    Tier::ClosedForm, Tier::TwoIntegrators, Tier::Conserved, Tier::SelfConverged, Tier::Spread};
constexpr std::array kStatuses{RunStatus::Done,
                               RunStatus::NotFinite,
                               RunStatus::Exploded,
                               RunStatus::TimedOut,
                               RunStatus::Crashed,
                               RunStatus::Refused};
constexpr std::array kTrends{
    Trend::Converges, Trend::Stalls, Trend::Diverges, Trend::Exact, Trend::TooFew};
constexpr std::array kPrecisions{Precision::Float32, Precision::Float64};

/// The one of `known` that has this name.
template <class T, std::size_t N>
T named(const Json& json, const std::array<T, N>& known, std::string_view (*name)(T)) {
    const std::string word = json;
    for (const T each : known) {
        if (name(each) == word) return each;
    }
    throw std::runtime_error(fmt::format("unknown word \"{}\"", word));
}

template <class T>
std::vector<T> list_from(const Json& json, T (*one)(const Json&)) {
    std::vector<T> list;
    for (const Json& each : json) list.push_back(one(each));
    return list;
}

Json json_of(const std::optional<double>& number) {
    return number ? study::json_of(*number) : Json(nullptr);
}

std::optional<double> optional_from(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional<double>(json.get<double>());
}

Json json_of(const Metric& metric) {
    return {{"name", metric.name}, {"scale", metric.scale}};
}

Metric metric_from(const Json& json) {
    return {.name = json.at("name"), .scale = json.at("scale")};
}

Json json_of(const FloorPoint& point) {
    return {{"step_s", point.step_s}, {"error", study::json_of(point.error)}};
}

FloorPoint floor_from(const Json& json) {
    return {.step_s = json.at("step_s"), .error = number_from(json.at("error"))};
}

Json json_of(const RunCost& cost) {
    return {{"ms_per_s_min", cost.ms_per_s_min},
            {"ms_per_s_median", cost.ms_per_s_median},
            {"ms_per_s_max", cost.ms_per_s_max},
            {"repeats", cost.repeats},
            {"step_ms_median", cost.step_ms_median},
            {"step_ms_p99", cost.step_ms_p99},
            {"step_ms_max", cost.step_ms_max},
            {"frame_ms_p99", cost.frame_ms_p99},
            {"frame_ms_max", cost.frame_ms_max},
            {"bodies", cost.bodies},
            {"peak_bytes", cost.peak_bytes},
            {"work_per_s", cost.work_per_s}};
}

RunCost cost_from(const Json& json) {
    return {.ms_per_s_min = json.at("ms_per_s_min"),
            .ms_per_s_median = json.at("ms_per_s_median"),
            .ms_per_s_max = json.at("ms_per_s_max"),
            .repeats = json.at("repeats"),
            .step_ms_median = json.at("step_ms_median"),
            .step_ms_p99 = json.at("step_ms_p99"),
            .step_ms_max = json.at("step_ms_max"),
            .frame_ms_p99 = json.at("frame_ms_p99"),
            .frame_ms_max = json.at("frame_ms_max"),
            .bodies = json.at("bodies"),
            .peak_bytes = json.at("peak_bytes"),
            .work_per_s = json.at("work_per_s")};
}

Json json_of(const Convergence& verdict) {
    return {{"knob", verdict.knob},
            {"solver", physics::solver_name(verdict.solver)},
            {"held", verdict.held},
            {"trend", trend_name(verdict.trend)},
            {"order", json_of(verdict.order)},
            {"theory", json_of(verdict.theory)},
            {"halvings", verdict.halvings}};
}

physics::Solver solver_from(const Json& json) {
    const std::string name = json;
    const std::optional<physics::Solver> solver = physics::solver_from_name(name);
    if (!solver) throw std::runtime_error(fmt::format("unknown solver \"{}\"", name));
    return *solver;
}

Convergence verdict_from(const Json& json) {
    return {.knob = json.at("knob"),
            .solver = solver_from(json.at("solver")),
            .held = json.at("held"),
            .trend = named(json.at("trend"), kTrends, trend_name),
            .order = optional_from(json.at("order")),
            .theory = optional_from(json.at("theory")),
            .halvings = json.at("halvings")};
}

Json json_of(const Difference& difference) {
    return {{"mean", study::json_of(difference.mean)},
            {"standard_error", study::json_of(difference.standard_error)},
            {"pairs", difference.pairs}};
}

Difference difference_from(const Json& json) {
    return {.mean = number_from(json.at("mean")),
            .standard_error = number_from(json.at("standard_error")),
            .pairs = json.at("pairs")};
}

Json json_of(const ImageRow& row) {
    return {{"name", row.name},
            {"rms_error", study::json_of(row.error.rms)},
            {"mean_error", study::json_of(row.error.mean)},
            {"cpu_ms", study::json_of(row.cpu_ms)},
            {"more_ms", json_of(row.more_ms)},
            {"unbeaten", row.unbeaten},
            {"verdict", row.verdict}};
}

ImageRow image_row_from(const Json& json) {
    return {.name = json.at("name"),
            .error = {.mean = number_from(json.at("mean_error")),
                      .rms = number_from(json.at("rms_error"))},
            .cpu_ms = number_from(json.at("cpu_ms")),
            .more_ms = difference_from(json.at("more_ms")),
            .unbeaten = json.at("unbeaten"),
            .verdict = json.at("verdict")};
}

Json json_of(const EffectCost& cost) {
    return {{"name", cost.name},
            {"caller", cost.caller},
            {"domain", cost.domain},
            {"step_ms", json_of(cost.step_ms)},
            {"frame_ms", json_of(cost.frame_ms)},
            {"calls", cost.calls},
            {"bytes_cpu", cost.bytes_cpu},
            {"bytes_gpu", cost.bytes_gpu}};
}

EffectCost effect_cost_from(const Json& json) {
    return {.name = json.at("name"),
            .caller = json.at("caller"),
            .domain = json.at("domain"),
            .step_ms = difference_from(json.at("step_ms")),
            .frame_ms = difference_from(json.at("frame_ms")),
            .calls = json.at("calls"),
            .bytes_cpu = json.at("bytes_cpu"),
            .bytes_gpu = json.at("bytes_gpu")};
}

Json json_of(const ImageFindings& findings);
Json json_of(const EffectFindings& findings);

template <class T>
Json array_of(const std::vector<T>& values) {
    Json array = Json::array();
    for (const T& value : values) array.push_back(json_of(value));
    return array;
}

Json json_of(const ImageFindings& findings) {
    return {{"scene", findings.scene},
            {"width_px", findings.width_px},
            {"height_px", findings.height_px},
            {"samples_per_pixel", findings.samples_per_pixel},
            {"mean_luminance", study::json_of(findings.mean_luminance)},
            {"rows", array_of(findings.rows)}};
}

ImageFindings image_from(const Json& json) {
    return {.scene = json.at("scene"),
            .width_px = json.at("width_px"),
            .height_px = json.at("height_px"),
            .samples_per_pixel = json.at("samples_per_pixel"),
            .mean_luminance = number_from(json.at("mean_luminance")),
            .rows = list_from(json.at("rows"), image_row_from)};
}

Json json_of(const EffectFindings& findings) {
    return {{"scene", findings.scene},
            {"seconds", findings.seconds},
            {"pairs", findings.pairs},
            {"width_px", findings.width_px},
            {"height_px", findings.height_px},
            {"rows", array_of(findings.rows)}};
}

EffectFindings effects_from(const Json& json) {
    return {.scene = json.at("scene"),
            .seconds = json.at("seconds"),
            .pairs = json.at("pairs"),
            .width_px = json.at("width_px"),
            .height_px = json.at("height_px"),
            .rows = list_from(json.at("rows"), effect_cost_from)};
}

std::optional<Shard> shard_of(const Json& findings) {
    if (!findings.contains("shard")) return std::nullopt;
    const Json& json = findings.at("shard");
    return Shard{.index = json.at("index"), .of = json.at("of"), .what = json.at("what")};
}

std::string text_of(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Of all but the sum itself, however it is laid out.
std::string sum_of(Json json) {
    json.erase("sum");
    const std::string text = text_of(json);
    Hasher hasher;
    hasher.add(text.data(), text.size());
    return hex_of(hasher.digest());
}

Findings findings_from(const Json& json) {
    const std::string sum = json.at("sum");
    if (sum != sum_of(json))
        throw std::runtime_error(fmt::format(
            "its checksum is {}, it should be {}: something in it was changed", sum_of(json), sum));
    return {.command = json.at("command"),
            .machine = json.at("machine"),
            .build = json.at("build"),
            .made_on = json.at("made_on"),
            .complete = json.at("complete"),
            .shard = shard_of(json),
            .clock_spread = json.at("clock_spread"),
            .subjects = list_from(json.at("subjects"), subject_from),
            .images = list_from(json.at("images"), image_from),
            .effects = list_from(json.at("effects"), effects_from)};
}

}  // namespace

Json json_of(double number) {
    return std::isfinite(number) ? Json(number) : Json(nullptr);
}

double number_from(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json json_of(const Setting& setting) {
    return {{"solver", physics::solver_name(setting.solver)},
            {"step_hz", setting.step_hz},
            {"substeps", setting.substeps},
            {"substeps_max", setting.substeps_max},
            {"iterations", setting.iterations},
            {"precision", precision_name(setting.precision)}};
}

Setting setting_from(const Json& json) {
    // What is no number of steps must not become one by conversion.
    const auto whole = [&](const char* key) {
        const Json& number = json.at(key);
        if (!number.is_number_integer() || number < 0 || number > 1'000'000)
            throw std::runtime_error(
                fmt::format("{} is {}; expected a whole number", key, number.dump()));
        return number.get<int>();
    };
    return {.solver = solver_from(json.at("solver")),
            .step_hz = whole("step_hz"),
            .substeps = whole("substeps"),
            .substeps_max = whole("substeps_max"),
            .iterations = whole("iterations"),
            .precision = named(json.at("precision"), kPrecisions, precision_name)};
}

Json json_of(const Point& point) {
    return {{"setting", json_of(point.setting)},
            {"status", status_name(point.status)},
            {"why", point.why},
            {"errors", array_of(point.errors)},
            {"cost", json_of(point.cost)}};
}

Point point_from(const Json& json) {
    return {.setting = setting_from(json.at("setting")),
            .status = named(json.at("status"), kStatuses, status_name),
            .why = json.at("why"),
            .errors = list_from(json.at("errors"), number_from),
            .cost = cost_from(json.at("cost"))};
}

Json json_of(const Subject& subject) {
    return {{"id", subject.id},
            {"title", subject.title},
            {"set_up", subject.set_up},
            {"reference", subject.reference},
            {"tier", tier_name(subject.tier)},
            {"peer_scene", subject.peer_scene},
            {"metrics", array_of(subject.metrics)},
            {"uncertainty", json_of(subject.uncertainty)},
            {"euler_floor", array_of(subject.euler_floor)},
            {"points", array_of(subject.points)},
            {"verdicts", array_of(subject.verdicts)},
            {"notes", subject.notes}};
}

Subject subject_from(const Json& json) {
    return {.id = json.at("id"),
            .title = json.at("title"),
            .set_up = json.at("set_up"),
            .reference = json.at("reference"),
            .tier = named(json.at("tier"), kTiers, tier_name),
            .peer_scene = json.at("peer_scene"),
            .metrics = list_from(json.at("metrics"), metric_from),
            .uncertainty = number_from(json.at("uncertainty")),
            .euler_floor = list_from(json.at("euler_floor"), floor_from),
            .points = list_from(json.at("points"), point_from),
            .verdicts = list_from(json.at("verdicts"), verdict_from),
            .notes = json.at("notes")};
}

std::string findings_to_json(const Findings& findings) {
    Json json{{"command", findings.command},
              {"machine", findings.machine},
              {"build", findings.build},
              {"made_on", findings.made_on},
              {"complete", findings.complete},
              {"clock_spread", json_of(findings.clock_spread)},
              {"subjects", array_of(findings.subjects)},
              {"images", array_of(findings.images)},
              {"effects", array_of(findings.effects)}};
    if (const auto& shard = findings.shard)
        json["shard"] = {{"index", shard->index}, {"of", shard->of}, {"what", shard->what}};
    json["sum"] = sum_of(json);
    return text_of(json, 1) + "\n";
}

Result<Findings> findings_from_json(const std::string& text) {
    try {
        return findings_from(scene::read_json<Json>(text));
    } catch (const std::exception& fault) {
        return Error{.message = fmt::format("not what a study writes: {}", fault.what())};
    }
}

}  // namespace plumbline::study
