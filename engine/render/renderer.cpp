#include "engine/render/renderer.h"

#include "engine/core/log.h"
#include "engine/render/gl/debug.h"
#include "engine/render/renderer_impl.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace plumbline::render {
namespace {

std::string gl_text(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

Result<GlInfo> load_gl(GlLoader loader) {
    const int version = loader != nullptr ? gladLoadGL(loader) : 0;
    if (version == 0) {
        return Error{"the driver hands out no OpenGL functions", ExitCode::NoDisplay};
    }
    GlInfo info{gl_text(GL_VENDOR), gl_text(GL_RENDERER), gl_text(GL_VERSION)};
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        return Error{fmt::format("OpenGL 3.3 is needed; found {} ({}, {})",
                                 info.version,
                                 info.vendor,
                                 info.renderer),
                     ExitCode::NoDisplay};
    }
    return info;
}

/// Mesa's renderers that draw on the CPU: there every shadow lookup costs milliseconds.
bool is_software(const GlInfo& info) {
    return info.renderer.find("llvmpipe") != std::string::npos ||
           info.renderer.find("softpipe") != std::string::npos;
}

GLenum polygon_mode(FillMode mode) {
    switch (mode) {
        case FillMode::Filled:
            return GL_FILL;
        case FillMode::Wireframe:
            return GL_LINE;
        case FillMode::Points:
            return GL_POINT;
    }
    return GL_FILL;
}

void set_depth_test(DepthTest test) {
    if (test == DepthTest::Off) {
        glDisable(GL_DEPTH_TEST);
        return;
    }
    constexpr std::array<GLenum, 4> kFunctions{GL_LESS, GL_ALWAYS, GL_NEVER, GL_GREATER};
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(kFunctions[static_cast<std::size_t>(test)]);
}

// Casters of a lamp's shadow may be coarser by so much: a texel's width at two metres.
constexpr float kLightShadowError_m = 0.008F;

/// The driver's report of lost devices, by the name under which it has one; null: it has none.
ResetStatus reset_status_of(GlLoader loader) {
    const auto named = [&](const char* name) {
        return reinterpret_cast<ResetStatus>(loader(name));
    };
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor >= 45) return named("glGetGraphicsResetStatus");
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name =
            reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (name != nullptr && std::string_view(name) == "GL_ARB_robustness")
            return named("glGetGraphicsResetStatusARB");
    }
    return nullptr;
}

// What a window spends on programs that are new to it: in the first frame of a scene, and in others.
constexpr double kFirstPrograms_s = 0.3;
constexpr double kNewPrograms_s = 0.008;

// More than a window has pixels; larger images only cost a software driver its memory.
constexpr std::uint32_t kSoftwareMap_px = 4096;

GpuLimits within_driver(GpuLimits limits, bool is_software_gl) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto driver_px = static_cast<std::uint32_t>(std::max(largest, 1024));
    limits.texture_px = limits.texture_px == 0 ? driver_px : std::min(limits.texture_px, driver_px);
    if (limits.map_px == 0) limits.map_px = is_software_gl ? kSoftwareMap_px : limits.texture_px;
    limits.map_px = std::min(limits.map_px, limits.texture_px);
    const auto half_floats =
        gl::Texture::target(gl::TargetFormat::HdrColor, 4, 4, gl::Filter::Nearest);
    limits.half_float_targets =
        limits.half_float_targets && gl::Framebuffer{&half_floats, nullptr}.complete();
    if (!limits.half_float_targets)
        log_warning(
            "the driver draws into no half floats: light is cut at white, without bloom "
            "and exposure that adapts");
    return limits;
}

}  // namespace

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(GlLoader loader,
                                                   PresentTarget target,
                                                   const std::filesystem::path& shader_folder,
                                                   assets::AssetLibrary& library,
                                                   const GpuLimits& limits) {
    auto info = load_gl(loader);
    if (!info) return info.error();
    gl::listen_to_driver();
    const bool is_software_gl = is_software(*info);
    auto impl = std::make_unique<Impl>(
        target, shader_folder, library, within_driver(limits, is_software_gl));
    impl->gl = std::move(*info);
    impl->is_software_gl = is_software_gl;
    impl->reset_status = reset_status_of(loader);
    for (const ShaderPair& pair : kShaderPairs) {
        const auto found = impl->scene.shaders.check_files(pair);
        if (!found) return found.error();
    }
    const auto compiled =
        impl->scene.shaders.compile(kMeshShader, feature::kUnlit | feature::kVertexColor);
    if (!compiled) return compiled.error();
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glPointSize(2.0F);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);  // flat shading goes by it
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

