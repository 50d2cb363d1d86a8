// What a run of frames cost: the file of `play --report` and `render --report`, and the numbers of
// the statistics panel.
#pragma once

#include "engine/core/actions.h"
#include "engine/effects/effect_runtime.h"
#include "engine/render/renderer.h"
#include "engine/scene/state_report.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::app {

/// How the image is drawn.
struct QualityInForce {
    std::string_view level{"full"};  ///< "low", "medium", "high"; "full": none was asked for
    bool is_automatic{false};
    render::Quality quality{};
};

/// What a report tells beside what was collected.
struct ReportContext {
    const scene::Simulation& simulation;
    const std::vector<effects::LedgerLine>& ledger;
    const render::GlInfo& gl;
    double lost_s{0};
    std::array<std::uint64_t, kActionCount> presses_seen{};
    std::string before{};  ///< of the scene before this one in the session; empty: there was none
};

/// What frames cost and how much memory the process held, in the seconds up to a time.
struct ReportInterval {
    double end_s{0};  ///< since the first frame
    std::uint64_t frames{0};
    double cpu_ms_per_frame{0};  ///< of the whole process
    std::size_t resident_bytes{0};
};

/// Collects frame by frame; ask for the JSON at the end.
class FrameReport {
public:
    /// `chosen_s`: when the scene was asked for, by wall_s(); absent: by starting the program.
    explicit FrameReport(std::optional<double> chosen_s = {}) : chosen_s_(chosen_s) {}

    void add_step(const physics::StepCost& cost) { physics_.add(cost); }
    /// wall_ms: from this frame's begin to its end, waiting for the screen included.
    void add_frame(double wall_ms, const render::FrameStats& stats);

    /// This frame's input opened the menu, which the frame shows already.
    void note_menu_opened() { opens_menu_ = true; }

    void set_image(const QualityInForce& image) { image_ = image; }
    const QualityInForce& image() const { return image_; }

    std::uint64_t frames() const { return frames_; }
    /// Of the last 120 frames, for the HUD.
    scene::Percentiles recent_frame_ms() const;
    /// At most the last 120, oldest first: ms of frames and of physics steps.
    std::span<const float> recent_frames() const;
    std::span<const float> recent_steps() const;
    /// The passes of the last frame, their times smoothed over some thirty frames.
    std::vector<render::PassTiming> recent_passes() const;
    /// What the phases and threads of a step took, smoothed over some thirty of them.
    const physics::StepCost& recent_step() const { return physics_.recent; }
    const render::FrameStats& last_stats() const { return last_; }
    const physics::Interventions& interventions() const { return physics_.interventions; }
    double startup_ms() const { return startup_ms_; }

    /// The object of docs/SCENE-FORMAT.md, "Play and render report".
    std::string json(const ReportContext& context) const;

private:
    struct PassTotal {
        double cpu_ms{0};
        double gpu_ms{0};
        std::uint64_t gpu_samples{0};
        double recent_cpu_ms{0};
        double recent_gpu_ms{0};
    };

    struct MenuFrame {
        float frame_ms{0};
        float median_before_ms{0};
    };

    /// One that took long, and where its time went.
    struct LongFrame {
        double at_s{0};  ///< since the first frame
        float frame_ms{0};
        std::uint32_t new_programs{0};
        std::vector<render::PassTiming> passes;
    };
    void keep_if_long(float frame_ms, const render::FrameStats& stats);
    /// Of the frames since the latest one that was kept.
    ReportInterval open_interval() const;

    std::optional<double> chosen_s_;
    QualityInForce image_;
    bool opens_menu_{false};
    std::vector<MenuFrame> menu_frames_;
    scene::CostHistory physics_;
    std::vector<float> frame_ms_;
    std::vector<LongFrame> long_frames_;  ///< longest first
    std::map<std::string, PassTotal> passes_;
    render::FrameStats last_;
    std::uint64_t frames_{0};
    std::uint64_t shadow_rendered_{0};
    std::uint64_t shadow_cached_{0};
    double startup_ms_{0};
    double first_frame_wall_s_{0};
    double first_frame_cpu_s_{0};
    double last_wall_s_{0};
    double last_cpu_s_{0};
    std::vector<ReportInterval> intervals_;
    double interval_cpu_s_{0};  ///< at the beginning of the open one
    std::uint64_t interval_frames_{0};
};

}  // namespace plumbline::app
