#include "engine/study/scenes/scene_run.h"

#include "engine/core/process/process_memory.h"
#include "engine/core/random.h"
#include "engine/core/time/stopwatch.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/study/stepping_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

Vec3d up_of(const scene::Simulation& simulation) {
    return normalize_or(-Vec3d(simulation.description().gravity_mps2), Vec3d{0, 1, 0});
}

/// Value below which a share of them lies. Reorders.
double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

/// One simulation from its start to its end.
class OneRun {
public:
    OneRun(const SceneRun& run, PlayedScene& scene)
        : run_(run),
          scene_(scene),
          simulation_(scene.simulation()),
          steps_per_sample_(
              std::max(1, static_cast<int>(std::lround(kSampleEvery_s / simulation_.step_s())))) {
        scene_.start();
        // They count where nothing else moves.
        const std::set<physics::BodyId> pieces = rope_pieces(simulation_);
        std::size_t others = 0;
        for (const scene::MovingBody& moving : simulation_.moving_bodies())
            others += moving.kind == physics::BodyKind::Dynamic && !pieces.contains(moving.body);
        has_others_ = others > 0;
        for (const scene::MovingBody& moving : simulation_.moving_bodies()) {
            if (moving.kind != physics::BodyKind::Dynamic ||
                (has_others_ && pieces.contains(moving.body)))
                continue;
            bodies_.push_back(moving.body);
            masses_kg_.push_back(
                static_cast<double>(simulation_.physics.state(moving.body).mass.mass_kg));
            poses_.push_back({});
        }
    }

    const std::vector<physics::BodyId>& bodies() const { return bodies_; }
    bool has_others() const { return has_others_; }  ///< than pieces of ropes
    double mass_kg() const {
        double sum_kg = 0;
        for (const double each : masses_kg_) sum_kg += each;
        return sum_kg;
    }
    double body_size_m() const {
        std::vector<double> sizes_m;
        for (const physics::BodyId body : bodies_) {
            Vec3 min_world{};
            Vec3 max_world{};
            physics::bounds(simulation_.physics, body, min_world, max_world);
            sizes_m.push_back(glm::length(Vec3d(max_world) - Vec3d(min_world)));
        }
        return quantile(sizes_m, 0.5);
    }

    /// Puts every body a little elsewhere, and lets it drift a little.
    void shift(std::uint64_t seed) {
        Random random(seed);
        const auto within = [&] {
            return static_cast<Real>(run_.shift_m) * (2.0_r * Real{random.uniform()} - 1.0_r);
        };
        for (const physics::BodyId body : bodies_) {
            const physics::BodyState state = simulation_.physics.state(body);
            Pose pose = state.world_from_body;
            pose.position += Vec3{within(), within(), within()};
            simulation_.physics.set_pose(body, pose);
            simulation_.physics.set_velocity(
                body,
                state.velocity_mps + Vec3{within(), within(), within()},
                state.angular_velocity_radps);
        }
    }

    /// Steps to the end, sampling as often as agreed.
    Trace sample() {
        Trace trace;
        const physics::Energy start = physics::energy(simulation_.physics);
        trace.moments.push_back(moment());
        std::size_t next = 0;
        for (int sample = 1; next < run_.moments.size(); ++sample) {
            if (!step_to_next_sample(trace)) break;
            const physics::Energy energy = physics::energy(simulation_.physics);
            trace.energy_turnover_J = std::max({trace.energy_turnover_J,
                                                energy.kinetic_J,
                                                std::abs((energy.total_J() - energy.kinetic_J) -
                                                         (start.total_J() - start.kinetic_J))});
            trace.penetration_m =
                std::max(trace.penetration_m, max_penetration_m(simulation_.physics));
            trace.joint_error_m =
                std::max(trace.joint_error_m, max_joint_error_m(simulation_.physics));
            if (sample != run_.moments[next]) continue;
            trace.moments.push_back(moment());
            ++next;
        }
        trace.end_s = simulation_.time_s();
        return trace;
    }

    /// Steps to the end for the clock alone.
    void repeat() {
        Trace unused;
        for (int sample = 0; sample < run_.moments.back(); ++sample) {
            if (!step_to_next_sample(unused)) break;
        }
    }

    /// Of all steps so far.
    Lap lap() const {
        Lap lap = lap_;
        lap.simulated_s = simulation_.time_s();
        return lap;
    }

private:
    /// False where the run ends early; `trace` then says why.
    bool step_to_next_sample(Trace& trace) {
        const CpuTimer timer;
        for (int i = 0; i < steps_per_sample_; ++i) {
            scene_.step();
            const physics::StepCost& cost = simulation_.physics.report().cost;
            lap_.work += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
            lap_.step_ms.push_back(static_cast<float>(cost.total_ms));
        }
        lap_.cpu_ms += timer.ms();
        if (!simulation_.physics.report().isolated.empty()) {
            trace.status = RunStatus::NotFinite;
            trace.why = fmt::format(
                "{} had no finite state by {:.2f} s",
                name_of_mark(
                    simulation_,
                    simulation_.physics.state(simulation_.physics.report().isolated.front()).user),
                simulation_.time_s());
            return false;
        }
        if (lap_.cpu_ms > run_.cpu_limit_s * 1e3) {
            trace.status = RunStatus::TimedOut;
            trace.why = fmt::format(
                "{:g} s of CPU time went for {:.2f} s", run_.cpu_limit_s, simulation_.time_s());
            return false;
        }
        return true;
    }

