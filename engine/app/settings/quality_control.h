// Chooses what the image may cost, so that a frame takes about as long as wished for. Pure: it is
// told what frames cost and says how to draw the next one.
//
// It stands on a ladder of rungs, each a level with a render scale, cheapest first. The first frames
// are a probe, after which it goes where the budget allows at once; from then on it moves when the
// median of some frames is off for long enough. A rung that turned out too dear is not tried again
// for a while, twice as long each time: it never swings between two.
#pragma once

#include "engine/app/settings/app_config.h"
#include "engine/render/quality.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace plumbline::app {

/// What the settings ask for.
struct QualityRequest {
    std::optional<render::QualityLevel> level{};          ///< absent: auto
    float render_scale{0.0F};                             ///< 0: by level
    std::optional<render::AntiAliasing> anti_aliasing{};  ///< absent: by level and GPU
    double target_ms{33.0};                               ///< of a frame; only for auto

    friend bool operator==(const QualityRequest&, const QualityRequest&) = default;
};

QualityRequest quality_request_of(const AppConfig& config);
/// "auto", "low", "medium", "high".
std::optional<QualityLevel> quality_level_named(std::string_view name);

/// What one frame took.
struct FrameCost {
    double wall_ms{0};  ///< from its begin until it was handed to the screen
    double cpu_ms{0};   ///< of that, until the screen was waited for
    double gpu_ms{-1};  ///< by the driver's timer; -1: it has none
};

class QualityControl {
public:
    /// `draws_on_cpu`: then waiting for the screen is drawing, and the wall clock counts.
    QualityControl(const QualityRequest& wish, bool draws_on_cpu);

    /// How to draw the next frame.
    const render::Quality& quality() const { return quality_; }
    render::QualityLevel level() const { return rung().level; }
    bool is_automatic() const { return rungs_.size() > 1; }

    /// After each frame. True when the next one is to be drawn in another way.
    bool add_frame(const FrameCost& cost);

private:
    struct Rung {
        render::QualityLevel level{};
        float render_scale{1.0F};
        double cost{1.0};  ///< relative to the dearest
    };

    static std::vector<Rung> ladder(const QualityRequest& wish, bool draws_on_cpu);
    const Rung& rung() const { return rungs_[at_]; }
    std::size_t best_rung_for(double median_ms, double budget_ms) const;
    bool go_to(std::size_t rung);
    bool decide(double median_ms);

    double target_ms_;
    std::optional<render::AntiAliasing> anti_aliasing_;
    bool draws_on_cpu_;
    std::vector<Rung> rungs_;
    std::size_t at_{0};
    render::Quality quality_;
    std::vector<double> costs_ms_;   ///< since the last decision
    std::size_t frames_to_skip_{0};  ///< after a change: programs are compiled, images made
    bool probed_{false};
    std::size_t calm_{0};    ///< decisions in a row at which more could be afforded
    std::size_t too_dear_;   ///< the rung that was; rungs_.size(): none
    std::size_t wait_{0};    ///< decisions until it may be tried again
    std::size_t next_wait_;  ///< of the next rung that turns out so
};

}  // namespace plumbline::app
