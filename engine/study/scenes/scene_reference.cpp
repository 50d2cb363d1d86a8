#include "engine/study/scenes/scene_reference.h"

#include "engine/study/scenes/scene_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::study {
namespace {

constexpr std::array kReferenceRates_hz{120, 240, 480, 960, 1920, 3840};
/// A reference that is this good settles questions down to 0.1 %.
constexpr double kGoodEnough = 1e-4;
/// Above this it cannot be compared with run by run, if copies come as far apart.
constexpr double kTooFarOff = 1e-3;
/// Copies that come this close to the difference between rates: it is chaos, not the step.
constexpr double kShareOfDifference = 0.1;
/// A halving that leaves more than this of the difference before it does not converge.
constexpr double kStillConverging = 0.7;
/// Of the wall time, beside the reference's share: what copies may take.
constexpr double kShareOfCopies = 0.1;
constexpr int kCopiesFew = 8;
constexpr int kCopiesMany = 16;

double worst_of(const std::vector<double>& errors) {
    double worst = 0;
    for (const double error : errors) worst = error <= worst ? worst : error;
    return worst;
}

class ReferenceMaker {
public:
    ReferenceMaker(ScenePlan& plan,
                   const SceneProbe& probe,
                   double share,
                   const UseRoughReference& use_rough)
        : plan_(plan), probe_(probe), share_(share), use_rough_(use_rough) {}

    Result<std::optional<SceneReference>> make() {
        if (const Result<Done> done = first_look(); !done) return done.error();
        if (plan_.interrupted()) return std::optional<SceneReference>{};
        if (const Result<Done> done = use_rough(); !done) return done.error();
        if (const Result<Done> done = refine(); !done) return done.error();
        if (plan_.interrupted()) return std::optional<SceneReference>{};
        if (levels_.size() < 2) return Error{.message = why_none()};
        if (chaotic()) return ensemble();
        return std::optional<SceneReference>(converged());
    }

private:
    struct Level {
        int step_hz;
        SceneAnswer answer;
        double off{0};  ///< of the level before, against this one
    };

    double seconds() const { return probe_.moments.back() * kSampleEvery_s; }
    double cost_s(int step_hz) const {
        return probe_.second_cpu_s * seconds() *
               guessed_cost(reference_setting(step_hz, probe_.effects));
    }
    double left_s() const { return plan_.cpu_left_s(share_); }

    Result<Done> use_rough() {
        if (levels_.size() < 2 || hopeless()) return Done{};
        const double start_s = plan_.spent_s();
        const Result<Done> done = use_rough_(converged());
        share_ += (plan_.spent_s() - start_s) / (plan_.spent_s() + plan_.left_s());
        return done;
    }

    SceneRun run_at(int step_hz) const {
        return {.scene = probe_.scene,
                .start = probe_.start,
                .setting = reference_setting(step_hz, probe_.effects),
                .moments = probe_.moments,
                .cpu_limit_s = std::max(2.0, 4.0 * cost_s(step_hz))};
    }
    SceneRun copies_at(int step_hz, int copies, std::uint64_t seed, double shift_m) const {
        SceneRun run = run_at(step_hz);
        run.copies = copies;
        run.seed = seed;
        run.shift_m = shift_m;
        return run;
    }

    static bool whole(const SceneAnswer& answer) {
        return !answer.traces.empty() && std::ranges::all_of(answer.traces, [](const Trace& trace) {
            return trace.status == RunStatus::Done;
        });
    }

    /// The answer, if all of it ran to its end; else why it did not is noted.
    std::optional<SceneAnswer> whole_answer(const ScenePlan::Finished& finished) {
        if (finished.status == RunStatus::Done && whole(finished.answer)) return finished.answer;
        failure_ = finished.why;
        for (const Trace& trace : finished.answer.traces) {
            if (trace.status != RunStatus::Done) failure_ = trace.why;
        }
        return {};
    }

    std::string why_none() const {
        return fmt::format(
            "{}: no reference can be made, small_step in float64 does not get "
            "through {:.2f} s at two step rates ({})",
            probe_.scene.string(),
            seconds(),
            failure_.empty() ? "there was no time for it" : failure_);
    }

