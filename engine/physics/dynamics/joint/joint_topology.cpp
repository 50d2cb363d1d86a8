#include "engine/physics/dynamics/joint/joint_topology.h"

#include "engine/core/assert.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

/// Beyond it a factorisation takes longer than sweeps that do as well. A block multiply-add is
/// 27 multiplications: some 10 ns.
constexpr double kMostMultiplyAdds = 2e5;
/// Topologies kept hold at most as many joints together.
constexpr std::size_t kMostKnownJoints = 1U << 16U;
constexpr std::uint32_t kNone = ~0U;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29U);
}

std::uint64_t hash_of(std::span<const JointTopology::Key> keys) {
    std::uint64_t hash = keys.size();
    for (const JointTopology::Key& key : keys) {
        hash = mixed(hash, key.key);
        hash = mixed(hash, (std::uint64_t{key.a} << 32U) | key.b);
        hash = mixed(hash,
                     static_cast<std::uint64_t>(key.form.places) * 64 +
                         static_cast<std::uint64_t>(key.form.turns) * 4 +
                         (key.a_movable ? 2U : 0U) + (key.b_movable ? 1U : 0U));
    }
    return hash;
}

/// Whether the joint can do anything.
bool acts(const JointTopology::Key& key) {
    return key.a != key.b && (key.a_movable || key.b_movable) &&
           (key.form.places != NodeKind::None || key.form.turns != NodeKind::None);
}

std::uint32_t blocks_of(const JointTopology::Key& key) {
    return (key.form.places != NodeKind::None ? 1U : 0U) +
           (key.form.turns != NodeKind::None ? 1U : 0U);
}

/// By movable body of the island, the places of its joints among the `acting` ones.
std::vector<std::vector<std::uint32_t>> vertices_by_body(std::span<const JointTopology::Key> keys,
                                                         std::span<const std::uint32_t> acting) {
    std::uint32_t count = 0;
    for (const JointTopology::Key& key : keys) count = std::max({count, key.a + 1, key.b + 1});
    std::vector<std::vector<std::uint32_t>> vertices(count);
    for (std::uint32_t v = 0; v < acting.size(); ++v) {
        const JointTopology::Key& key = keys[acting[v]];
        if (key.a_movable) vertices[key.a].push_back(v);
        if (key.b_movable) vertices[key.b].push_back(v);
    }
    return vertices;
}

class TopologyMaker {
public:
    explicit TopologyMaker(std::vector<JointTopology::Key> keys) { made_.keys = std::move(keys); }

    JointTopology make() {
        for (std::uint32_t i = 0; i < made_.keys.size(); ++i) {
            if (acts(made_.keys[i])) acting_.push_back(i);
        }
        on_body_ = vertices_by_body(made_.keys, acting_);
        local_.assign(on_body_.size(), kNone);
        const EliminationOrder order = order_joints();
        made_.too_dear = order.too_dear;
        number_nodes(order);
        if (!made_.too_dear) {
            made_.pattern = BlockPattern::from_columns(columns_of(order));
            list_terms(order);
        }
        for (const JointTopology::Key& any : made_.keys) {
            made_.sides.push_back({local_body(any.a), local_body(any.b)});
        }
        return std::move(made_);
    }

private:
    const JointTopology::Key& key(std::uint32_t vertex) const {
        return made_.keys[acting_[vertex]];
    }

    EliminationOrder order_joints() const {
        EliminationOrder refused;
        refused.too_dear = true;
        double pairs = 0;
        for (const auto& list : on_body_) {
            const auto count = static_cast<double>(list.size());
            pairs += count * count;
        }
        if (pairs > kMostMultiplyAdds) return refused;
        std::vector<std::vector<std::uint32_t>> neighbours(acting_.size());
        std::vector<std::uint32_t> weights;
        for (std::uint32_t v = 0; v < acting_.size(); ++v) {
            weights.push_back(blocks_of(key(v)));
            for (const std::uint32_t body : {key(v).a, key(v).b}) {
                for (const std::uint32_t other : on_body_[body]) {
                    if (other != v) neighbours[v].push_back(other);
                }
            }
            std::ranges::sort(neighbours[v]);
            // clang 14 does not take the library's std::ranges::unique.
            neighbours[v].erase(std::unique(neighbours[v].begin(), neighbours[v].end()),
                                neighbours[v].end());
        }
        return minimum_degree_order(std::move(neighbours), weights, kMostMultiplyAdds);
    }

    std::uint32_t local_body(std::uint32_t body) {
        if (local_[body] == kNone) {
            local_[body] = static_cast<std::uint32_t>(made_.bodies.size());
            made_.bodies.push_back(body);
        }
        return local_[body];
    }

    void add_nodes(std::uint32_t vertex) {
        const JointTopology::Key& from = key(vertex);
        first_node_[vertex] = static_cast<std::uint32_t>(made_.nodes.size());
        const std::uint32_t a = local_body(from.a);
        const std::uint32_t b = local_body(from.b);
        for (const NodeKind kind : {from.form.places, from.form.turns}) {
            if (kind == NodeKind::None) continue;
            made_.nodes.push_back({.joint = acting_[vertex], .a = a, .b = b, .kind = kind});
        }
    }

