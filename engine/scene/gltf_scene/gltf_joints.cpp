// Joints of glTF files, which are sums of limits, as the joints that we have.
#include "engine/scene/gltf_scene/gltf_scene_impl.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::scene {
namespace {

constexpr double kClosed = 1e-6;  // m or rad: what is less is none
constexpr double kApart_m = 1e-3;
constexpr double kEndless_m = std::numeric_limits<double>::infinity();  // or rad
constexpr double kAnyForce = 1e9;                                       // N or N m
constexpr double kStraight_rad = 3.14159265358979323846;

/// What a joint leaves of one axis.
struct AxisRange {
    double min{-kEndless_m};
    double max{kEndless_m};
    bool is_locked() const { return max - min < kClosed; }
    /// Where it is locked.
    double place() const { return is_locked() ? (min + max) / 2 : 0; }
    bool is_free() const { return min == -kEndless_m && max == kEndless_m; }
};

/// All limits of a joint, by axis; of two and three axes together where they leave a distance or a cone.
struct Freedom {
    std::array<AxisRange, 3> shift{};
    std::array<AxisRange, 3> turn{};
    const assets::ModelJointLimit* distance{nullptr};  ///< of all three axes
    std::optional<std::size_t> cone_about{};
    double cone_rad{0};
    bool is_strange{false};  ///< a distance from a line: none of our joints keeps it
    bool is_soft{false};     ///< some limit but `distance` is
};

std::size_t count_of(const std::array<bool, 3>& axes) {
    return static_cast<std::size_t>(std::ranges::count(axes, true));
}

AxisRange range_of(const assets::ModelJointLimit& limit) {
    return {.min = limit.min.value_or(-kEndless_m), .max = limit.max.value_or(kEndless_m)};
}

void add_limit(const assets::ModelJointLimit& limit, Freedom& freedom) {
    const std::size_t count = count_of(limit.axes);
    // Together they bound a magnitude, which has no sign.
    const bool locks = limit.max && *limit.max < kClosed && (!limit.min || *limit.min > -kClosed);
    const bool soft = limit.stiffness.has_value();
    if (!limit.is_angular && count == 3 && (!locks || soft)) {
        freedom.distance = &limit;
        return;
    }
    freedom.is_soft |= soft;
    if (count > 1 && !locks) {
        if (!limit.is_angular || count == 3) {
            freedom.is_strange = true;
            return;
        }
        const auto spared = std::ranges::find(limit.axes, false) - limit.axes.begin();
        freedom.cone_about = static_cast<std::size_t>(spared);
        freedom.cone_rad = limit.max.value_or(kStraight_rad);
        return;
    }
    std::array<AxisRange, 3>& ranges = limit.is_angular ? freedom.turn : freedom.shift;
    for (std::size_t i = 0; i < 3; ++i) {
        if (limit.axes[i]) ranges[i] = count > 1 ? AxisRange{0, 0} : range_of(limit);
    }
}

std::size_t locked(const std::array<AxisRange, 3>& ranges) {
    return static_cast<std::size_t>(std::ranges::count_if(ranges, &AxisRange::is_locked));
}
std::size_t free_axes(const std::array<AxisRange, 3>& ranges) {
    return static_cast<std::size_t>(std::ranges::count_if(ranges, &AxisRange::is_free));
}
std::size_t open_axis(const std::array<AxisRange, 3>& ranges) {
    const auto open = std::ranges::find_if_not(ranges, &AxisRange::is_locked);
    return open == ranges.end() ? 0 : static_cast<std::size_t>(open - ranges.begin());
}

struct JointMaker {
    GltfScene& gltf;
    const assets::ModelJoint& source;
    // `a` is what hangs on the connected node, whose place is told in the joint's frame.
    const assets::NodePlace& frame = gltf.places[source.node];
    const assets::NodePlace& other = gltf.places[source.connected];
    JointDescription joint{};
    bool swapped{false};  ///< `a` is what hangs on the joint's own node

    Vec3 axis(std::size_t i) const {
        Vec3d unit{0, 0, 0};
        unit[static_cast<int>(i)] = 1.0;
        return Vec3(frame.turn * unit);
    }
    /// How far the frames are apart along an axis, and turned about it, as the scene begins.
    double shift_now(std::size_t i) const {
        return (glm::conjugate(frame.turn) *
                (other.position_m - frame.position_m))[static_cast<int>(i)];
    }
    double turn_now(std::size_t i) const {
        const Quatd turn = glm::conjugate(frame.turn) * other.turn;
        const std::array<double, 3> along{turn.x, turn.y, turn.z};
        const double angle = 2.0 * portable_atan2(along.at(i), turn.w);
        return angle > kStraight_rad    ? angle - 2 * kStraight_rad
               : angle < -kStraight_rad ? angle + 2 * kStraight_rad
                                        : angle;
    }

