#include "engine/render/light/light_clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::render {
namespace {

constexpr int kTilesX = PL_CLUSTERS_X;
constexpr int kTilesY = PL_CLUSTERS_Y;
constexpr int kSlices = PL_CLUSTERS_Z;
constexpr std::size_t kClusters = std::size_t{kTilesX} * kTilesY * kSlices;
constexpr std::size_t kWordBits = 32;
// The smallest texture buffer that OpenGL 3.3 guarantees.
static_assert(kClusters * PL_MAX_LIGHTS / kWordBits <= 65536);

struct Range {
    int first{0};
    int last{-1};
};

float slice_start_m(int slice) {
    return slice == 0 ? 0.0F
                      : PL_CLUSTER_NEAR_M *
                            std::exp2(static_cast<float>(slice - 1) / PL_CLUSTERS_PER_OCTAVE);
}

/// Tiles that a chord from `low` to `high`, seen from between two depths, may cover.
Range tiles_of(float low, float high, float near_m, float far_m, float tangent, int tiles) {
    // The side that lies outwards is widest at the near end, inwards at the far end.
    const float left = low / (low < 0.0F ? near_m : far_m);
    const float right = high / (high > 0.0F ? near_m : far_m);
    const auto tile = [&](float slope) {
        const float share = std::clamp(slope / tangent * 0.5F + 0.5F, -1.0F, 2.0F);
        return static_cast<int>(std::floor(share * static_cast<float>(tiles)));
    };
    return {std::max(tile(left), 0), std::min(tile(right), tiles - 1)};
}

/// One light's bit in the masks of all clusters.
struct Bit {
    std::size_t word{0};  ///< of a cluster's
    std::uint32_t mask{1};
    std::size_t words{1};  ///< a cluster has
};

void add_light(const ClusterView& view,
               const LocalLight& light,
               const Bit& bit,
               std::vector<std::uint32_t>& masks) {
    const Vec3f center{view.view_from_world * Vec4f{light.position_world, 1.0F}};
    const float depth_m = -center.z;
    if (depth_m + light.radius_m <= 0.0F) return;
    // A little more, so that the shader's rounding never falls into a cluster without it.
    const float radius_m = light.radius_m * 1.01F + 0.01F;
    const int first = cluster_slice(depth_m - radius_m);
    const int last = cluster_slice(depth_m + radius_m);
    for (int slice = first; slice <= last; ++slice) {
        const float near_m = std::max(slice_start_m(slice), depth_m - radius_m);
        const float end_m =
            slice + 1 < kSlices ? slice_start_m(slice + 1) : std::numeric_limits<float>::max();
        const float far_m = std::min(end_m, depth_m + radius_m);
        // How wide the ball is within the slice.
        const float off_m = depth_m - std::clamp(depth_m, near_m, far_m);
        const float reach2 = radius_m * radius_m - off_m * off_m;
        const float reach_m = std::sqrt(std::max(reach2, 0.0F));
        const float nearest_m = std::max(near_m, 1e-3F);
        const float farthest_m = std::max(far_m, nearest_m);
        const Range x = tiles_of(
            center.x - reach_m, center.x + reach_m, nearest_m, farthest_m, view.tan_x, kTilesX);
        const Range y = tiles_of(
            center.y - reach_m, center.y + reach_m, nearest_m, farthest_m, view.tan_y, kTilesY);
        for (int ty = y.first; ty <= y.last; ++ty) {
            for (int tx = x.first; tx <= x.last; ++tx) {
                const int cluster = (slice * kTilesY + ty) * kTilesX + tx;
                masks[static_cast<std::size_t>(cluster) * bit.words + bit.word] |= bit.mask;
            }
        }
    }
}

}  // namespace

int cluster_slice(float depth_m) {
    if (depth_m < PL_CLUSTER_NEAR_M) return 0;
    const float octaves = std::log2(depth_m / PL_CLUSTER_NEAR_M);
    return std::min(1 + static_cast<int>(octaves * PL_CLUSTERS_PER_OCTAVE), kSlices - 1);
}

std::vector<std::uint32_t> light_clusters(const ClusterView& view,
                                          std::span<const LocalLight> lights) {
    lights = lights.first(std::min<std::size_t>(lights.size(), PL_MAX_LIGHTS));
    const std::size_t words = (lights.size() + kWordBits - 1) / kWordBits;
    std::vector<std::uint32_t> masks(kClusters * words);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Bit bit{
            .word = i / kWordBits, .mask = std::uint32_t{1} << (i % kWordBits), .words = words};
        add_light(view, lights[i], bit, masks);
    }
    return masks;
}

}  // namespace plumbline::render
