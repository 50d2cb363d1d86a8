// A tree of axis-aligned boxes, built once: which of many things lie where.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

struct Bounds {
    Vec3d low{0, 0, 0};
    Vec3d high{0, 0, 0};
};

/// Boxes are kept as floats, rounded outward.
class BoxTree {
public:
    BoxTree() = default;
    /// Splits by surface area over bins (Wald 2007, "On fast Construction of SAH-based Bounding Volume
    /// Hierarchies"). The same boxes give the same tree on every platform.
    explicit BoxTree(std::span<const Bounds> boxes);

    /// Calls `on_item(index)` for each box that overlaps or touches `bounds`, always in the same order.
    template <class OnItem>
    void visit(const Bounds& bounds, const OnItem& on_item) const {
        const Vec3f low = rounded_down(bounds.low);
        const Vec3f high = rounded_up(bounds.high);
        const auto count = static_cast<std::uint32_t>(nodes_.size());
        for (std::uint32_t i = 0; i < count;) {
            const Node& node = nodes_[i];
            const bool overlaps = node.low.x <= high.x && node.high.x >= low.x &&
                                  node.low.y <= high.y && node.high.y >= low.y &&
                                  node.low.z <= high.z && node.high.z >= low.z;
            if (overlaps && node.item != kInner) on_item(node.item);
            i = overlaps ? i + 1 : node.after;
        }
    }

    bool is_empty() const { return nodes_.empty(); }

private:
    static constexpr std::uint32_t kInner = 0xffffffffU;

    /// In depth-first order: the first child follows its parent.
    struct Node {
        Vec3f low;
        Vec3f high;
        std::uint32_t after;  ///< the first node that is not below this one
        std::uint32_t item;   ///< kInner: has children
    };

    static Vec3f rounded_down(const Vec3d& v);
    static Vec3f rounded_up(const Vec3d& v);
    void fit_inner_nodes();

    std::vector<Node> nodes_;
};

}  // namespace plumbline::physics
