// Which joint holds which bodies, and what follows from it for a direct solve. Made once and kept
// as long as it comes again.
#pragma once

#include "engine/physics/dynamics/joint/block/block_pattern.h"
#include "engine/physics/dynamics/joint/joint_system.h"

#include <memory>
#include <unordered_map>

namespace plumbline::physics {

/// Three rows of a joint that are solved as one block. Rows a joint does not have are held at zero.
enum class NodeKind : std::uint8_t {
    None,
    Point,   ///< the anchors coincide: along the world's axes
    Across,  ///< slider: two rows across the axis; the third, along it, may be bounded
    Length,  ///< the anchors' distance, in the first row; may be bounded or a stiff spring
    Align,   ///< hinge: two rows turn a's axis onto b's; the third, about it, may be bounded
    Lock,    ///< no turning: about the world's axes
    Swing,   ///< cone: the angle between the axes, and in the third row the twist; bounded
};

/// What a joint puts into the system: at most one block for places and one for turns.
struct JointForm {
    NodeKind places{NodeKind::None};
    NodeKind turns{NodeKind::None};
};
/// `stiff_spring`: the joint is a spring that must be solved with the joints.
JointForm form_of(const SolverJoint& joint, bool stiff_spring);

/// A block of rows, in the order of elimination.
struct JointNode {
    std::uint32_t joint{0};
    std::uint32_t a{0};  ///< in JointTopology::bodies
    std::uint32_t b{0};
    NodeKind kind{NodeKind::None};
};

/// Rows and columns of A that a movable body ties together.
struct JointTerm {
    std::uint32_t row{0};     ///< node
    std::uint32_t column{0};  ///< an earlier node
    std::uint32_t block{0};   ///< of the pattern
    bool row_is_b{false};     ///< whether the body is the row's b or its a
    bool column_is_b{false};
};

/// Connected joints: nothing they do reaches another component.
struct JointComponent {
    std::uint32_t first_node{0};
    std::uint32_t last_node{0};  ///< one past
    std::uint32_t first_term{0};
    std::uint32_t last_term{0};
};

struct JointTopology {
    /// What it was made from.
    struct Key {
        std::uint64_t key{0};
        std::uint32_t a{0};
        std::uint32_t b{0};
        JointForm form{};
        bool a_movable{false};
        bool b_movable{false};
        bool operator==(const Key& other) const;
    };
    std::vector<Key> keys;

    std::vector<std::uint32_t> bodies;  ///< those of the joints, by their index in the island
    std::vector<std::array<std::uint32_t, 2>> sides;  ///< by joint: a and b in `bodies`
    std::vector<JointNode> nodes;
    std::vector<JointComponent> components;
    std::vector<JointTerm> terms;
    BlockPattern pattern;
    bool too_dear{false};  ///< for a direct solve: nodes in the joints' order, no pattern or terms
};

/// Topologies met before, by what they were made from.
class TopologyCache {
public:
    /// Valid until the next call. `forms` belong to the joints.
    const JointTopology& of(std::span<const SolverBody> bodies,
                            std::span<const SolverJoint> joints,
                            std::span<const JointForm> forms);

private:
    std::unordered_map<std::uint64_t, std::unique_ptr<JointTopology>> known_;
    std::size_t known_joints_{0};
    std::vector<JointTopology::Key> wanted_;
};

}  // namespace plumbline::physics