void Renderer::begin(const RenderFrame& frame) {
    Impl& r = *impl_;
    r.stats = {};
    r.timers.begin_frame();
    // A window is better off with simpler light for some frames than with one frame of seconds.
    if (r.target == PresentTarget::Window)
        r.scene.shaders.allow_new(r.drew_a_frame ? kNewPrograms_s : kFirstPrograms_s);
    r.set_up(frame);
    if (r.nothing_to_draw) return;
    r.build_draw_lists();
    gl::bind_uniforms(kFrameBinding, r.frame_buffer, 0, sizeof(FrameBlock));
}

void Renderer::shadows() {
    Impl& r = *impl_;
    if (r.nothing_to_draw) return;
    if ((r.features & feature::kSunShadow) != 0) {
        const gl::PassTimers::Scope timed(r.timers, "shadow.sun");
        r.sun_shadow.render(r.sun_views, *r.frame, r.scene, r.stats);
    } else {
        r.sun_shadow.free();
    }
    if (r.flashlight_view) {
        const gl::PassTimers::Scope timed(r.timers, "shadow.flashlight");
        r.flashlight_shadow.render({&*r.flashlight_view, 1}, *r.frame, r.scene, r.stats);
    } else {
        r.flashlight_shadow.free();
    }
    if ((r.features & feature::kLightShadows) != 0) {
        const gl::PassTimers::Scope timed(r.timers, "shadow.lights");
        const float error_m = r.quality.lod_error_px > 0.0F ? kLightShadowError_m : 0.0F;
        r.light_shadow.render(
            r.light_choice.chosen(), r.light_shadow_px(), error_m, *r.frame, r.scene, r.stats);
    } else if (!r.frame->light_shadows || r.quality.shadowed_lights == 0) {
        r.light_shadow.free();
    }
}

