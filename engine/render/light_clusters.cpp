#include "engine/render/light_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumbline::render {
namespace {

constexpr int kTilesX = PL_CLUSTERS_X;
constexpr int kTilesY = PL_CLUSTERS_Y;
constexpr int kSlices = PL_CLUSTERS_Z;
constexpr std::size_t kClusters = std::size_t{kTilesX} * kTilesY * kSlices;
constexpr std::uint32_t kLengthBits = 9;

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

using Lists = std::vector<std::vector<std::uint32_t>>;

void add_light(const ClusterView& view,
               const LocalLight& light,
               std::uint32_t index,
               Lists& lists) {
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
                lists[static_cast<std::size_t>(cluster)].push_back(index);
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
    Lists lists(kClusters);
    for (std::uint32_t i = 0; i < lights.size(); ++i) add_light(view, lights[i], i, lists);
    std::vector<std::uint32_t> words(kClusters);
    // The list of all, in case it is needed, comes first.
    for (std::uint32_t i = 0; i < lights.size(); ++i) words.push_back(i);
    for (std::size_t cluster = 0; cluster < kClusters; ++cluster) {
        const std::vector<std::uint32_t>& list = lists[cluster];
        const bool fits = words.size() + list.size() <= PL_LIGHT_WORDS;
        const auto start = static_cast<std::uint32_t>(fits ? words.size() : kClusters);
        const auto length = static_cast<std::uint32_t>(fits ? list.size() : lights.size());
        words[cluster] = start << kLengthBits | length;
        if (fits) words.insert(words.end(), list.begin(), list.end());
    }
    return words;
}

}  // namespace plumbline::render
