#include "engine/app/world_request.h"

#include "engine/core/limits.h"
#include "engine/scene/environment/live_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::size_t kLongestName = 64;
constexpr double kLongestAnimation_s = 1e6;

/// Not so for NaN.
template <class Number>
bool is_within(Number value, Number least, Number most) {
    return value >= least && value <= most;
}

template <std::size_t... kIndex>
WorldRequest request_of_kind(std::size_t kind, std::index_sequence<kIndex...>) {
    WorldRequest request;
    (void)((kind == kIndex && (request.emplace<kIndex>(), true)) || ...);
    return request;
}

}  // namespace

void SwitchEffect::serialize(Archive& archive) {
    archive(effect, on);
    archive.expect(is_within<std::size_t>(effect.size(), 1, kLongestName),
                   "an effect's name of 1 to 64 letters");
}

void SetFog::serialize(Archive& archive) {
    archive(density_scale, color);
    archive.expect(is_within(density_scale, scene::kThinnestFog, scene::kDensestFog) &&
                       color < scene::kFogColors.size(),
                   "a density and a colour of fog");
}

void SetLight::serialize(Archive& archive) {
    archive(scale);
    archive.expect(is_within(scale, scene::kDimmestLight, scene::kBrightestLight),
                   "a brightness of sun and sky");
}

void SetHour::serialize(Archive& archive) {
    archive(hour);
    archive.expect(is_within(hour, 0.0, 24.0), "an hour from 0 to 24");
}

void SetAccuracy::serialize(Archive& archive) {
    study::Setting& s = setting;
    auto solver = static_cast<std::uint8_t>(s.solver);
    auto precision = static_cast<std::uint8_t>(s.precision);
    archive(solver, s.step_hz, s.substeps, s.substeps_max, s.iterations, precision, s.fidelity);
    s.solver = static_cast<physics::Solver>(solver);
    s.precision = static_cast<study::Precision>(precision);
    archive.expect(std::ranges::find(physics::kSolvers, s.solver) != physics::kSolvers.end() &&
                       is_within(s.step_hz, int{limits::kStepHzMin}, int{limits::kStepHzMax}) &&
                       is_within(s.substeps, 0, scene::kMostSubsteps) &&
                       is_within(s.substeps_max, 1, scene::kMostSubsteps) &&
                       is_within(s.iterations, 1, scene::kMostIterations) &&
                       s.precision <= study::Precision::Float64,
                   "a setting of the solver");
}

void SetAnimation::serialize(Archive& archive) {
    archive(time_s, paused, next);
    archive.expect(is_within(time_s, 0.0, kLongestAnimation_s), "a time of an animation");
}

void serialize(Archive& archive, WorldRequest& request) {
    constexpr std::size_t kKinds = std::variant_size_v<WorldRequest>;
    auto kind = static_cast<std::uint8_t>(request.index());
    archive(kind);
    if (!archive.expect(kind < kKinds, "a kind of request")) return;
    if (archive.reads()) request = request_of_kind(kind, std::make_index_sequence<kKinds>{});
    std::visit([&](auto& each) { archive(each); }, request);
}

}  // namespace plumbline::app