void Renderer::opaque() {
    Impl& r = *impl_;
    if (r.nothing_to_draw) return;
    const gl::PassTimers::Scope timed(r.timers, "opaque");
    if (r.draws_codes) {
        r.bind_present_target();
    } else {
        r.scene_target.bind();
        if (r.light_format() == gl::TargetFormat::Srgb8) glEnable(GL_FRAMEBUFFER_SRGB);
    }
    const Vec3f clear = r.clear_color();
    glClearColor(clear.x, clear.y, clear.z, 1.0F);
    glDepthMask(GL_TRUE);
    // The sky is drawn wherever nothing else is.
    const bool sky_covers = r.frame->sky && r.scene.sky.ready();
    glClear(GL_DEPTH_BUFFER_BIT | (sky_covers ? 0U : GL_COLOR_BUFFER_BIT));
    set_depth_test(r.frame->depth_test);
    glDisable(GL_BLEND);
    glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(r.frame->fill_mode));
    if ((r.features & feature::kSunShadow) != 0) {
        gl::bind_texture(kSunShadowUnit, gl::TextureKind::Flat, r.sun_shadow.map());
    }
    r.bind_sun_depth();
    if ((r.features & feature::kLightShadows) != 0) {
        gl::bind_texture(kLightShadowUnit, gl::TextureKind::Flat, r.light_shadow.map());
    }
    if (r.flashlight_view) {
        gl::bind_texture(kFlashlightShadowUnit, gl::TextureKind::Flat, r.flashlight_shadow.map());
    }
    if (r.scene.sky.ready()) {
        gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, r.scene.sky.reflection());
    }
    r.bind_base_sampler();
    r.opaque_pass.render(r.opaque_draws, r.opaque_kind(), r.mesh_view(), r.scene, r.stats);
    glBindSampler(kBaseColorUnit, 0);
    glEnable(GL_DEPTH_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void Renderer::sky() {
    Impl& r = *impl_;
    if (r.nothing_to_draw || !r.frame->sky || !r.scene.sky.ready()) return;
    const gl::PassTimers::Scope timed(r.timers, "sky");
    render_sky(r.triangle, r.features, r.scene, r.stats);
}

void Renderer::translucent() {
    Impl& r = *impl_;
    if (r.nothing_to_draw) return;
    const bool has_drops = DropPass::has_work(*r.frame);
    if (!has_drops) r.drop_pass.free();
    if (!r.frame->refraction) r.refraction_pass.free();
    if (r.translucent_draws.runs.empty() && !has_drops) return;
    r.copy_behind_water();
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // What of the light can be occluded, in alpha, is hidden as the light itself is.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    if (!r.translucent_draws.runs.empty()) {
        const gl::PassTimers::Scope timed(r.timers, "translucent");
        if (r.scene.sky.ready()) {
            gl::bind_texture(kSkyUnit, gl::TextureKind::Cube, r.scene.sky.reflection());
        }
        glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(r.frame->fill_mode));
        r.bind_base_sampler();
        r.translucent_pass.render(
            r.translucent_draws, DrawKind::Translucent, r.mesh_view(), r.scene, r.stats);
        glBindSampler(kBaseColorUnit, 0);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    if (has_drops) {
        const gl::PassTimers::Scope timed(r.timers, "drops");
        r.drop_pass.render(*r.frame, r.features, r.post_view.scene_px.height, r.scene, r.stats);
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void Renderer::post() {
    Impl& r = *impl_;
    if (r.nothing_to_draw) return;
    glDisable(GL_FRAMEBUFFER_SRGB);
    const SceneLight light = r.finish_light();
    if (r.draws_codes) return;
    if (r.post_view.bloom) {
        const gl::PassTimers::Scope timed(r.timers, "post.bloom");
        r.post.render_bloom(light, r.triangle, r.scene, r.stats);
    }
    r.adapt_exposure();
    const gl::PassTimers::Scope timed(r.timers, "image");
    r.post.render_image(light,
                        r.scene_target.depth(),
                        r.post_view,
                        r.present_framebuffer(),
                        r.triangle,
                        r.scene,
                        r.stats);
}

void Renderer::lines() {
    Impl& r = *impl_;
    if (r.nothing_to_draw) return;
    r.bind_present_target();
    if (r.frame->lines.vertices.empty()) return;
    const gl::PassTimers::Scope timed(r.timers, "lines");
    r.line_pass.render(r.frame->lines, r.scene, r.stats);
}

void Renderer::end() {
    Impl& r = *impl_;
    r.stats.passes = r.timers.timings();
    r.stats.new_programs = r.scene.shaders.new_count();
    r.drew_a_frame = r.drew_a_frame || !r.nothing_to_draw;
    r.frame = nullptr;
    if (r.reset_status != nullptr && r.reset_status() != GL_NO_ERROR) r.device_lost = true;
    // Nobody presents an off-screen image: without this, frames would pile up in the driver,
    // with their memory, and the time of a frame would be that of asking for it.
    if (r.target == PresentTarget::Offscreen) glFinish();
}

void Renderer::forget_scene() {
    Impl& r = *impl_;
    r.scene.meshes.clear();
    r.scene.textures.clear();
    r.scene.materials.clear();
    r.scene.sky.want(nullptr, {});
    r.drew_a_frame = false;
    r.sun_shadow.free();
    r.flashlight_shadow.free();
}

void Renderer::forget_programs() {
    impl_->scene.shaders.clear();
}

Result<Done> Renderer::reload_shaders() {
    return impl_->scene.shaders.reload();
}

const std::string& Renderer::shader_fault() const {
    return impl_->scene.shaders.fault();
}

assets::ImageData Renderer::read_pixels(assets::ImageData spare) const {
    const Impl& r = *impl_;
    assets::ImageData image{.width = r.width_px,
                            .height = r.height_px,
                            .format = assets::PixelFormat::Rgb8,
                            .bytes = std::move(spare.bytes)};
    const std::size_t row = std::size_t{r.width_px} * 3;
    image.bytes.resize(row * r.height_px);
    if (image.bytes.empty()) return image;
    r.bind_present_target();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0,
                 0,
                 static_cast<GLsizei>(r.width_px),
                 static_cast<GLsizei>(r.height_px),
                 GL_RGB,
                 GL_UNSIGNED_BYTE,
                 image.bytes.data());
    // OpenGL's rows run from the bottom.
    for (std::size_t y = 0; y < r.height_px / 2; ++y) {
        std::swap_ranges(image.bytes.begin() + static_cast<std::ptrdiff_t>(y * row),
                         image.bytes.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         image.bytes.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    }
    return image;
}

const FrameStats& Renderer::stats() const {
    return impl_->stats;
}

std::vector<GpuBytes> Renderer::gpu_bytes() const {
    const Impl& r = *impl_;
    return {{"sun_shadow", r.sun_shadow.bytes()},
            {"flashlight", r.flashlight_shadow.bytes()},
            {"light_shadows", r.light_shadow.bytes()},
            {"sky", r.scene.sky.bytes()},
            {"post", r.post.bloom_bytes() + r.exposure_meter.bytes()},
            {"drops", r.drop_pass.bytes()},
            {"refraction", r.refraction_pass.bytes()},
            {"ambient_occlusion", r.occlusion_pass.bytes()},
            {"sun_shafts", r.shaft_pass.bytes()},
            {"depth_of_field", r.focus_pass.bytes()},
            {"motion_blur", r.motion_blur_pass.bytes()},
            {"meshes", r.scene.meshes.bytes()},
            {"textures", r.scene.textures.bytes()},
            {"targets",
             r.color_image.bytes() + r.depth_image.bytes() + r.scene_target.bytes() +
                 r.post.image_bytes()}};
}

bool Renderer::device_lost() const {
    return impl_->device_lost;
}

bool Renderer::draws_in_software() const {
    return impl_->is_software_gl;
}

const GlInfo& Renderer::gl() const {
    return impl_->gl;
}

}  // namespace plumbline::render