    /// The lowest rates, and two copies of the first.
    Result<Done> first_look() {
        const std::size_t first = left_s() > 8.0 * cost_s(kReferenceRates_hz[1]) ? 1 : 0;
        next_rate_ = first + 2;
        const std::vector<SceneRun> runs{run_at(kReferenceRates_hz[first]),
                                         run_at(kReferenceRates_hz[first + 1]),
                                         copies_at(kReferenceRates_hz[first], 2, 1, kShift_m)};
        std::vector<std::optional<SceneAnswer>> answers(runs.size());
        const Result<Done> done = plan_.run(
            runs, [&](const ScenePlan::Finished& each) { answers[each.run] = whole_answer(each); });
        if (!done) return done;
        for (std::size_t i = 0; i < 2; ++i) {
            if (answers[i]) add_level(runs[i].setting.step_hz, std::move(*answers[i]));
        }
        if (answers[2] && levels_.size() == 2) {
            for (const Trace& copy : answers[2]->traces) {
                spread_ =
                    std::max(spread_,
                             worst_of(trajectory_errors(
                                 copy, levels_[0].answer.traces[0], scales_of(levels_[0].answer))));
            }
        }
        return Done{};
    }

    void add_level(int step_hz, SceneAnswer answer) {
        Level level{.step_hz = step_hz, .answer = std::move(answer)};
        if (!levels_.empty()) {
            level.off = worst_of(trajectory_errors(
                levels_.back().answer.traces[0], level.answer.traces[0], scales_of(level.answer)));
        }
        levels_.push_back(std::move(level));
    }

    bool good() const {
        // Two successive halvings: the last difference is small and not larger than the one before.
        if (levels_.size() < 3) return false;
        const double last = levels_.back().off;
        return last <= kGoodEnough && last <= levels_[levels_.size() - 2].off + kGoodEnough * 0.1;
    }

    bool copies_part() const { return spread_ > kShareOfDifference * levels_.back().off; }
    /// Too far off to compare run by run, and halving the step does not help.
    bool stuck() const {
        return levels_.size() >= 3 && levels_.back().off > kTooFarOff &&
               levels_.back().off > kStillConverging * levels_[levels_.size() - 2].off;
    }
    bool hopeless() const {
        return stuck() || (levels_.size() >= 2 && levels_.back().off > 0.02 && copies_part());
    }

    Result<Done> refine() {
        if (levels_.size() < 2) return Done{};
        while (next_rate_ < kReferenceRates_hz.size() && !good() && !hopeless() &&
               !plan_.interrupted()) {
            const int step_hz = kReferenceRates_hz[next_rate_];
            if (cost_of_next_s(step_hz) > left_s() / plan_.workers()) break;
            ++next_rate_;
            std::optional<SceneAnswer> answer;
            const Result<Done> done =
                plan_.run(std::vector{run_at(step_hz)},
                          [&](const ScenePlan::Finished& each) { answer = whole_answer(each); });
            if (!done) return done;
            if (!answer) break;
            add_level(step_hz, std::move(*answer));
        }
        return Done{};
    }

    /// From the latest level's own cost.
    double cost_of_next_s(int step_hz) const {
        const Level& latest = levels_.back();
        return latest.answer.cost.ms_per_s_min * 1e-3 * seconds() * step_hz / latest.step_hz;
    }

    bool chaotic() const {
        return !good() && levels_.back().off > kTooFarOff && (copies_part() || stuck());
    }

    SceneReference converged() const {
        const Level& finest = levels_.back();
        SceneReference reference{
            .answer = finest.answer, .scales = scales_of(finest.answer), .uncertainty = finest.off};
        reference.text = fmt::format("small_step in float64 at {} Hz x 4", finest.step_hz);
        std::string differences;
        for (std::size_t i = 1; i < levels_.size(); ++i) {
            differences += fmt::format("{}{:.1e} ({} to {} Hz)",
                                       i == 1 ? "" : ", ",
                                       levels_[i].off,
                                       levels_[i - 1].step_hz,
                                       levels_[i].step_hz);
        }
        reference.notes.push_back(
            fmt::format("{} {:.1e}: halving its step changed the worst metric by {}",
                        good() ? "reference converged to" : "reference known only to",
                        finest.off,
                        differences));
        if (!good())
            reference.notes.push_back(
                fmt::format("errors below {:.1e} are not told apart", finest.off));
        if (spread_ > kGoodEnough)
            reference.notes.push_back(fmt::format(
                "copies that start {:.0e} m apart come {:.1e} apart", kShift_m, spread_));
        return reference;
    }

