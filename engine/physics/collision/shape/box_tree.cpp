#include "engine/physics/collision/shape/box_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr std::size_t kBins = 12;
/// Ranges this deep in the tree are halved, so that no order of boxes makes a long chain.
constexpr int kDeep = 48;
/// Smaller ranges are halved: bins say little there.
constexpr std::uint32_t kFew = 5;

struct Item {
    Vec3f low;
    Vec3f high;
    std::uint32_t index;

    Vec3f twice_center() const { return low + high; }
};

struct Range {
    std::uint32_t first;
    std::uint32_t last;
    int depth;
};

struct TreeBox {
    Vec3f low{std::numeric_limits<float>::max()};
    Vec3f high{std::numeric_limits<float>::lowest()};

    void add(const Vec3f& other_low, const Vec3f& other_high) {
        low = glm::min(low, other_low);
        high = glm::max(high, other_high);
    }
    float half_area() const {
        const Vec3f size = high - low;
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

struct Bin {
    TreeBox box;
    std::uint32_t count{0};
};

float down(double value) {
    const auto near = static_cast<float>(value);
    return static_cast<double>(near) > value
               ? std::nextafter(near, std::numeric_limits<float>::lowest())
               : near;
}

class Splitter {
public:
    explicit Splitter(std::vector<Item>& items) : items_(items) {}

    /// Sorts the range's items into two parts, and returns where the second begins.
    std::uint32_t split(const Range& range) {
        TreeBox centers;
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            const Vec3f center = items_[i].twice_center();
            centers.add(center, center);
        }
        const Vec3f size = centers.high - centers.low;
        axis_ = 0;
        if (size.y > size[axis_]) axis_ = 1;
        if (size.z > size[axis_]) axis_ = 2;
        from_ = centers.low[axis_];
        bins_per_m_ = static_cast<float>(kBins) / size[axis_];
        if (range.last - range.first < kFew || range.depth >= kDeep || !std::isfinite(bins_per_m_))
            return halve(range);
        const std::size_t cut = cheapest_cut(range);
        const auto middle = std::partition(items_.begin() + range.first,
                                           items_.begin() + range.last,
                                           [&](const Item& item) { return bin_of(item) < cut; });
        const auto at = static_cast<std::uint32_t>(middle - items_.begin());
        return at == range.first || at == range.last ? halve(range) : at;
    }

private:
    std::size_t bin_of(const Item& item) const {
        const float along = (item.twice_center()[axis_] - from_) * bins_per_m_;
        return std::min(static_cast<std::size_t>(std::max(along, 0.0F)), kBins - 1);
    }

    std::uint32_t halve(const Range& range) {
        const std::uint32_t middle = range.first + (range.last - range.first) / 2;
        const auto begin = items_.begin();
        // A total order, so that every library makes the same halves.
        std::nth_element(begin + range.first,
                         begin + middle,
                         begin + range.last,
                         [this](const Item& a, const Item& b) {
                             const float at_a = a.twice_center()[axis_];
                             const float at_b = b.twice_center()[axis_];
                             return at_a != at_b ? at_a < at_b : a.index < b.index;
                         });
        return middle;
    }

    /// The first bin of the second part.
    std::size_t cheapest_cut(const Range& range) const {
        std::array<Bin, kBins> bins;
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            Bin& bin = bins[bin_of(items_[i])];
            bin.box.add(items_[i].low, items_[i].high);
            ++bin.count;
        }
        std::array<float, kBins> cost{};
        Bin below;
        for (std::size_t i = 1; i < kBins; ++i) {
            below.box.add(bins[i - 1].box.low, bins[i - 1].box.high);
            below.count += bins[i - 1].count;
            cost[i] =
                static_cast<float>(below.count) * (below.count > 0 ? below.box.half_area() : 0.0F);
        }
        Bin above;
        std::size_t best = 1;
        float least = std::numeric_limits<float>::max();
        for (std::size_t i = kBins - 1; i > 0; --i) {
            above.box.add(bins[i].box.low, bins[i].box.high);
            above.count += bins[i].count;
            const float of_above = above.count > 0 ? above.box.half_area() : 0.0F;
            cost[i] += static_cast<float>(above.count) * of_above;
            if (cost[i] >= least) continue;
            least = cost[i];
            best = i;
        }
        return best;
    }

    std::vector<Item>& items_;
    int axis_{0};
    float from_{0};
    float bins_per_m_{0};
};

}  // namespace

Vec3f BoxTree::rounded_down(const Vec3d& v) {
    return {down(v.x), down(v.y), down(v.z)};
}

Vec3f BoxTree::rounded_up(const Vec3d& v) {
    return -rounded_down(-v);
}

BoxTree::BoxTree(std::span<const Bounds> boxes) {
    std::vector<Item> items(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        items[i] = {
            rounded_down(boxes[i].low), rounded_up(boxes[i].high), static_cast<std::uint32_t>(i)};
    }
    if (items.empty()) return;
    nodes_.reserve(2 * items.size() - 1);
    Splitter splitter(items);
    std::vector<Range> open{{0, static_cast<std::uint32_t>(items.size()), 0}};
    while (!open.empty()) {
        const Range range = open.back();
        open.pop_back();
        const std::uint32_t count = range.last - range.first;
        const auto here = static_cast<std::uint32_t>(nodes_.size());
        const Item& first = items[range.first];
        nodes_.push_back({.low = first.low,
                          .high = first.high,
                          .after = here + 2 * count - 1,
                          .item = count == 1 ? first.index : kInner});
        if (count == 1) continue;
        const std::uint32_t middle = splitter.split(range);
        open.push_back({middle, range.last, range.depth + 1});
        open.push_back({range.first, middle, range.depth + 1});
    }
    fit_inner_nodes();
}

void BoxTree::fit_inner_nodes() {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.item != kInner) continue;
        const Node& first = nodes_[i + 1];
        const Node& second = nodes_[first.after];
        node.low = glm::min(first.low, second.low);
        node.high = glm::max(first.high, second.high);
    }
}

}  // namespace plumbline::physics
