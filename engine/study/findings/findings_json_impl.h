// The fields of settings, points and subjects, for whatever holds them among other things.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/findings/json_fields_impl.h"

namespace plumbline::study {

void fields(const auto& field, Like<Setting> auto& setting) {
    field("solver", setting.solver);
    field("step_hz", setting.step_hz);
    field("substeps", setting.substeps);
    field("substeps_max", setting.substeps_max);
    field("iterations", setting.iterations);
    field("precision", setting.precision);
    field("effects", setting.fidelity);
}

void fields(const auto& field, Like<EngineKnob> auto& knob) {
    field("name", knob.name);
    field("value", knob.value);
}

void fields(const auto& field, Like<EngineSetting> auto& setting) {
    field("engine", setting.engine);
    field("step_hz", setting.step_hz);
    field("knobs", setting.knobs);
}

void fields(const auto& field, Like<RunCost> auto& cost) {
    field("ms_per_s_min", cost.ms_per_s_min);
    field("ms_per_s_median", cost.ms_per_s_median);
    field("ms_per_s_max", cost.ms_per_s_max);
    field("clock_ms_per_s", cost.clock_ms_per_s);
    field("repeats", cost.repeats);
    field("step_ms_median", cost.step_ms_median);
    field("step_ms_p99", cost.step_ms_p99);
    field("step_ms_max", cost.step_ms_max);
    field("frame_ms_p99", cost.frame_ms_p99);
    field("frame_ms_max", cost.frame_ms_max);
    field("bodies", cost.bodies);
    field("peak_bytes", cost.peak_bytes);
    field("work_per_s", cost.work_per_s);
}

void fields(const auto& field, Like<Point> auto& point) {
    field("setting", point.setting);
    field("status", point.status);
    field("why", point.why);
    field("errors", point.errors);
    field("cost", point.cost);
}

void fields(const auto& field, Like<EnginePoint> auto& point) {
    field("setting", point.setting);
    field("title", point.title);
    field("settings_text", point.text);
    field("version", point.version);
    field("webassembly", point.webassembly);
    field("status", point.status);
    field("why", point.why);
    field("errors", point.errors);
    field("cost", point.cost);
}

void fields(const auto& field, Like<ThreadsPoint> auto& point) {
    field("threads", point.threads);
    field("status", point.status);
    field("why", point.why);
    field("same", point.same);
    field("cost", point.cost);
}

void fields(const auto& field, Like<Metric> auto& metric) {
    field("name", metric.name);
    field("scale", metric.scale);
}

void fields(const auto& field, Like<FloorPoint> auto& point) {
    field("step_s", point.step_s);
    field("error", point.error);
}

void fields(const auto& field, Like<Convergence> auto& verdict) {
    field("knob", verdict.knob);
    field("solver", verdict.solver);
    field("held", verdict.held);
    field("trend", verdict.trend);
    field("order", verdict.order);
    field("theory", verdict.theory);
    field("halvings", verdict.halvings);
}

void fields(const auto& field, Like<Subject> auto& subject) {
    field("id", subject.id);
    field("title", subject.title);
    field("set_up", subject.set_up);
    field("reference", subject.reference);
    field("tier", subject.tier);
    field("peer_scene", subject.peer_scene);
    field("metrics", subject.metrics);
    field("uncertainty", subject.uncertainty);
    field("euler_floor", subject.euler_floor);
    field("points", subject.points);
    field("engines", subject.engines);
    field("threads", subject.threads);
    field("verdicts", subject.verdicts);
    field("notes", subject.notes);
}

void fields(const auto& field, Like<Difference> auto& difference) {
    field("mean", difference.mean);
    field("standard_error", difference.standard_error);
    field("pairs", difference.pairs);
}

void fields(const auto& field, Like<EffectError> auto& error) {
    field("effect", error.effect);
    field("reference", error.reference);
    field("formula", error.formula);
    field("fidelity", error.fidelity);
    field("error", error.error);
    field("cpu_ms_per_s", error.cpu_ms_per_s);
    field("tolerance", error.tolerance);
}

void fields(const auto& field, Like<FidelityCost> auto& at) {
    field("fidelity", at.fidelity);
    field("step_ms", at.step_ms);
    field("largest_m", at.largest_m);
    field("mean_m", at.mean_m);
}

void fields(const auto& field, Like<EffectCost> auto& cost) {
    field("name", cost.name);
    field("caller", cost.caller);
    field("domain", cost.domain);
    field("step_ms", cost.step_ms);
    field("frame_ms", cost.frame_ms);
    field("calls", cost.calls);
    field("bytes_cpu", cost.bytes_cpu);
    field("bytes_gpu", cost.bytes_gpu);
    field("fidelities", cost.fidelities);
}

void fields(const auto& field, Like<Shard> auto& shard) {
    field("index", shard.index);
    field("of", shard.of);
    field("what", shard.what);
}

}  // namespace plumbline::study
