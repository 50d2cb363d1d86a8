#include "game/commands/study/image_study_command.h"

#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/image/image_reference.h"
#include "engine/study/image/image_variants.h"
#include "engine/study/progress.h"
#include "game/command_line/camera_text.h"
#include "game/offscreen/offscreen_studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

namespace plumbline::game {
namespace {

constexpr double kUsual_s = 2.0;
constexpr std::uint32_t kSamplesPerSide = 4;
constexpr std::uint32_t kManyLooks = 8;  // for horizons, in the reference
constexpr int kPairs = 4;
constexpr int kFramesOfATurn = 3;

/// Absent: the scene's own.
using View = std::optional<scene::ViewPoint>;

/// The frame as light, of level high: no curve, no glow between the scene's light and the screen.
render::RenderFrame frame_of_high(OffscreenStudio& studio, const View& view) {
    render::RenderFrame frame = studio.run->frame(view);
    frame.quality = render::quality_of(render::QualityLevel::High);
    frame.post.reset();
    // Light of the air and lenses mix what rays tell apart.
    frame.shafts.reset();
    frame.depth_of_field.reset();
    frame.motion_blur.reset();
    frame.lines = {};
    return frame;
}

Result<assets::ImageData> drawn(OffscreenStudio& studio, const render::RenderFrame& frame) {
    if (const Result<Done> done = studio.run->draw(frame); !done) return done.error();
    return studio.run->pixels();
}

Result<study::LightImage> make_reference(OffscreenStudio& studio, const View& view) {
    render::RenderFrame frame = frame_of_high(studio, view);
    const study::IsShaded is_shaded = study::shaded_by_rays(frame, studio.session->library);
    frame.width_px *= kSamplesPerSide;
    frame.height_px *= kSamplesPerSide;
    frame.quality = {};  // nothing is left out
    frame.sun_shadow.reset();
    if (frame.occlusion) {
        frame.occlusion->slices = kManyLooks;
        frame.occlusion->steps = kManyLooks;
    }
    const Result<assets::ImageData> in_sun = drawn(studio, frame);
    if (!in_sun) return in_sun.error();
    frame.sun_reaches_ground = false;
    const Result<assets::ImageData> without_sun = drawn(studio, frame);
    if (!without_sun) return without_sun.error();
    return study::reference_image(*in_sun, *without_sun, kSamplesPerSide, is_shaded);
}

/// CPU ms of a frame, of all threads, while the scene goes on; the last one is read back, so that all
/// are really there.
double frame_ms(OffscreenStudio& studio, const View& view, const study::ImageVariant& variant) {
    double drawing_s = 0;
    for (int i = -1; i < kFramesOfATurn; ++i) {
        studio.run->simulate(1);
        render::RenderFrame frame = studio.run->frame(view);
        frame.quality = render::quality_of(render::QualityLevel::High);
        variant.apply(frame);
        const double start_s = process_cpu_s();
        // Cannot fail any more: the same shaders have drawn the image that was compared.
        static_cast<void>(studio.run->draw(frame));
        if (i < 0 || i + 1 == kFramesOfATurn) studio.run->pixels();
        if (i >= 0) drawing_s += process_cpu_s() - start_s;
    }
    return drawing_s * 1e3 / kFramesOfATurn;
}

void measure_cost(OffscreenStudio& studio,
                  const View& view,
                  const study::ImageVariant& variant,
                  const study::ImageVariant& base,
                  study::ImageRow& row) {
    std::vector<double> ms;
    std::vector<double> base_ms;
    for (int i = 0; i < kPairs && !interrupted(); ++i) {
        if (i % 2 == 0) base_ms.push_back(frame_ms(studio, view, base));
        ms.push_back(frame_ms(studio, view, variant));
        if (i % 2 == 1) base_ms.push_back(frame_ms(studio, view, base));
    }
    row.cpu_ms = ms.empty() ? 0.0 : *std::ranges::min_element(ms);
    row.more_ms = study::paired_difference(ms, base_ms);
}

}  // namespace

Result<ImageStudy> study_image(const ImageStudyOptions& options) {
    Result<OffscreenStudio> studio = OffscreenStudio::open(options.scene);
    if (!studio) return studio.error();
    View view;
    if (!options.camera.empty()) {
        view = parse_camera(options.camera,
                            studio->session->simulation->description().camera.fov_y_rad);
        if (!view)
            return Error{
                .message = fmt::format("--camera {}: expected x,y,z,yaw,pitch", options.camera),
                .exit_code = ExitCode::BadUsage};
    }
    const double steps = options.seconds.value_or(kUsual_s) / studio->session->simulation->step_s();
    studio->run->simulate(static_cast<std::uint64_t>(std::llround(steps)));
    Result<study::LightImage> reference = make_reference(*studio, view);
    if (!reference) return reference.error();
    ImageStudy made{.findings = {.scene = options.scene.filename().string(),
                                 .width_px = reference->width_px,
                                 .height_px = reference->height_px,
                                 .samples_per_pixel = kSamplesPerSide * kSamplesPerSide,
                                 .mean_luminance = study::mean_luminance(*reference)},
                    .reference = std::move(*reference)};

    const render::RenderFrame high = frame_of_high(*studio, view);
    std::vector<study::ImageVariant> variants = study::image_variants(high);
    if (options.levels_only) variants.resize(study::kImageLevels);
    for (const study::ImageVariant& variant : variants) {
        render::RenderFrame frame = high;
        variant.apply(frame);
        const Result<assets::ImageData> image = drawn(*studio, frame);
        if (!image) return image.error();
        made.findings.rows.push_back(
            {.name = variant.name,
             .error = study::image_error(study::light_of(*image), made.reference)});
    }
    study::ProgressBar bar(study::ProgressBar::Shown::Yes);
    const double start_s = wall_s();
    for (std::size_t i = 0; i < variants.size() && !interrupted(); ++i) {
        measure_cost(*studio, view, variants[i], variants.front(), made.findings.rows[i]);
        const double share = static_cast<double>(i + 1) / static_cast<double>(variants.size());
        bar.show(share, (wall_s() - start_s) * (1.0 - share) / share);
    }
    made.complete = !interrupted();
    std::erase_if(made.findings.rows,
                  [](const study::ImageRow& row) { return row.more_ms.pairs == 0; });
    study::judge(made.findings);
    return made;
}

}  // namespace plumbline::game
