// Draws RenderFrames with OpenGL 3.3 core. Needs a current context from construction to destruction
// (platform/ makes one: a window's or an off-screen one) and is used from its thread only.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/result.h"
#include "engine/render/frame_stats.h"
#include "engine/render/render_frame.h"
#include "engine/render/resources/gpu_limits.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::render {

struct GlInfo {
    std::string vendor;
    std::string renderer;
    std::string version;
};

/// GPU memory by what called for it: "sun_shadow", "flashlight", "light_shadows", "sky", "post", "drops", "refraction", "ambient_occlusion", "indirect_light", "sun_shafts", "depth_of_field", "motion_blur", "meshes", "textures", "targets".
struct GpuBytes {
    std::string_view owner;
    std::uint64_t bytes{0};
};

/// Where the finished image goes: the window's own framebuffer, or one of the renderer's.
enum class PresentTarget : std::uint8_t { Window, Offscreen };

/// Entry points of the GL that the context was made with, e.g. eglGetProcAddress.
using GlLoader = void (*(*)(const char*))();

class Renderer {
public:
    /// Loads GL, checks the version (3.3 at least) and that all shader files are there, and
    /// compiles what every frame needs. The error names vendor, renderer, found and needed, or the
    /// file. `limits`: as if the driver had no more.
    static Result<std::unique_ptr<Renderer>> create(GlLoader loader,
                                                    PresentTarget target,
                                                    const std::filesystem::path& shader_folder,
                                                    assets::AssetLibrary& library,
                                                    const GpuLimits& limits = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Uploads and compiles all that this frame needs, so that the first frame does not stutter.
    /// `tell` hears again and again which share of it is done; it may draw and present.
    void prepare(const RenderFrame& frame, const std::function<void(float share)>& tell = {});

    // The passes of a frame, in this order. begin() culls, sorts near to far and batches; it
    // survives a size of 0 x 0 (every pass is then skipped).
    void begin(const RenderFrame& frame);
    void shadows();
    void opaque();
    void sky();
    void translucent();
    void post();  ///< bloom, tone map, sRGB into the target
    void lines();
    // UI may be drawn here: the present target is bound.
    void end();  ///< closes the statistics

    /// Drops every GPU resource made for meshes and textures of the old scene.
    void forget_scene();
    /// Drops all programs: what is drawn next is compiled anew.
    void forget_programs();
    /// Recompiles changed shader files; a broken one leaves the old program and tells why.
    Result<Done> reload_shaders();
    /// Why a shader that a frame asked for is not as its files say: file, line and the driver's text.
    /// Empty when all are. What such a shader draws is missing, or as before the reload.
    const std::string& shader_fault() const;

    /// The image as shown, rows from the top, Rgb8; from the present target. In the memory of `spare`,
    /// where that has enough: new memory of this size costs as much as reading.
    assets::ImageData read_pixels(assets::ImageData spare = {}) const;

    const FrameStats& stats() const;
    std::vector<GpuBytes> gpu_bytes() const;
    const GlInfo& gl() const;
    /// The driver has told, at the end of a frame, that the device was reset: nothing is drawn any more.
    /// Never where the driver cannot tell.
    bool device_lost() const;
    /// By the driver's name: images are drawn on the CPU.
    bool draws_in_software() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// All passes of a frame, where nothing is drawn over it.
inline void draw(Renderer& renderer, const RenderFrame& frame) {
    renderer.begin(frame);
    renderer.shadows();
    renderer.opaque();
    renderer.sky();
    renderer.translucent();
    renderer.post();
    renderer.lines();
    renderer.end();
}

}  // namespace plumbline::render
