#include "engine/app/settings/quality_control.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::app {
namespace {

// The first frames compile and upload; the probe is the median of the next few.
constexpr std::size_t kFramesToSkip = 2;
constexpr std::size_t kProbeFrames = 3;
constexpr std::size_t kFramesToDecide = 8;
constexpr std::size_t kCalmToClimb = 3;
constexpr std::size_t kShortestWait = 8;
constexpr std::size_t kLongestWait = 512;
// Between these shares of the target nothing is changed.
constexpr double kTooDear = 1.1;
constexpr double kAim = 0.9;

struct LevelScales {
    render::QualityLevel level;
    double cost;  ///< at full scale, relative to high
    std::array<float, 7> scales;
};
// A scene costs something whatever its size on the screen: vertices, the passes in full size.
constexpr double kCostOfSizeZero = 0.35;
constexpr std::array<LevelScales, 3> kLadder{{
    {render::QualityLevel::Low, 0.46, {0.4F, 0.45F, 0.5F, 0.55F, 0.6F, 0.65F, 0.7F}},
    {render::QualityLevel::Medium, 0.77, {0.6F, 0.65F, 0.7F, 0.75F, 0.8F, 0.85F, 0.9F}},
    {render::QualityLevel::High, 1.0, {0.8F, 0.85F, 0.9F, 0.95F, 1.0F, 1.0F, 1.0F}},
}};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Where a CPU draws, level high leaves a third of the pixels to the sharp up-scaling, which is hard to
/// see: the garden keeps 12 frames a second.
constexpr float kHighOnCpu = 0.8F;

float scale_of(render::QualityLevel level, bool draws_on_cpu) {
    if (draws_on_cpu && level == render::QualityLevel::High) return kHighOnCpu;
    return render::quality_of(level).render_scale;
}

double cost_of(double level_cost, float scale) {
    const auto side = static_cast<double>(scale);
    return level_cost * (kCostOfSizeZero + (1.0 - kCostOfSizeZero) * side * side);
}

}  // namespace

std::vector<QualityControl::Rung> QualityControl::ladder(const QualityRequest& wish,
                                                         bool draws_on_cpu) {
    if (wish.level) {
        const float by_level = scale_of(*wish.level, draws_on_cpu);
        return {{*wish.level, wish.render_scale > 0.0F ? wish.render_scale : by_level, 1.0}};
    }
    std::vector<Rung> rungs;
    for (const LevelScales& level : kLadder) {
        if (wish.render_scale > 0.0F) {
            rungs.push_back(
                {level.level, wish.render_scale, cost_of(level.cost, wish.render_scale)});
            continue;
        }
        float before = 0.0F;
        for (const float scale : level.scales) {
            if (scale == before) break;
            rungs.push_back({level.level, scale, cost_of(level.cost, scale)});
            before = scale;
        }
    }
    return rungs;
}

QualityControl::QualityControl(const QualityRequest& wish, bool draws_on_cpu)
    : target_ms_(wish.target_ms),
      anti_aliasing_(wish.anti_aliasing),
      draws_on_cpu_(draws_on_cpu),
      rungs_(ladder(wish, draws_on_cpu)),
      too_dear_(rungs_.size()),
      next_wait_(kShortestWait) {
    // As well as it is likely to go. The CPU begins at low: compiling the shaders of another level
    // would hold up the first frame.
    const double start = draws_on_cpu ? 0.24 : 1.0;
    const auto too_much =
        std::ranges::find_if(rungs_, [&](const Rung& r) { return r.cost > start; });
    const auto count = static_cast<std::size_t>(too_much - rungs_.begin());
    go_to(std::max<std::size_t>(count, 1) - 1);
    frames_to_skip_ = kFramesToSkip;
}

bool QualityControl::go_to(std::size_t rung) {
    const bool changed = rung != at_;
    const bool another_level = rungs_[rung].level != rungs_[at_].level;
    at_ = rung;
    quality_ = render::quality_of(rungs_[at_].level);
    if (draws_on_cpu_) quality_ = render::without_gpu(quality_);
    quality_.render_scale = rungs_[at_].render_scale;
    if (anti_aliasing_) {
        quality_.anti_aliasing = *anti_aliasing_;
    } else if (!draws_on_cpu_ && rungs_[at_].level == render::QualityLevel::High) {
        quality_.anti_aliasing = render::AntiAliasing::Msaa4;
    }
    calm_ = 0;
    if (changed) frames_to_skip_ = another_level ? 2 * kFramesToSkip : kFramesToSkip;
    return changed;
}

std::size_t QualityControl::best_rung_for(double median_ms, double budget_ms) const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < rungs_.size(); ++i) {
        if (median_ms * rungs_[i].cost / rung().cost <= budget_ms) best = i;
    }
    return best;
}

bool QualityControl::add_frame(const FrameCost& cost) {
    if (!is_automatic()) return false;
    if (frames_to_skip_ > 0) {
        --frames_to_skip_;
        return false;
    }
    const bool by_wall = draws_on_cpu_ || cost.gpu_ms < 0.0;
    costs_ms_.push_back(by_wall ? cost.wall_ms : std::max(cost.cpu_ms, cost.gpu_ms));
    if (costs_ms_.size() < (probed_ ? kFramesToDecide : kProbeFrames)) return false;
    const double median_ms = median(std::move(costs_ms_));
    costs_ms_.clear();
    return decide(median_ms);
}

bool QualityControl::decide(double median_ms) {
    if (!probed_) {
        probed_ = true;
        return go_to(best_rung_for(median_ms, kAim * target_ms_));
    }
    if (wait_ > 0) --wait_;
    if (median_ms > kTooDear * target_ms_) {
        if (at_ == 0) return false;
        too_dear_ = at_;
        wait_ = next_wait_;
        next_wait_ = std::min(2 * next_wait_, kLongestWait);
        return go_to(std::min(best_rung_for(median_ms, kAim * target_ms_), at_ - 1));
    }
    // One rung up, if that looks affordable for a while and has not just been too dear.
    const std::size_t up = at_ + 1;
    if (up == rungs_.size() || (up >= too_dear_ && wait_ > 0) ||
        median_ms * rungs_[up].cost / rung().cost > kAim * target_ms_) {
        calm_ = 0;
        return false;
    }
    return ++calm_ >= kCalmToClimb && go_to(up);
}

QualityRequest quality_request_of(const AppConfig& config) {
    QualityRequest wish{.render_scale = config.render_scale,
                        .target_ms = static_cast<double>(config.target_ms)};
    // The levels are in one order, after "auto".
    if (config.quality_level != QualityLevel::Auto)
        wish.level = static_cast<render::QualityLevel>(static_cast<int>(config.quality_level) - 1);
    if (config.anti_aliasing != EdgeWish::Auto) {
        const auto found =
            std::ranges::find(render::kAntiAliasingNames,
                              kEdgeWishNames[static_cast<std::size_t>(config.anti_aliasing)]);
        wish.anti_aliasing =
            static_cast<render::AntiAliasing>(found - render::kAntiAliasingNames.begin());
    }
    if (wish.render_scale > 0.0F) {
        wish.render_scale = std::max(wish.render_scale, render::kSmallestRenderScale);
    }
    return wish;
}

std::optional<QualityLevel> quality_level_named(std::string_view name) {
    const auto found = std::ranges::find(kImageLevelNames, name);
    if (found == kImageLevelNames.end()) return std::nullopt;
    return static_cast<QualityLevel>(found - kImageLevelNames.begin());
}

}  // namespace plumbline::app
