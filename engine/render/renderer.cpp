#include "engine/render/renderer.h"

#include "engine/render/frame_passes.h"
#include "engine/render/renderer_impl.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <optional>

namespace plumbline::render {
namespace {

GLenum polygon_mode(FillMode mode) {
    constexpr std::array<GLenum, 3> kModes{GL_FILL, GL_LINE, GL_POINT};
    return kModes[static_cast<std::size_t>(mode)];
}

/// Nothing passes where every depth is refused, or lies before all that there is.
bool draws_nothing(DepthTest test) {
    return test == DepthTest::Never || test == DepthTest::Greater;
}

// What a window spends on programs that are new to it: in the first frame of a scene, and in others.
constexpr double kFirstPrograms_s = 0.3;
constexpr double kNewPrograms_s = 0.008;

}  // namespace

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(GlLoader loader,
                                                   PresentTarget target,
                                                   const std::filesystem::path& shader_folder,
                                                   assets::AssetLibrary& library,
                                                   const GpuLimits& limits) {
    auto device = load_device(loader, target, limits);
    if (!device) return device.error();
    auto impl = std::make_unique<Impl>(std::move(*device), shader_folder, library);
    for (const ShaderPair& pair : kShaderPairs) {
        const auto found = impl->scene.shaders.check_files(pair);
        if (!found) return found.error();
    }
    const auto compiled =
        impl->scene.shaders.compile(kMeshShader, mesh_feature::kUnlit | mesh_feature::kVertexColor);
    if (!compiled) return compiled.error();
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glPointSize(2.0F);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);  // flat shading goes by it
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

std::optional<FrameSetup> Renderer::Impl::set_up_frame(const RenderFrame& frame) {
    const std::optional<ImagePlan> image = targets.fit(frame, gl.device, scene.library);
    if (!image) return {};
    if (image->quality.lod_error_px > 0.0F) scene.meshes.make_lods();
    scene.sky.want(frame.sky ? &*frame.sky : nullptr, frame.sun);
    scene.materials.update({.shading = frame.shading,
                            .textures = frame.textures,
                            .surface_maps = image->quality.surface_maps,
                            .parallax = image->quality.parallax != Drawn::Never,
                            .refraction = image->refraction,
                            .caustics = image->refraction && frame.refraction->caustics});
    return set_up(frame, *image, {gl.device, scene.library, scene.sky, lamps_before});
}

void Renderer::Impl::upload_uniforms(const FrameSetup& frame_setup) {
    uniforms.block.upload(&frame_setup.block, sizeof(frame_setup.block));
    gl::bind_uniforms(kFrameBinding, uniforms.block, 0, sizeof(FrameBlock));
    const LampSetup& lamps = frame_setup.lamps;
    if (lamps.lights.empty()) return uniforms.lights.free();
    uniforms.lights.upload(lamps.lights,
                           lamps.shadow_places,
                           {.view_from_world = frame_setup.screen.view_from_world,
                            .tan_x = frame_setup.screen.tan_half.x,
                            .tan_y = frame_setup.screen.tan_half.y});
}

void Renderer::begin(const RenderFrame& frame) {
    Impl& r = *impl_;
    r.stats = {};
    r.shadow_maps = {};
    r.timers.begin_frame();
    if (r.gl.device.is_offscreen) {
        r.scene.shaders.begin_frame();
    } else {
        // A window is better off with simpler light for some frames than with one frame of seconds.
        r.scene.shaders.begin_frame(r.drew_a_frame ? kNewPrograms_s : kFirstPrograms_s);
    }
    r.setup = r.set_up_frame(frame);
    if (!r.setup) return;
    FrameSetup& setup = *r.setup;
    r.scene.light_grid.want(frame, outside_light(setup.block), r.scene.library);
    const bool is_coarse = setup.image.quality.lod_error_px > 0.0F;
    for (const DrawItem& item : frame.items) {
        // An upload makes the coarser versions of a mesh.
        if (is_coarse && item.mesh.value != 0)
            r.scene.meshes.get(item.mesh, materials_of(frame, item));
    }
    setup.draws =
        set_up_draws(setup, r.scene.library, is_coarse ? &r.scene.meshes.lods() : nullptr);
    r.lamps_before = setup.lamps.choice;
    r.stats.scene_width_px = setup.image.scene_px.width;
    r.stats.scene_height_px = setup.image.scene_px.height;
    r.stats.shadowed_lights = static_cast<std::uint32_t>(r.lamps_before.chosen().size());
    r.stats.unshadowed_lights = r.lamps_before.left_out();
    r.upload_uniforms(setup);
}

void Renderer::shadows() {
    Impl& r = *impl_;
    if (r.setup) r.shadow_maps = draw_shadow_maps(*r.setup, r.shadow_passes, r.context());
}

void Renderer::opaque() {
    Impl& r = *impl_;
    if (!r.setup) return;
    const FrameSetup& setup = *r.setup;
    const gl::PassTimers::Scope timed(r.timers, "opaque");
    if (setup.image.writes_codes) {
        r.targets.bind_present();
    } else {
        r.targets.scene().bind();
        if (light_format(r.gl.device.limits) == gl::TargetFormat::Srgb8)
            glEnable(GL_FRAMEBUFFER_SRGB);
    }
    const Vec3f clear = background_of(setup);
    glClearColor(clear.x, clear.y, clear.z, 1.0F);
    glDepthMask(GL_TRUE);
    // The sky is drawn wherever nothing else is.
    const bool sky_covers = setup.frame->sky && r.scene.sky.ready();
    glClear(GL_DEPTH_BUFFER_BIT | (sky_covers ? 0U : GL_COLOR_BUFFER_BIT));
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const DepthTest test = setup.frame->depth_test;
    if (draws_nothing(test)) return;
    glDepthFunc(test == DepthTest::Less ? GL_LESS : GL_ALWAYS);
    glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(setup.frame->fill_mode));
    bind_light_images(setup, r.shadow_maps, r.scene, r.samplers);
    r.samplers.bind_base(share_of_height(setup.image));
    r.scene_passes.opaque.render(
        setup.draws.opaque, setup.draws.opaque_kind, setup, {}, r.context());
    Samplers::unbind_base();
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    // Without the test nothing would have been written: the same draws, and then no depth, save the
    // driver a set of programs.
    if (test == DepthTest::Off) glClear(GL_DEPTH_BUFFER_BIT);
}

