#include "engine/render/passes/screen/frame_targets.h"

#include "engine/core/log.h"

#include <fmt/format.h>

namespace plumbline::render {
namespace {

constexpr int kLastTry = 2;

}  // namespace

gl::TargetFormat light_format(const GpuLimits& limits) {
    return limits.half_float_targets ? gl::TargetFormat::HdrColor : gl::TargetFormat::Srgb8;
}

std::optional<ImagePlan> FrameTargets::fit(const RenderFrame& frame,
                                           const Device& device,
                                           const assets::AssetLibrary& library) {
    const PixelSize asked_px{frame.width_px, frame.height_px};
    if (asked_px_ != asked_px) failed_tries_ = 0;
    asked_px_ = asked_px;
    for (;; ++failed_tries_) {
        ImagePlan plan =
            plan_image(frame, quality_in_force(frame, device, failed_tries_), device, library);
        resize_present(plan, device);
        if (present_px_.width == 0 || present_px_.height == 0) return {};
        const Result<Done> sized = resize_scene(plan, device);
        if (sized) {
            if (!plan.writes_codes) plan.samples = scene_.samples();
            return plan;
        }
        if (failed_tries_ == kLastTry) {
            log_error("nothing can be drawn: {}", sized.error().message);
            return {};
        }
        log_warning("{}: {}",
                    sized.error().message,
                    failed_tries_ == 0 ? "half the render scale is tried"
                                       : "the lowest image level is tried");
    }
}

void FrameTargets::resize_present(const ImagePlan& plan, const Device& device) {
    const bool is_there = present_px_ == plan.present_px && own_framebuffer_;
    present_px_ = plan.present_px;
    if (!device.is_offscreen || is_there || present_px_.width == 0 || present_px_.height == 0)
        return;
    const auto [width_px, height_px] = present_px_;
    own_framebuffer_ = {};
    color_ = gl::Texture::target(gl::TargetFormat::Rgba8, width_px, height_px, gl::Filter::Nearest);
    depth_ =
        gl::Texture::target(gl::TargetFormat::Depth24, width_px, height_px, gl::Filter::Nearest);
    own_framebuffer_ = gl::Framebuffer{&color_, &depth_};
}

Result<Done> FrameTargets::resize_scene(const ImagePlan& plan, const Device& device) {
    if (plan.writes_codes) {
        scene_ = {};
        return post_.resize(plan);
    }
    const gl::TargetFormat format = light_format(device.limits);
    const std::size_t most_bytes = device.limits.target_bytes;
    if (most_bytes > 0 &&
        SceneTarget::bytes_for(plan.scene_px, format, plan.samples) > most_bytes) {
        return Error{fmt::format("the driver has no memory for an image of {} x {}",
                                 plan.scene_px.width,
                                 plan.scene_px.height)};
    }
    const Result<Done> sized = scene_.resize(plan.scene_px, format, plan.samples);
    return sized ? post_.resize(plan) : sized;
}

void FrameTargets::bind_present() const {
    gl::draw_into(present_framebuffer(), present_px_.width, present_px_.height);
}

}  // namespace plumbline::render
