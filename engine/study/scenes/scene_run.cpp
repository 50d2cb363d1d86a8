#include "engine/study/scenes/scene_run.h"

#include "engine/core/io/files.h"
#include "engine/core/random.h"
#include "engine/core/time/stopwatch.h"
#include "engine/effects/advance.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/state_report.h"
#include "engine/study/gallery/case_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    OneRun(const SceneRun& run, scene::Simulation& simulation)
        : run_(run),
          simulation_(simulation),
          game_(simulation.description().camera),
          effects_(simulation, {.frame = false, .sound = false}),
          steps_per_look_(
              std::max(1, static_cast<int>(std::lround(kLookEvery_s / simulation.step_s())))) {
        for (const scene::MovingBody& moving : simulation.moving_bodies()) {
            if (moving.kind != physics::BodyKind::Dynamic) continue;
            bodies_.push_back(moving.body);
            masses_kg_.push_back(
                static_cast<double>(simulation.physics.mass_properties(moving.body).mass_kg));
            poses_.push_back({});
        }
    }

    const std::vector<physics::BodyId>& bodies() const { return bodies_; }
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
            simulation_.physics.bounds(body, min_world, max_world);
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

    /// Steps to the end, looking as often as agreed.
    Trace look() {
        Trace trace;
        const physics::Energy start = simulation_.physics.energy();
        trace.moments.push_back(moment());
        std::size_t next = 0;
        for (int look = 1; next < run_.moments.size(); ++look) {
            if (!steps_of_one_look(trace)) break;
            const physics::Energy energy = simulation_.physics.energy();
            trace.energy_turnover_J = std::max({trace.energy_turnover_J,
                                                energy.kinetic_J,
                                                std::abs(energy.potential_J - start.potential_J)});
            trace.penetration_m =
                std::max(trace.penetration_m, simulation_.physics.max_penetration_m());
            trace.joint_error_m =
                std::max(trace.joint_error_m, simulation_.physics.max_joint_error_m());
            if (look != run_.moments[next]) continue;
            trace.moments.push_back(moment());
            ++next;
        }
        trace.end_s = simulation_.time_s();
        return trace;
    }

    /// Steps to the end for the clock alone.
    void repeat() {
        Trace unused;
        for (int look = 0; look < run_.moments.back(); ++look) {
            if (!steps_of_one_look(unused)) break;
        }
    }

    double cpu_ms() const { return cpu_ms_; }
    double work() const { return work_; }
    const std::vector<float>& step_ms() const { return step_ms_; }

private:
    /// False where the run ends early; `trace` then says why.
    bool steps_of_one_look(Trace& trace) {
        const CpuTimer timer;
        for (int i = 0; i < steps_per_look_; ++i) {
            effects::advance(simulation_, effects_, game_, {});
            const physics::StepCost& cost = simulation_.physics.cost();
            work_ += static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts);
            step_ms_.push_back(static_cast<float>(cost.total_ms));
        }
        cpu_ms_ += timer.ms();
        if (!simulation_.physics.quarantined().empty()) {
            trace.status = RunStatus::NotFinite;
            trace.why = fmt::format(
                "{} had no finite state by {:.2f} s",
                name_of_mark(simulation_,
                             simulation_.physics.user(simulation_.physics.quarantined().front())),
                simulation_.time_s());
            return false;
        }
        if (cpu_ms_ > run_.cpu_limit_s * 1e3) {
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
        moment.energy_J = simulation_.physics.energy().total_J();
        const std::size_t every = bodies_.size() / kBodiesTold + 1;
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
    scene::Simulation& simulation_;
    scene::NoGame game_;
    effects::EffectRuntime effects_;
    int steps_per_look_;
    std::vector<physics::BodyId> bodies_;
    std::vector<double> masses_kg_;
    std::vector<BodyPose> poses_;
    double cpu_ms_{0};
    double work_{0};
    std::vector<float> step_ms_;
};

/// Costs of several runs of one setting; the first warms up, and counts only if it stays alone.
class CostBook {
public:
    void add(const OneRun& run, double simulated_s) {
        if (simulated_s <= 0) return;
        total_ms_ += run.cpu_ms();
        work_per_s_ = run.work() / simulated_s;
        runs_.push_back({run.cpu_ms() / simulated_s, run.step_ms()});
    }
    double total_s() const { return total_ms_ * 1e-3; }

    RunCost cost() {
        if (runs_.size() > 1) runs_.erase(runs_.begin());
        if (runs_.empty()) return {};
        std::vector<double> ms_per_s;
        std::vector<float> step_ms;
        for (const auto& [each, steps] : runs_) {
            ms_per_s.push_back(each);
            step_ms.insert(step_ms.end(), steps.begin(), steps.end());
        }
        std::ranges::sort(ms_per_s);
        const scene::Percentiles steps = scene::percentiles_of(std::move(step_ms));
        return {.ms_per_s_min = ms_per_s.front(),
                .ms_per_s_median = ms_per_s[ms_per_s.size() / 2],
                .ms_per_s_max = ms_per_s.back(),
                .repeats = static_cast<int>(ms_per_s.size()),
                .step_ms_median = steps.median,
                .step_ms_p99 = steps.p99,
                .work_per_s = work_per_s_};
    }

private:
    std::vector<std::pair<double, std::vector<float>>> runs_;
    double total_ms_{0};
    double work_per_s_{0};
};

}  // namespace

Result<Done> SceneRunner::open(const std::filesystem::path& file) {
    if (opened_ && file_ == file && scene::unchanged(opened_->files)) return Done{};
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    opened_.reset();
    library_ = std::make_unique<assets::AssetLibrary>();
    Diagnostics faults;
    Result<scene::OpenedScene> opened = scene::open_scene(file, {.folders = *folders}, faults);
    if (!opened) return opened.error();
    opened_ = std::move(*opened);
    file_ = file;
    return Done{};
}

Result<std::unique_ptr<scene::Simulation>> SceneRunner::build(const Setting& setting) {
    opened_->overrides = overrides(setting);
    Result<std::unique_ptr<scene::Simulation>> built = opened_->build(*library_);
    if (built) play_case_events(**built);
    return built;
}

Result<SceneAnswer> SceneRunner::run(const SceneRun& run) {
    const double start_s = wall_s();
    const double cpu_start_s = thread_cpu_s();
    if (const Result<Done> opened = open(run.scene); !opened) return opened.error();
    SceneAnswer answer;
    CostBook book;
    const int runs = run.copies + run.repeats;
    for (int i = 0; i < runs; ++i) {
        if (i >= run.copies && book.total_s() > run.repeat_s) break;
        const Result<std::unique_ptr<scene::Simulation>> built = build(run.setting);
        if (!built) return built.error();
        scene::Simulation& simulation = **built;
        OneRun one(run, simulation);
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
            answer.traces.push_back(one.look());
        } else {
            one.repeat();
        }
        book.add(one, simulation.time_s());
        if (answer.traces.back().status != RunStatus::Done) break;
    }
    answer.cost = book.cost();
    answer.cpu_s = thread_cpu_s() - cpu_start_s;
    answer.wall_s = wall_s() - start_s;
    return answer;
}

}  // namespace plumbline::study