void Renderer::sky() {
    Impl& r = *impl_;
    if (!r.setup) return;
    const FrameSetup& setup = *r.setup;
    if (setup.frame->sky && r.scene.sky.ready()) {
        const gl::PassTimers::Scope timed(r.timers, "sky");
        render_sky(setup.image.writes_codes, r.context());
    }
    if (setup.frame->fog) {
        const gl::PassTimers::Scope timed(r.timers, "fog");
        render_fog(setup, r.targets.scene(), r.context());
    }
}

void Renderer::translucent() {
    Impl& r = *impl_;
    if (!r.setup) return;
    const FrameSetup& setup = *r.setup;
    const bool has_drops = DropPass::has_work(*setup.frame);
    if (!has_drops) r.scene_passes.drops.free();
    const std::optional<PixelPart> behind =
        copy_behind_water(setup, r.targets.scene(), r.scene_passes.refraction, r.context());
    if (setup.draws.translucent.runs.empty() && !has_drops) return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    // What of the light can be occluded, in alpha, is hidden as the light itself is.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    if (!setup.draws.translucent.runs.empty()) {
        const gl::PassTimers::Scope timed(r.timers, "translucent");
        bind_light_images(setup, r.shadow_maps, r.scene, r.samplers);
        glPolygonMode(GL_FRONT_AND_BACK, polygon_mode(setup.frame->fill_mode));
        r.samplers.bind_base(share_of_height(setup.image));
        r.scene_passes.translucent.render(
            setup.draws.translucent, DrawKind::Translucent, setup, behind, r.context());
        Samplers::unbind_base();
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    if (has_drops) {
        const gl::PassTimers::Scope timed(r.timers, "drops");
        r.scene_passes.drops.render(setup, r.context());
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void Renderer::post() {
    Impl& r = *impl_;
    if (!r.setup) return;
    const FrameSetup& setup = *r.setup;
    glDisable(GL_FRAMEBUFFER_SRGB);
    const SceneLight light =
        finish_light(setup, r.targets.scene(), r.shadow_maps, r.light_passes, r.context());
    if (setup.image.writes_codes) return;
    if (setup.image.bloom) {
        const gl::PassTimers::Scope timed(r.timers, "post.bloom");
        r.targets.post().render_bloom(light, r.context());
    }
    if (const std::optional<float> exposure =
            measured_exposure(setup, r.gl.device, r.targets.scene(), r.light_passes, r.context())) {
        FrameBlock adapted = setup.block;
        adapted.tone.x *= *exposure;
        r.uniforms.block.upload(&adapted, sizeof(adapted));
    }
    const gl::PassTimers::Scope timed(r.timers, "image");
    r.targets.post().render_image(light,
                                  r.targets.scene().depth(),
                                  setup.image,
                                  r.targets.present_framebuffer(),
                                  r.context());
}

void Renderer::lines() {
    Impl& r = *impl_;
    if (!r.setup) return;
    r.targets.bind_present();
    if (r.setup->frame->lines.vertices.empty()) return;
    const gl::PassTimers::Scope timed(r.timers, "lines");
    r.scene_passes.lines.render(r.setup->frame->lines, r.context());
}

void Renderer::end() {
    Impl& r = *impl_;
    r.stats.passes = r.timers.timings();
    r.stats.new_programs = r.scene.shaders.new_count();
    r.drew_a_frame = r.drew_a_frame || r.setup.has_value();
    r.setup.reset();
    if (r.gl.reset_status != nullptr && r.gl.reset_status() != GL_NO_ERROR) r.gl.is_lost = true;
    // Nobody presents an off-screen image: without this, frames would pile up in the driver,
    // with their memory, and the time of a frame would be that of asking for it.
    if (r.gl.device.is_offscreen) glFinish();
}

void Renderer::forget_scene() {
    Impl& r = *impl_;
    r.scene.meshes.clear();
    r.scene.textures.clear();
    r.scene.materials.clear();
    r.scene.sky.want(nullptr, {});
    r.scene.light_grid = {};
    r.drew_a_frame = false;
    r.shadow_passes.sun.free();
    r.shadow_passes.flashlight.free();
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
    const auto [width_px, height_px] = r.targets.present_px();
    assets::ImageData image{.width = width_px,
                            .height = height_px,
                            .format = assets::PixelFormat::Rgb8,
                            .bytes = std::move(spare.bytes)};
    const std::size_t row = std::size_t{width_px} * 3;
    image.bytes.resize(row * height_px);
    if (image.bytes.empty()) return image;
    r.targets.bind_present();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0,
                 0,
                 static_cast<GLsizei>(width_px),
                 static_cast<GLsizei>(height_px),
                 GL_RGB,
                 GL_UNSIGNED_BYTE,
                 image.bytes.data());
    // OpenGL's rows run from the bottom.
    for (std::size_t y = 0; y < height_px / 2; ++y) {
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
    return {{"sun_shadow", r.shadow_passes.sun.bytes()},
            {"flashlight", r.shadow_passes.flashlight.bytes()},
            {"light_shadows", r.shadow_passes.lamps.bytes()},
            {"sky", r.scene.sky.bytes()},
            {"post", r.targets.post().bloom_bytes() + r.light_passes.exposure.bytes()},
            {"drops", r.scene_passes.drops.bytes()},
            {"refraction", r.scene_passes.refraction.bytes()},
            {"indirect_light", r.scene.light_grid.bytes()},
            {"ambient_occlusion", r.light_passes.occlusion.bytes()},
            {"sun_shafts", r.light_passes.shafts.bytes()},
            {"depth_of_field", r.light_passes.focus.bytes()},
            {"motion_blur", r.light_passes.motion_blur.bytes()},
            {"meshes", r.scene.meshes.bytes()},
            {"textures", r.scene.textures.bytes()},
            {"programs", r.scene.shaders.bytes()},
            {"targets", r.targets.bytes()}};
}

bool Renderer::device_lost() const {
    return impl_->gl.is_lost;
}

bool Renderer::draws_in_software() const {
    return impl_->gl.device.is_software_gl;
}

const GlInfo& Renderer::gl() const {
    return impl_->gl.info;
}

}  // namespace plumbline::render
