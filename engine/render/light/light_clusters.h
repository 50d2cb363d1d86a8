// Which local lights reach which part of the image. Pure arithmetic: tested without GL.
//
// The view is cut into clusters: tiles of the screen times slices of depth. Each has a bit for every
// light, set where that light may reach into it, so a surface is lit by any number of lights and pays
// for those near it only. Clusters: Olsson, Billeter, Assarsson, "Clustered Deferred and Forward
// Shading", 2012; bits in place of lists, which never run out of room: Drobot, "Improved Culling for
// Tiled and Clustered Rendering", 2017.
#pragma once

#include "engine/core/math.h"
#include "engine/render/render_frame.h"
#include "shaders/shared/limits.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::render {

struct ClusterView {
    Mat4f view_from_world{1.0F};
    float tan_x{1.0F};  ///< of half the field of view
    float tan_y{1.0F};
};

/// Words for the shader: for each cluster (x fastest, then y, then the slice) one word for every 32
/// of the first PL_MAX_LIGHTS lights; bit i of word w stands for light 32 w + i.
std::vector<std::uint32_t> light_clusters(const ClusterView& view,
                                          std::span<const LocalLight> lights);

/// The slice of a depth in metres; the first begins at the eye, the last has no end.
int cluster_slice(float depth_m);

}  // namespace plumbline::render
