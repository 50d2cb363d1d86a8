#include "tests/benchmarks/peer_scenes_run.h"

#include "engine/core/time/stopwatch.h"

#include <algorithm>
#include <cmath>

namespace plumbline::bench {

namespace {

constexpr double kFrame_s = 1.0 / 60.0;

/// One variant within one round.
class Lane {
public:
    Lane(const PeerScene& scene, const Variant& variant) : scene_(scene), variant_(variant) {}

    Result<Done> build() {
        const int hz = variant_.settings.hz;
        if (variant_.bare) {
            world_ = make_bare_world(scene_, 1.0 / hz);
            return Done{};
        }
        if (variant_.drop_in) {
            world_ = make_drop_in_world(scene_, 1.0 / hz);
            return Done{};
        }
        auto made = make_our_world(scene_, variant_.settings);
        if (!made) return made.error();
        world_ = std::move(*made);
        return Done{};
    }

    void measure(const SceneCase& the_case, double end_s) {
        meter_ = make_meter(scene_, end_s);
        views_ = start_views(scene_);
        stretch_ = std::max(1L, std::lround(the_case.sample_every_s * variant_.settings.hz));
    }
    void watch_sleep() {
        stretch_ = 1;
        watches_sleep_ = true;
    }
    void count_phases() { counts_phases_ = world_->cost() != nullptr; }

    void run_to(double time_s) {
        const long last = std::lround(time_s * variant_.settings.hz);
        while (steps_ < last) {
            const bool asleep = watches_sleep_ && world_->all_asleep();
            // Stretches end where samples are due, whatever the turns.
            const long due = stretch_ > 0 ? stretch_ - steps_ % stretch_ : last - steps_;
            const long steps = std::min(due, last - steps_);
            const double start_s = wall_s();
            const double start_cpu_s = thread_cpu_s();
            helpers_ms_ = 0;
            for (long i = 0; i < steps; ++i) step();
            const double took_s = thread_cpu_s() - start_cpu_s + helpers_ms_ * 1e-3;
            wall_s_ += wall_s() - start_s;
            steps_ += steps;
            cpu_s_ += took_s;
            look(asleep, took_s, steps == due);
        }
    }

    double ms_per_frame() const { return cpu_s_ * 1e3 / frames(); }
    double wall_ms_per_frame() const { return wall_s_ * 1e3 / frames(); }
    Phases phases() const {
        Phases mean = sum_;
        mean.other -= mean.broad + mean.narrow + mean.solve + mean.integrate;
        for (double* part :
             {&mean.broad, &mean.narrow, &mean.solve, &mean.integrate, &mean.other}) {
            *part /= frames();
        }
        return mean;
    }
    std::optional<SubstepsGiven> given() const {
        if (island_bodies_ <= 0) return {};
        return SubstepsGiven{island_substeps_ / island_bodies_, most_substeps_};
    }
    bool has_phases() const { return counts_phases_; }

    std::vector<Metric> metrics() const {
        std::vector<Metric> metrics = meter_->results();
        if (!watches_sleep_) return metrics;
        const bool slept = asleep_steps_ > 0;
        metrics.push_back({"t_asleep", slept ? asleep_from_s_ : -1});
        metrics.push_back(
            {"ms_asleep", slept ? asleep_cpu_s_ * 1e3 / static_cast<double>(asleep_steps_) : -1});
        return metrics;
    }

private:
    void step() {
        world_->step();
        if (world_->cost() == nullptr) return;
        const physics::StepCost& cost = *world_->cost();
        helpers_ms_ += cost.helpers_ms;
        if (!counts_phases_) return;
        sum_.broad += cost.broad_ms;
        sum_.narrow += cost.narrow_ms;
        sum_.solve += cost.solve_ms;
        sum_.integrate += cost.integrate_ms;
        sum_.other += cost.total_ms;
    }