    void number_nodes(const EliminationOrder& order) {
        first_node_.resize(acting_.size());
        if (made_.too_dear) {
            for (std::uint32_t v = 0; v < acting_.size(); ++v) add_nodes(v);
            const auto count = static_cast<std::uint32_t>(made_.nodes.size());
            made_.components.push_back({.first_node = 0, .last_node = count});
            return;
        }
        for (std::size_t c = 0; c + 1 < order.component_begin.size(); ++c) {
            const auto first = static_cast<std::uint32_t>(made_.nodes.size());
            for (std::uint32_t i = order.component_begin[c]; i < order.component_begin[c + 1];
                 ++i) {
                add_nodes(order.order[i]);
            }
            const auto last = static_cast<std::uint32_t>(made_.nodes.size());
            made_.components.push_back({.first_node = first, .last_node = last});
        }
    }

    std::vector<std::vector<std::uint32_t>> columns_of(const EliminationOrder& order) const {
        std::vector<std::vector<std::uint32_t>> columns(made_.nodes.size());
        for (std::uint32_t v = 0; v < acting_.size(); ++v) {
            const std::uint32_t first = first_node_[v];
            const std::uint32_t last = first + blocks_of(key(v));
            for (std::uint32_t node = first; node < last; ++node) {
                for (std::uint32_t next = node + 1; next < last; ++next) {
                    columns[node].push_back(next);
                }
                for (const std::uint32_t other : order.later[v]) {
                    for (std::uint32_t i = 0; i < blocks_of(key(other)); ++i) {
                        columns[node].push_back(first_node_[other] + i);
                    }
                }
                std::ranges::sort(columns[node]);
            }
        }
        return columns;
    }

    void list_terms(const EliminationOrder& order) {
        std::vector<std::vector<std::pair<std::uint32_t, bool>>> before(made_.bodies.size());
        auto component = made_.components.begin();
        for (std::uint32_t row = 0; row < made_.nodes.size(); ++row) {
            if (row == component->last_node) {
                component->last_term = static_cast<std::uint32_t>(made_.terms.size());
                (++component)->first_term = static_cast<std::uint32_t>(made_.terms.size());
            }
            const JointNode& node = made_.nodes[row];
            const JointTopology::Key& from = made_.keys[node.joint];
            for (const bool is_b : {false, true}) {
                if (!(is_b ? from.b_movable : from.a_movable)) continue;
                auto& list = before[is_b ? node.b : node.a];
                for (const auto& [column, column_is_b] : list) {
                    made_.terms.push_back({.row = row,
                                           .column = column,
                                           .block = made_.pattern.block_at(row, column),
                                           .row_is_b = is_b,
                                           .column_is_b = column_is_b});
                }
                list.emplace_back(row, is_b);
            }
        }
        if (!order.order.empty()) {
            component->last_term = static_cast<std::uint32_t>(made_.terms.size());
        }
    }

    JointTopology made_;
    std::vector<std::uint32_t> acting_;                // joints, by vertex
    std::vector<std::vector<std::uint32_t>> on_body_;  // vertices, by movable body of the island
    std::vector<std::uint32_t> local_;                 // by body of the island
    std::vector<std::uint32_t> first_node_;            // by vertex
};

}  // namespace

bool JointTopology::Key::operator==(const Key& other) const {
    return key == other.key && a == other.a && b == other.b && form.places == other.form.places &&
           form.turns == other.form.turns && a_movable == other.a_movable &&
           b_movable == other.b_movable;
}

JointForm form_of(const SolverJoint& joint, bool stiff_spring) {
    switch (joint.kind) {
        case JointKind::BallAndSocket:
            return {NodeKind::Point, NodeKind::None};
        case JointKind::Hinge:
            return {NodeKind::Point, NodeKind::Align};
        case JointKind::Slider:
            return {NodeKind::Across, NodeKind::Lock};
        case JointKind::Fixed:
            return {NodeKind::Point, NodeKind::Lock};
        case JointKind::Cone:
            return {NodeKind::Point,
                    joint.limits || joint.twist_limits ? NodeKind::Swing : NodeKind::None};
        case JointKind::Distance:
            return {NodeKind::Length, NodeKind::None};
        case JointKind::Spring:
            return {stiff_spring ? NodeKind::Length : NodeKind::None, NodeKind::None};
        case JointKind::Elastic:
            return {NodeKind::Point, joint.bend_Nmprad > 0 ? NodeKind::Lock : NodeKind::None};
    }
    return {};
}

const JointTopology& TopologyCache::of(std::span<const SolverBody> bodies,
                                       std::span<const SolverJoint> joints,
                                       std::span<const JointForm> forms) {
    wanted_.clear();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const SolverJoint& joint = joints[i];
        PL_ASSERT(joint.a < bodies.size() && joint.b < bodies.size(), "bodies of the island");
        wanted_.push_back({.key = joint.key,
                           .a = joint.a,
                           .b = joint.b,
                           .form = forms[i],
                           .a_movable = bodies[joint.a].movable(),
                           .b_movable = bodies[joint.b].movable()});
    }
    const std::uint64_t hash = hash_of(wanted_);
    const auto found = known_.find(hash);
    if (found != known_.end() && found->second->keys == wanted_) return *found->second;

    if (known_joints_ + joints.size() > kMostKnownJoints) {
        known_.clear();
        known_joints_ = 0;
    }
    known_joints_ += joints.size();
    auto& slot = known_[hash];
    slot = std::make_unique<JointTopology>(TopologyMaker(wanted_).make());
    return *slot;
}

}  // namespace plumbline::physics
