// Images without a window: `render` and the tour. The same step, extraction and passes as play.
#pragma once

#include "engine/app/frame_report.h"
#include "engine/app/session.h"
#include "engine/assets/image_data.h"
#include "engine/platform/offscreen.h"
#include "engine/render/renderer.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace plumbline::app {

struct OffscreenDef {
    std::filesystem::path shader_folder;
    std::uint32_t width_px{1280};
    std::uint32_t height_px{720};
    std::optional<assets::Shading> shading{};     ///< --shading: over every material's own
    std::optional<render::QualityLevel> level{};  ///< absent: nothing is left out, full scale
    float render_scale{0.0F};                     ///< with a level; 0: the level's own
};

class OffscreenRun {
public:
    /// No usable GL: exit code 3.
    static Result<std::unique_ptr<OffscreenRun>> create(Session& session, const OffscreenDef& def);

    /// So many fixed steps without drawing.
    void simulate(std::uint64_t steps);
    /// The present state as it is to be drawn; `view` absent: the game's own.
    render::RenderFrame frame(const std::optional<scene::ViewPoint>& view = {});
    /// A shader that does not compile is an error (exit code 3).
    Result<Done> draw(const render::RenderFrame& frame);
    Result<Done> draw(const std::optional<scene::ViewPoint>& view = {});
    /// Compiled programs are made anew when they are needed.
    void forget_programs() { renderer_->forget_programs(); }
    assets::ImageData pixels(assets::ImageData spare = {}) const {
        return renderer_->read_pixels(std::move(spare));
    }

    const FrameReport& report() const { return report_; }
    std::string report_json() const;

private:
    OffscreenRun(Session& session, const OffscreenDef& def);

    Session& session_;
    OffscreenDef def_;
    FrameReport report_;
    std::unique_ptr<platform::OffscreenContext> context_;
    std::unique_ptr<render::Renderer> renderer_;  // after the context: it goes first
};

}  // namespace plumbline::app
