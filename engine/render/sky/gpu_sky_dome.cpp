#include "engine/render/sky/gpu_sky_dome.h"

#include "engine/core/random.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

// Enough that neither the glow round the sun nor the horizon shows the dome's edges.
constexpr std::uint32_t kDomeColumns = 96;
constexpr std::uint32_t kDomeRows = 40;
constexpr std::uint32_t kRowsBelow = 4;
constexpr std::size_t kStars = 900;

struct DomeVertex {
    Vec3f direction{0.0F};
    Vec3f sky{0.0F};
    Vec3f cloud_ambient{0.0F};
    Vec3f cloud_light{0.0F};
};

struct SkyPoint {
    Vec3f direction{0.0F};
    Vec3f radiance{0.0F};
    Vec3f toward_light{0.0F};  ///< of the moon, where its light comes from; 0: it shines itself
    float breadth_rad{0.0F};
};

/// Sines of the rows' heights, dense at the horizon: kRowsBelow of them under it.
float dome_sine(std::uint32_t row) {
    constexpr std::array<float, kRowsBelow> kBelow{-1.0F, -0.2F, -0.06F, -0.025F};
    if (row < kRowsBelow) return kBelow[row];
    const float v = static_cast<float>(row - kRowsBelow) / (kDomeRows - 1);
    return v * v;
}

/// From the light's own compass direction, dense there: -pi to pi.
float dome_turn(std::uint32_t column) {
    const float t = 2.0F * static_cast<float>(column) / kDomeColumns - 1.0F;
    return glm::pi<float>() * t * (0.35F + 0.65F * std::abs(t));
}

std::vector<std::uint32_t> dome_indices() {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row + 1 < kRowsBelow + kDomeRows; ++row) {
        for (std::uint32_t column = 0; column < kDomeColumns; ++column) {
            const std::uint32_t left = row * kDomeColumns + column;
            // The last column meets the first: no seam.
            const std::uint32_t right = row * kDomeColumns + (column + 1) % kDomeColumns;
            for (const std::uint32_t corner : {left,
                                               right,
                                               left + kDomeColumns,
                                               right,
                                               right + kDomeColumns,
                                               left + kDomeColumns}) {
                indices.push_back(corner);
            }
        }
    }
    return indices;
}

std::vector<DomeVertex> dome_vertices(const ComputedSky& sky) {
    const Vec3f& sun = sky.model().to_sun_world;
    const float sun_turn = std::atan2(sun.z, sun.x);
    std::vector<DomeVertex> vertices;
    for (std::uint32_t row = 0; row < kRowsBelow + kDomeRows; ++row) {
        const float sine = dome_sine(row);
        const float cosine = std::sqrt(std::max(1.0F - sine * sine, 0.0F));
        for (std::uint32_t column = 0; column < kDomeColumns; ++column) {
            const float turn = sun_turn + dome_turn(column);
            const Vec3f direction{cosine * std::cos(turn), sine, cosine * std::sin(turn)};
            const ComputedSky::CloudLight cloud = sky.cloud_light(direction);
            vertices.push_back({direction, sky.radiance(direction), cloud.ambient, cloud.light});
        }
    }
    return vertices;
}

