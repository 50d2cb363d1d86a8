#include "engine/render/passes/screen/pair_blur.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {

void blur_pairs(const PassImage& found,
                const PassImage& spare,
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
    along(found, spare, 1, 0);
    along(spare, found, 0, 1);
}

}  // namespace plumbline::render