    /// Copies at the best rate that fits, and as many at half that rate to see whether it matters.
    Result<std::optional<SceneReference>> ensemble() {
        const double shift_m =
            copies_part() ? kShift_m : kWideShift * levels_.back().answer.body_size_m;
        int copies = kCopiesMany;
        int step_hz = 960;
        const auto too_dear = [&] {
            return 1.5 * copies * cost_of_next_s(step_hz) >
                   plan_.cpu_left_s(share_ + kShareOfCopies);
        };
        if (too_dear()) copies = kCopiesFew;
        while (too_dear() && step_hz > 120) step_hz /= 2;

        std::vector<SceneRun> runs;
        for (int first = 0; first < copies; first += 2) {
            const auto seed = static_cast<std::uint64_t>(first) + 1;
            runs.push_back(copies_at(step_hz, 2, seed, shift_m));
            runs.push_back(copies_at(step_hz / 2, 2, seed, shift_m));
        }
        std::array<SceneAnswer, 2> answers;
        const Result<Done> done = plan_.run(runs, [&](const ScenePlan::Finished& each) {
            std::optional<SceneAnswer> answer = whole_answer(each);
            if (!answer) return;
            std::vector<Trace>& before = answers[each.run % 2].traces;
            answer->traces.insert(answer->traces.begin(), before.begin(), before.end());
            answers[each.run % 2] = std::move(*answer);
        });
        if (!done) return done.error();
        if (plan_.interrupted()) return std::optional<SceneReference>{};
        if (answers[0].traces.empty()) return Error{.message = why_none()};
        return std::optional<SceneReference>(of_copies(answers[0], answers[1], step_hz, shift_m));
    }

    SceneReference of_copies(SceneAnswer fine,
                             const SceneAnswer& coarse,
                             int step_hz,
                             double shift_m) const {
        const std::size_t copies = fine.traces.size();
        SceneReference reference{.chaotic = true, .answer = std::move(fine), .shift_m = shift_m};
        reference.scales = scales_of(reference.answer);
        const std::vector<double> chance =
            ensemble_chance(reference.answer.traces, reference.scales);
        const std::vector<double> spread =
            ensemble_spread(reference.answer.traces, reference.scales);
        reference.uncertainty = worst_of(chance);
        reference.text = fmt::format(
            "medians of {} copies, small_step in float64 at {} Hz x 4", copies, step_hz);
        reference.notes.push_back(fmt::format(
            "{}: copies that start {:.0e} m apart come {:.1e} apart, halving the step at {} Hz "
            "changed {:.1e}; {} copies that start {:.1e} m apart are compared by their statistics",
            copies_part() ? "chaotic" : "too sensitive to compare run by run",
            kShift_m,
            spread_,
            levels_[levels_.size() - 2].step_hz,
            levels_.back().off,
            copies,
            shift_m));
        std::string bands;
        const std::vector<Metric> metrics = ensemble_metrics(reference.scales);
        for (std::size_t i = 0; i < metrics.size(); ++i) {
            bands += fmt::format("{}{} {:.1e}", i == 0 ? "" : ", ", metrics[i].name, spread[i]);
        }
        reference.notes.push_back(fmt::format("half of the copies' 5-95 % band: {}", bands));
        if (!coarse.traces.empty()) {
            const double off =
                worst_of(ensemble_errors(coarse.traces, reference.answer.traces, reference.scales));
            reference.notes.push_back(
                fmt::format("medians at {} and {} Hz differ by {:.1e}; by chance {:.1e}",
                            step_hz / 2,
                            step_hz,
                            off,
                            reference.uncertainty));
        }
        return reference;
    }

    ScenePlan& plan_;
    const SceneProbe& probe_;
    double share_;
    const UseRoughReference& use_rough_;
    std::size_t next_rate_{0};
    std::vector<Level> levels_;
    double spread_{0};
    std::string failure_;
};

}  // namespace

Result<std::optional<SceneReference>> make_reference(ScenePlan& plan,
                                                     const SceneProbe& probe,
                                                     double share,
                                                     const UseRoughReference& use_rough) {
    return ReferenceMaker(plan, probe, share, use_rough).make();
}

std::vector<double> errors_against(const SceneReference& reference, const SceneAnswer& answer) {
    if (reference.chaotic)
        return ensemble_errors(answer.traces, reference.answer.traces, reference.scales);
    return trajectory_errors(
        answer.traces.front(), reference.answer.traces.front(), reference.scales);
}

std::vector<Metric> metrics_of(const SceneReference& reference) {
    return reference.chaotic ? ensemble_metrics(reference.scales)
                             : trajectory_metrics(reference.scales);
}

}  // namespace plumbline::study