    /// As ours count: from what is so at creation, of a against b.
    std::optional<std::array<Real, 2>> limits_from(const AxisRange& range,
                                                   double now,
                                                   double most) const {
        if (range.is_free()) return {};
        double min = std::max(range.min - now, -most);
        double max = std::min(range.max - now, most);
        if (swapped) {
            std::swap(min, max);
            min = -min;
            max = -max;
        }
        return std::array{static_cast<Real>(min), static_cast<Real>(max)};
    }

    bool refuse(std::string_view why) const {
        gltf.warn(source.node, "the joint is left out: {}", why);
        return false;
    }

    bool find_ends() {
        joint.a = gltf.moves(source.connected) ? gltf.entities[source.connected] : std::string{};
        joint.b = standing_end(source.node);
        if (gltf.moves(source.node)) joint.b = gltf.entities[source.node];
        if (joint.a.empty()) {
            joint.a = gltf.moves(source.node) ? gltf.entities[source.node] : std::string{};
            joint.b = standing_end(source.connected);
            swapped = true;
        }
        if (joint.a.empty() || joint.b.empty())
            return refuse(
                "at least one of its nodes must hang on a body that has motion and a collider");
        if (joint.a == joint.b) return refuse("both its nodes hang on one body");
        return true;
    }
    /// The nearest collider above; the world where there is none.
    std::string standing_end(std::uint32_t node) const {
        for (std::optional<std::uint32_t> at = node; at; at = gltf.model.nodes[*at].parent) {
            if (!gltf.moves(*at) && !gltf.entities[*at].empty()) return gltf.entities[*at];
        }
        return "world";
    }

    void drive(bool angular, std::size_t axis_number) {
        const double now = angular ? turn_now(axis_number) : shift_now(axis_number);
        const double sign = swapped ? -1 : 1;
        for (const assets::ModelJointDrive& drive : source.drives) {
            if (drive.is_angular != angular || drive.axis != axis_number) {
                gltf.warn(source.node, "a drive along an axis that the joint locks does nothing");
            } else if (drive.stiffness > 0 || drive.damping > 0) {
                const bool is_hard = !(drive.stiffness > 0) && drive.damping >= assets::kHardDrive;
                const double most = std::min(drive.max_force.value_or(kAnyForce), kAnyForce);
                joint.motor = physics::JointMotor{
                    .target = static_cast<Real>(sign * drive.velocity_target),
                    .max = static_cast<Real>(most),
                    .stiffness = static_cast<Real>(drive.stiffness),
                    .damping = is_hard ? Real{0} : static_cast<Real>(drive.damping),
                    .position = static_cast<Real>(sign * (drive.position_target - now)),
                    .by_mass = drive.by_mass};
            }
        }
    }

    void make_distance(const assets::ModelJointLimit& limit) {
        joint.anchor_a_m = Vec3((swapped ? frame : other).position_m);
        joint.anchor_b_m = Vec3((swapped ? other : frame).position_m);
        const double min_m = std::max(limit.min.value_or(0.0), 0.0);
        const double max_m = limit.max.value_or(1e4);
        if (!limit.stiffness) {
            joint.kind = JointKind::Distance;
            joint.limits = std::array{static_cast<Real>(min_m), static_cast<Real>(max_m)};
            return;
        }
        joint.kind = JointKind::Spring;
        joint.stiffness_Npm = static_cast<Real>(*limit.stiffness);
        joint.damping_Nspm = static_cast<Real>(limit.damping);
        joint.rest_length_m = static_cast<Real>(limit.max ? (min_m + max_m) / 2 : min_m);
        if (limit.max && max_m - min_m > kClosed)
            gltf.warn(source.node,
                      "its spring pulls from {} m on, not beyond limits",
                      (min_m + max_m) / 2);
    }

    /// A ball joint whose turns are bounded.
    void make_cone(const Freedom& freedom) {
        joint.kind = JointKind::Cone;
        std::size_t about = freedom.cone_about.value_or(0);
        double swing_rad = freedom.cone_about ? freedom.cone_rad : kStraight_rad;
        if (!freedom.cone_about) {
            // The axis that has a bound of its own is the twist: locked before ranged.
            const auto first = std::ranges::find_if(freedom.turn, &AxisRange::is_locked);
            const auto ranged = std::ranges::find_if_not(freedom.turn, &AxisRange::is_free);
            about = static_cast<std::size_t>((first != freedom.turn.end() ? first : ranged) -
                                             freedom.turn.begin());
            double widest = 0;
            bool bounded = true;
            for (std::size_t i = 0; i < 3; ++i) {
                if (i == about) continue;
                bounded &= !freedom.turn[i].is_free();
                widest = std::max(
                    {widest, std::abs(freedom.turn[i].min), std::abs(freedom.turn[i].max)});
            }
            if (bounded) {
                swing_rad = std::min(widest, kStraight_rad);
                gltf.warn(source.node, "two limits of angles are one cone here");
            }
        }
        joint.axis = axis(about);
        joint.limits = std::array{Real{0}, static_cast<Real>(std::min(swing_rad, kStraight_rad))};
        joint.twist = limits_from(freedom.turn[about], turn_now(about), kStraight_rad);
    }