    Moment moment() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            poses_[i].there = simulation_.physics.contains(bodies_[i]);
            if (!poses_[i].there) continue;
            const Pose pose = simulation_.physics.state(bodies_[i]).world_from_body;
            poses_[i].position_m = Vec3d(pose.position);
            poses_[i].orientation = Quatd(pose.orientation);
        }
        Moment moment{.time_s = simulation_.time_s(), .layout = layout()};
        moment.energy_J = physics::energy(simulation_.physics).total_J();
        const std::size_t every = bodies_.size() / kMostBodiesSampled + 1;
        for (std::size_t i = 0; i < bodies_.size(); i += every) moment.bodies.push_back(poses_[i]);
        return moment;
    }

    Layout layout() const {
        const Vec3d up = up_of(simulation_);
        Layout layout;
        double mass_kg = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!poses_[i].there) continue;
            layout.center_m += masses_kg_[i] * poses_[i].position_m;
            mass_kg += masses_kg_[i];
        }
        if (mass_kg > 0) layout.center_m /= mass_kg;
        std::vector<double> heights_m;
        std::vector<double> distances_m;
        double sum_m2 = 0;
        for (const BodyPose& pose : poses_) {
            if (!pose.there) continue;
            const Vec3d away = pose.position_m - layout.center_m;
            const double level_m = glm::length(away - glm::dot(away, up) * up);
            heights_m.push_back(glm::dot(pose.position_m, up));
            distances_m.push_back(level_m);
            sum_m2 += level_m * level_m;
        }
        if (distances_m.empty()) return layout;
        layout.spread_m = std::sqrt(sum_m2 / static_cast<double>(distances_m.size()));
        layout.top_m = quantile(heights_m, 0.95);
        layout.reach_m = quantile(distances_m, 0.95);
        return layout;
    }

    const SceneRun& run_;
    PlayedScene& scene_;
    scene::Simulation& simulation_;
    int steps_per_sample_;
    std::vector<physics::BodyId> bodies_;
    bool has_others_{false};
    std::vector<double> masses_kg_;
    std::vector<BodyPose> poses_;
    Lap lap_;
};

/// By the ledger at the end of a run.
std::vector<std::string> open_effects(const PlayedScene& scene) {
    std::vector<std::string> open;
    const auto names = scene::effects_with_fidelity();
    const auto& given = scene.simulation().description().effect_settings;
    const std::vector<effects::LedgerLine> ledger = scene.effects().ledger();
    for (std::size_t i = 0; i < ledger.size(); ++i) {
        const std::string name(ledger[i].name);
        if (effects::effect_table()[i].domain == effects::Domain::Step &&
            ledger[i].constructions > 0 && !given.contains(name) &&
            std::ranges::find(names, name) != names.end())
            open.push_back(name);
    }
    return open;
}

/// The first run warms up, and counts only where it stays alone.
RunCost cost_of_runs(std::span<const Lap> laps) {
    return cost_of(laps.size() > 1 ? laps.subspan(1) : laps);
}

}  // namespace

Result<Done> SceneRunner::open(const std::filesystem::path& file) {
    if (opened_ && file_ == file && scene::unchanged(opened_->files)) return Done{};
    opened_.reset();
    library_ = std::make_unique<assets::AssetLibrary>();
    Result<scene::OpenedScene> opened = open_for_study(file);
    if (!opened) return opened.error();
    opened_ = std::move(*opened);
    file_ = file;
    return Done{};
}

Result<SceneAnswer> SceneRunner::run(const SceneRun& run) {
    const double start_s = wall_s();
    const double cpu_start_s = thread_cpu_s();
    if (const Result<Done> opened = open(run.scene); !opened) return opened.error();
    opened_->overrides = overrides(run.setting);
    reset_peak_resident_bytes();
    SceneAnswer answer;
    std::vector<Lap> laps;
    double spent_s = 0;
    const int runs = run.copies + run.repeats;
    for (int i = 0; i < runs; ++i) {
        if (i >= run.copies && spent_s > run.repeat_s) break;
        Result<PlayedScene> scene = PlayedScene::create(*opened_, *library_);
        if (!scene) return scene.error();
        const scene::Simulation& simulation = scene->simulation();
        OneRun one(run, *scene);
        if (one.bodies().empty())
            return Error{.message = fmt::format("{}: nothing in it moves by itself, so there is no "
                                                "accuracy to study; expected a body of kind "
                                                "\"dynamic\"",
                                                run.scene.string()),
                         .exit_code = ExitCode::Refused};
        if (i == 0) {
            answer.bodies = one.bodies().size();
            answer.joints = simulation.joints().size();
            answer.mass_kg = one.mass_kg();
            answer.gravity_mps2 = glm::length(Vec3d(simulation.description().gravity_mps2));
            answer.body_size_m = one.body_size_m();
        }
        if (run.shift_m > 0)
            one.shift(run.seed + static_cast<std::uint64_t>(std::min(i, run.copies - 1)));
        if (i < run.copies) {
            answer.traces.push_back(one.sample());
        } else {
            one.repeat();
        }
        if (i == 0 && one.has_others()) answer.effects = open_effects(*scene);
        if (simulation.time_s() > 0) laps.push_back(one.lap());
        spent_s += one.lap().cpu_ms * 1e-3;
        if (answer.traces.back().status != RunStatus::Done) break;
    }
    answer.cost = cost_of_runs(laps);
    answer.cost.bodies = answer.bodies;
    answer.cost.peak_bytes = peak_resident_bytes();
    answer.cpu_s = thread_cpu_s() - cpu_start_s;
    answer.wall_s = wall_s() - start_s;
    return answer;
}

}  // namespace plumbline::study
