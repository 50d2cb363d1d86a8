#include "engine/render/loading_bar.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

struct Box {
    GLint left;
    GLint bottom;
    GLint width;
    GLint height;
};

void fill(const Box& box, const Vec3f& code) {
    glScissor(box.left, box.bottom, box.width, box.height);
    glClearColor(code.x, code.y, code.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void draw_loading_bar(GlLoader loader, const LoadingBar& bar) {
    if (bar.width_px == 0 || bar.height_px == 0) return;
    if (gladLoadGL(loader) == 0) return;  // the window may be another than the last one
    const auto width = static_cast<GLint>(bar.width_px);
    const auto height = static_cast<GLint>(bar.height_px);
    const GLint thick = std::max(height / 90, 3);
    const GLint edge = std::max(thick / 4, 1);
    const GLint most = std::max(width / 3, 1);
    const auto along = [&](float share) {
        return static_cast<GLint>(static_cast<float>(most) * std::clamp(share, 0.0F, 1.0F));
    };
    const GLint from = along(bar.from);
    const GLint filled = along(bar.share) - from;
    const GLint left = (width - most) / 2;
    const GLint bottom = height / 8;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_SCISSOR_TEST);
    if (bar.background == LoadingBackground::Dark)
        fill({0, 0, width, height}, {0.09F, 0.11F, 0.13F});
    fill({left - edge, bottom - edge, most + 2 * edge, thick + 2 * edge}, {0.55F, 0.6F, 0.62F});
    fill({left, bottom, most, thick}, {0.16F, 0.19F, 0.21F});
    if (filled > 0) fill({left + from, bottom, filled, thick}, {0.91F, 0.76F, 0.42F});
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace plumbline::render