    bool make_held(const Freedom& freedom) {
        if (freedom.cone_about) {
            make_cone(freedom);
        } else if (locked(freedom.turn) == 3) {
            joint.kind = JointKind::Fixed;
        } else if (free_axes(freedom.turn) == 3) {
            joint.kind = JointKind::BallAndSocket;
        } else if (locked(freedom.turn) == 2) {
            const std::size_t about = open_axis(freedom.turn);
            joint.kind = JointKind::Hinge;
            joint.axis = axis(about);
            joint.limits = limits_from(freedom.turn[about], turn_now(about), 1e4);
            drive(true, about);
        } else {
            make_cone(freedom);
        }
        return true;
    }

    bool make() {
        Freedom freedom;
        for (const assets::ModelJointLimit& limit : source.limits) add_limit(limit, freedom);
        if (!find_ends()) return false;
        // What is locked away from 0 turns about a point beside the joint's node.
        const Vec3d pivot_m = frame.position_m + frame.turn * Vec3d(freedom.shift[0].place(),
                                                                    freedom.shift[1].place(),
                                                                    freedom.shift[2].place());
        joint.anchor_a_m = joint.anchor_b_m = Vec3(pivot_m);
        if (freedom.is_strange)
            return refuse("a distance from a line, or one angle of three axes, has no joint here");
        if (freedom.is_soft) gltf.warn(source.node, "soft limits are hard here");
        const bool any_shift = free_axes(freedom.shift) < 3;
        if (freedom.distance != nullptr) {
            if (any_shift || free_axes(freedom.turn) < 3 || freedom.cone_about)
                gltf.warn(source.node, "of its limits only the distance is kept");
            make_distance(*freedom.distance);
            return true;
        }
        if (locked(freedom.shift) == 3) {
            if (glm::distance(pivot_m, other.position_m) > kApart_m)
                gltf.warn(source.node, "its frames are apart; they are held as they are");
            return make_held(freedom);
        }
        if (locked(freedom.shift) == 2 && locked(freedom.turn) == 3) {
            const std::size_t along = open_axis(freedom.shift);
            joint.kind = JointKind::Slider;
            joint.axis = axis(along);
            joint.limits = limits_from(freedom.shift[along], shift_now(along), 1e4);
            drive(false, along);
            return true;
        }
        if (free_axes(freedom.turn) == 3 && free_axes(freedom.shift) == 0) return make_box(freedom);
        return refuse("no joint here leaves just these axes free");
    }

    /// Bounds along three axes, as the distance to the nearest side of their box.
    bool make_box(const Freedom& freedom) {
        double reach_m = 0;
        for (const AxisRange& range : freedom.shift)
            reach_m = std::max({reach_m, std::abs(range.min), std::abs(range.max)});
        if (!std::isfinite(reach_m)) return refuse("no joint here leaves just these axes free");
        gltf.warn(source.node, "three limits of lengths are one distance here");
        const assets::ModelJointLimit limit{.axes = {true, true, true}, .min = 0.0, .max = reach_m};
        make_distance(limit);
        return true;
    }
};

/// What our exporter says beyond glTF.
void add_extras(const GltfScene& gltf, std::uint32_t node, JointDescription& joint) {
    if (gltf.model.nodes[node].extras.empty()) return;
    const auto table = table_of_extras(gltf.model.nodes[node].extras, gltf.location, gltf.faults);
    if (!table) return;
    TableReader reader(*table, gltf.called(node), gltf.faults);
    if (auto own = reader.table("joint")) {
        read_joint_traits(*own, joint);
        own->finish();
    }
    reader.finish();
}

}  // namespace

void add_gltf_joints(GltfScene& gltf) {
    std::size_t number = 0;
    for (const assets::ModelJoint& source : gltf.model.physics.joints) {
        JointMaker maker{.gltf = gltf, .source = source};
        const std::string& name = gltf.model.nodes[source.node].name;
        maker.joint.name = is_good_name(name) ? name : fmt::format("joint {}", number);
        ++number;
        maker.joint.collide = source.collide;
        maker.joint.location = gltf.location;
        add_extras(gltf, source.node, maker.joint);
        if (maker.make()) gltf.scene.joints.push_back(std::move(maker.joint));
    }
}

}  // namespace plumbline::scene