    void look(bool was_asleep, double took_s, bool due) {
        const double now_s = static_cast<double>(steps_) / variant_.settings.hz;
        if (was_asleep) {
            asleep_cpu_s_ += took_s;
            ++asleep_steps_;
        } else {
            asleep_from_s_ = now_s;
        }
        if (!meter_ || !due) return;
        for (const physics::IslandReport& island : world_->islands()) {
            const double bodies{static_cast<double>(island.bodies)};
            island_bodies_ += bodies;
            island_substeps_ += bodies * island.substeps;
            most_substeps_ = std::max(most_substeps_, island.substeps);
        }
        world_->read(views_);
        meter_->sample(now_s, views_);
    }

    double frames() const {
        return static_cast<double>(steps_) / (variant_.settings.hz * kFrame_s);
    }

    const PeerScene& scene_;
    const Variant& variant_;
    std::unique_ptr<SteppedWorld> world_;
    std::unique_ptr<Meter> meter_;
    std::vector<BodyView> views_;
    long stretch_{0};  ///< steps between samples; 0: none
    long steps_{0};
    double cpu_s_{0};
    double wall_s_{0};
    double helpers_ms_{0};  ///< CPU of other threads, of the stretch at hand
    bool counts_phases_{false};
    Phases sum_{};  ///< `other` holds the total
    bool watches_sleep_{false};
    double asleep_from_s_{0};
    double asleep_cpu_s_{0};
    long asleep_steps_{0};
    double island_bodies_{0};
    double island_substeps_{0};
    int most_substeps_{0};
};

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// What the rounds gave, by variant.
struct Times {
    std::vector<double> ms;
    std::vector<double> wall_ms;
    std::vector<double> ratios;
};

Result<Done> run_round(const PeerScene& scene,
                       const SceneCase& the_case,
                       const RunSettings& settings,
                       bool first,
                       std::vector<Times>& times,
                       std::vector<VariantResult>& results) {
    const double end_s = settings.seconds > 0 ? settings.seconds : the_case.seconds;
    std::vector<Lane> lanes;
    lanes.reserve(results.size());
    for (const VariantResult& result : results) {
        Lane& lane = lanes.emplace_back(scene, result.variant);
        if (const Result<Done> built = lane.build(); !built) return built.error();
        if (first) lane.measure(the_case, end_s);
        if (settings.sleep) lane.watch_sleep();
        if (settings.phases) lane.count_phases();
    }
    for (double turn_s = 1.0; turn_s < end_s + 1.0; turn_s += 1.0) {
        for (Lane& lane : lanes) lane.run_to(std::min(turn_s, end_s));
    }
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        times[i].ms.push_back(lanes[i].ms_per_frame());
        times[i].wall_ms.push_back(lanes[i].wall_ms_per_frame());
        if (results.front().variant.bare)
            times[i].ratios.push_back(lanes[i].ms_per_frame() / lanes.front().ms_per_frame());
        if (first) {
            results[i].metrics = lanes[i].metrics();
            results[i].given = lanes[i].given();
        }
        if (lanes[i].has_phases()) results[i].phases = lanes[i].phases();
    }
    return Done{};
}

}  // namespace

Result<std::vector<VariantResult>> run_scene(const PeerScene& scene,
                                             const SceneCase& the_case,
                                             const std::vector<Variant>& variants,
                                             const RunSettings& settings) {
    std::vector<VariantResult> results;
    for (const Variant& variant : variants) results.push_back({.variant = variant});
    std::vector<Times> times(variants.size());
    for (int round = 0; round < settings.rounds; ++round) {
        const Result<Done> done = run_round(scene, the_case, settings, round == 0, times, results);
        if (!done) return done.error();
    }
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].ms_per_frame = median_of(times[i].ms);
        results[i].wall_ms_per_frame = median_of(times[i].wall_ms);
        if (times[i].ratios.empty()) continue;
        results[i].ratio = median_of(times[i].ratios);
        results[i].ratio_min = std::ranges::min(times[i].ratios);
        results[i].ratio_max = std::ranges::max(times[i].ratios);
    }
    return results;
}

}  // namespace plumbline::bench