/// The stars' directions at the pole's own frame do not change: only their turn does.
std::vector<SkyPoint> stars(const ComputedSky& sky, const Vec3f& radiance) {
    const Vec3f pole = sky.model().pole_world;
    const Vec3f side = normalize_or(glm::cross(pole, Vec3f{0.13F, 0.97F, 0.21F}), Vec3f{1, 0, 0});
    const Vec3f third = glm::cross(pole, side);
    // A fixed star is further on by as much as the sun is.
    const Vec3f& sun = sky.model().to_sun_world;
    const float turn = std::atan2(glm::dot(sun, third), glm::dot(sun, side));
    const Vec3f band = glm::normalize(Vec3f{0.5F, 0.45F, 0.74F});
    Random random(7);
    std::vector<SkyPoint> points;
    while (points.size() < kStars) {
        const float height = random.uniform(-1.0F, 1.0F);
        const float angle = random.uniform(0.0F, 2.0F * glm::pi<float>());
        const float kind = random.uniform();
        const float strength = random.uniform();
        const float tint = random.uniform(-1.0F, 1.0F);
        const float flat = std::sqrt(1.0F - height * height);
        const Vec3f own{flat * std::cos(angle), flat * std::sin(angle), height};
        // Every other faint star lies in the milky way.
        if (kind < 0.5F && std::abs(glm::dot(own, band)) > 0.25F * strength + 0.05F) continue;
        const float u = std::cos(turn) * own.x - std::sin(turn) * own.y;
        const float v = std::sin(turn) * own.x + std::cos(turn) * own.y;
        const Vec3f direction = side * u + third * v + pole * own.z;
        // Few are bright: as many more per magnitude as there truly are.
        const float magnitude = std::pow(std::max(strength, 0.002F), -0.75F) * 0.16F;
        const Vec3f color = tint > 0.0F ? Vec3f{1.0F, 1.0F - 0.18F * tint, 1.0F - 0.4F * tint}
                                        : Vec3f{1.0F + 0.3F * tint, 1.0F + 0.15F * tint, 1.0F};
        const float through = std::clamp((direction.y - 0.02F) * 4.0F, 0.0F, 1.0F);
        points.push_back({.direction = direction,
                          .radiance = radiance * color * std::min(magnitude, 2.5F) * through,
                          .breadth_rad = magnitude > 0.6F ? 0.0022F : 0.0014F});
    }
    return points;
}

std::vector<SkyPoint> sky_points(const ComputedSky& sky) {
    std::vector<SkyPoint> points;
    if (sky.stars() > 0.0F) points = stars(sky, Vec3f{0.16F} * sky.stars());
    if (sky.moon_disc() != Vec3f{0.0F}) {
        points.push_back({.direction = sky.to_moon(),
                          .radiance = sky.moon_disc(),
                          .toward_light = sky.model().to_sun_world,
                          .breadth_rad = 0.026F});
    }
    if (sky.sun_disc() != Vec3f{0.0F}) {
        points.push_back({.direction = sky.model().to_sun_world,
                          .radiance = sky.sun_disc(),
                          .breadth_rad = 0.0125F});
    }
    return points;
}

/// Attributes one after the other, of so many floats each.
gl::VertexArrayObject laid_out(const gl::Buffer& buffer,
                               std::size_t stride,
                               const std::array<int, 4>& parts) {
    gl::VertexArrayObject array = gl::new_vertex_array();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    std::size_t at = 0;
    for (GLuint i = 0; i < parts.size(); ++i) {
        gl::float_attribute(i, parts[i], stride, at);
        at += static_cast<std::size_t>(parts[i]) * sizeof(float);
    }
    return array;
}

}  // namespace

void GpuSkyDome::update(const ComputedSky& sky) {
    const std::vector<DomeVertex> vertices = dome_vertices(sky);
    const std::vector<SkyPoint> points = sky_points(sky);
    if (!dome_array_) {
        vertices_ = gl::Buffer{gl::BufferUse::Vertices, gl::BufferLife::PerFrame};
        points_ = gl::Buffer{gl::BufferUse::Vertices, gl::BufferLife::PerFrame};
        point_array_ = laid_out(points_, sizeof(SkyPoint), {3, 3, 3, 1});
        dome_array_ = laid_out(vertices_, sizeof(DomeVertex), {3, 3, 3, 3});
        const std::vector<std::uint32_t> indices = dome_indices();
        indices_ = gl::Buffer{gl::BufferUse::Indices, gl::BufferLife::Kept};
        indices_.upload(indices.data(), indices.size() * sizeof(indices[0]));
        index_count_ = indices.size();
        glBindVertexArray(dome_array_.name());
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    }
    glBindVertexArray(0);
    vertices_.upload(vertices.data(), vertices.size() * sizeof(vertices[0]));
    points_.upload(points.data(), points.size() * sizeof(points[0]));
    point_count_ = points.size();
}

void GpuSkyDome::draw_dome() const {
    glBindVertexArray(dome_array_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(index_count_), GL_UNSIGNED_INT, nullptr);
}

void GpuSkyDome::draw_points() const {
    if (point_count_ == 0) return;
    glEnable(GL_PROGRAM_POINT_SIZE);
    glBindVertexArray(point_array_.name());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(point_count_));
    glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace plumbline::render
