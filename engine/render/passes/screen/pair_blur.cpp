#include "engine/render/passes/screen/pair_blur.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

bool PairImages::resize(PixelSize size_px) {
    const bool made = found.resize(gl::TargetFormat::Pair16F, size_px) &&
                      spare.resize(gl::TargetFormat::Pair16F, size_px);
    if (!made) *this = {};
    return made;
}

void blur_pairs(const PairImages& images,
                const FullscreenTriangle& triangle,
                SceneResources& resources,
                FrameStats& stats) {
    const gl::Program* blur = resources.shaders.find(kPairBlurShader, 0);
    if (blur == nullptr) return;
    blur->use();
    const auto along = [&](const PassImage& from, const PassImage& to, GLint x, GLint y) {
        to.bind();
        gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, from.image);
        glUniform2i(blur->location("axis"), x, y);
        triangle.draw();
        ++stats.draw_calls;
    };
    along(images.found, images.spare, 1, 0);
    along(images.spare, images.found, 0, 1);
}

}  // namespace plumbline::render
