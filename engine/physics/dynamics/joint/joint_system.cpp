#include "engine/physics/dynamics/joint/joint_system.h"

#include "engine/core/assert.h"
#include "engine/core/time/trace_events.h"
#include "engine/physics/dynamics/joint/joint_direct.h"
#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/dynamics/joint/joint_iterative.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {
namespace {

JointSpring spring_of(std::size_t index, JointGroup& group) {
    const SolverJoint& joint = group.joints[index];
    const auto [a, b] = group.topology->sides[index];
    return {.joint = static_cast<std::uint32_t>(index),
            .a = &group.bodies[a],
            .b = &group.bodies[b],
            .anchor_in_a = joint.anchor_in_a,
            .anchor_in_b = joint.anchor_in_b,
            .stiffness_Npm = static_cast<double>(joint.stiffness_Npm),
            .damping_Nspm = static_cast<double>(joint.damping_Nspm),
            .rest_m = static_cast<double>(joint.rest_length_m),
            .before_Ns = static_cast<double>(joint.bound_load[0]) * group.substep_s / 2,
            .damped_Ns = static_cast<double>(joint.bound_load[1]) * group.substep_s / 2,
            .before_mps = static_cast<double>(joint.bound_load[2])};
}

/// Springs that are forces.
void list_soft_springs(JointGroup& group,
                       std::span<const JointForm> forms,
                       std::vector<JointSpring>& list) {
    list.clear();
    for (std::size_t i = 0; i < group.joints.size(); ++i) {
        if (group.joints[i].kind == JointKind::Spring && forms[i].places == NodeKind::None)
            list.push_back(spring_of(i, group));
    }
}

/// Springs that are rows.
void list_stiff_springs(std::span<const SolverBody> bodies,
                        JointGroup& group,
                        std::vector<JointSpring>& list) {
    list.clear();
    for (std::uint32_t node = 0; node < group.topology->nodes.size(); ++node) {
        const std::uint32_t joint = group.topology->nodes[node].joint;
        if (group.joints[joint].kind != JointKind::Spring) continue;
        list.push_back(spring_of(joint, group));
        list.back().node = node;
        list.back().turns = turns_bodies(group.joints[joint], bodies, group.substep_s);
        list.back().unresolved = is_unresolved(group.joints[joint], bodies, group.substep_s);
    }
}

/// The mean force on b and torque over this time, where the iterative method and the next step's
/// geometric stiffness look for them.
void keep_mean_loads(std::span<const JointTotal> totals,
                     double duration_s,
                     std::span<SolverJoint> joints) {
    const double per_second = -1 / duration_s;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Vec3d force = totals[i].impulse_Ns * per_second;
        const Vec3d torque = totals[i].angular_impulse_Nms * per_second;
        joints[i].mean_load = {static_cast<Real>(force.x),
                               static_cast<Real>(force.y),
                               static_cast<Real>(force.z),
                               static_cast<Real>(torque.x),
                               static_cast<Real>(torque.y),
                               static_cast<Real>(torque.z)};
    }
}

}  // namespace

struct JointSystem::Impl {
    /// Where the present sub-step is.
    enum class Phase : std::uint8_t {
        Ready,   ///< rows are those of the poses; the next push of springs begins a sub-step
        Pushed,  ///< forces are in the velocities, nothing has moved
        Moved,   ///< positions are corrected, rows are still those of before
    };

    TopologyCache topologies;
    JointGroup group;
    DirectJoints direct;
    IterativeJoints iterative;
    std::vector<JointSpring> soft_springs;
    StiffSprings stiff;
    std::vector<JointForm> forms;
    std::vector<double> spring_load;
    std::vector<bool> is_stiff;
    std::vector<Vec3d> noted_impulses;
    std::vector<double> noted_bounds;
    JointMethod method{JointMethod::Direct};
    Phase phase{Phase::Ready};
    int substeps{0};
    JointWork work;

    bool is_direct() const { return method == JointMethod::Direct; }
    void find_forms(std::span<const SolverBody> bodies);
    void begin_substep();
    void push_springs(double duration_s);
    void adjust_springs();
    void finish_joint(std::size_t index);
    template <typename Visit>
    void for_springs(Visit visit) {
        for (JointSpring& spring : soft_springs) visit(spring);
        for (JointSpring& spring : stiff.lines) visit(spring);
    }
};

void JointSystem::Impl::find_forms(std::span<const SolverBody> bodies) {
    const auto is_spring = [](const SolverJoint& joint) { return joint.kind == JointKind::Spring; };
    const bool any_spring = std::ranges::any_of(group.joints, is_spring);
    if (any_spring) {
        find_stiff_springs(bodies, group.joints, group.substep_s, spring_load, is_stiff);
    }
    forms.clear();
    for (std::size_t i = 0; i < group.joints.size(); ++i) {
        forms.push_back(form_of(group.joints[i], any_spring && is_stiff[i]));
    }
}

void JointSystem::Impl::begin_substep() {
    ++substeps;
    for (JointBound& bound : group.bounds) {
        if (is_direct()) bound.before_motion(group.substep_s);
    }
    if (!is_direct()) iterative.warm_start(group);
}

void JointSystem::Impl::push_springs(double duration_s) {
    const bool after_motion = phase == Phase::Moved;
    for (std::size_t i = 0; i < soft_springs.size(); ++i) {
        // Backwards after the motion: a sub-step looks the same from its end.
        const std::size_t index = after_motion ? soft_springs.size() - 1 - i : i;
        push_soft_spring(soft_springs[index], group.substep_s, duration_s, after_motion, group);
    }
    if (after_motion) {
        for (JointSpring& spring : stiff.lines) push_second_half(spring, group);
        for (ElasticBlock& block : stiff.blocks) push_rest(block, group);
    } else if (is_direct()) {
        direct.push_springs(group, stiff, duration_s);
    } else {
        for (JointSpring& spring : stiff.lines) {
            push_overdamped_spring(spring, group);
            push_stiff_spring(spring, duration_s, group);
        }
        for (ElasticBlock& block : stiff.blocks) {
            begin_push(block, group);
            adjust_block(block, group);
        }
    }
}

/// Contacts changed the velocities since the push before the motion.
void JointSystem::Impl::adjust_springs() {
    if (stiff.empty() || phase != Phase::Pushed) return;
    if (is_direct()) return direct.adjust_springs(group, stiff);
    for (JointSpring& spring : stiff.lines) adjust_stiff_spring(spring, group.substep_s / 2, group);
    for (ElasticBlock& block : stiff.blocks) adjust_block(block, group);
}

void JointSystem::Impl::finish_joint(std::size_t index) {
    SolverJoint& joint = group.joints[index];
    joint.total_impulse_Ns = group.totals[index].impulse_Ns;
    joint.total_angular_impulse_Nms = group.totals[index].angular_impulse_Nms;
    const JointBody& a = group.bodies[group.topology->sides[index][0]];
    const JointBody& b = group.bodies[group.topology->sides[index][1]];
    if (joint.kind == JointKind::BallAndSocket) {
        joint.error_m = glm::length((b.position_m - a.position_m) +
                                    (b.axes * joint.anchor_in_b - a.axes * joint.anchor_in_a));
    } else {
        const JointFit fit =
            joint_error(joint, {a.position_m, a.orientation}, {b.position_m, b.orientation});
        joint.error_m = fit.error_m;
        joint.position = fit.position;
    }
    work.max_error_m = std::max(work.max_error_m, joint.error_m);
}

JointSystem::JointSystem() : impl_(std::make_unique<Impl>()) {}
JointSystem::~JointSystem() = default;
JointSystem::JointSystem(JointSystem&&) noexcept = default;
JointSystem& JointSystem::operator=(JointSystem&&) noexcept = default;

void JointSystem::start(std::span<SolverBody> bodies,
                        std::span<SolverJoint> joints,
                        double substep_s,
                        JointMethod method) {
    const TraceSpan span("prepare joints");
    Impl& impl = *impl_;
    JointGroup& group = impl.group;
    impl.work = {};
    impl.phase = Impl::Phase::Ready;
    impl.substeps = 0;
    group.row_solves = 0;
    group.substep_s = substep_s;
    group.joints = joints;
    impl.find_forms(bodies);
    group.topology = &impl.topologies.of(bodies, joints, impl.forms);
    impl.method = group.topology->too_dear ? JointMethod::Iterative : method;
    group.start(bodies);
    list_soft_springs(group, impl.forms, impl.soft_springs);
    list_stiff_springs(bodies, group, impl.stiff.lines);
    list_elastic_blocks(group, impl.stiff.blocks);
    if (impl.is_direct()) {
        impl.direct.start(group);
    } else {
        impl.iterative.start(group);
    }
}

void JointSystem::push_springs(double duration_s) {
    Impl& impl = *impl_;
    impl.group.read_velocities();
    if (impl.phase == Impl::Phase::Ready) {
        impl.begin_substep();
        impl.phase = Impl::Phase::Pushed;
    }
    impl.push_springs(duration_s);
    impl.group.write_velocities();
}

void JointSystem::solve_velocities() {
    const TraceSpan span("joint velocities");
    Impl& impl = *impl_;
    impl.group.read_velocities();
    impl.adjust_springs();
    if (impl.is_direct()) {
        impl.direct.solve_velocities(impl.group);
    } else {
        impl.iterative.sweep(impl.group, impl.phase == Impl::Phase::Pushed);
    }
    impl.group.write_velocities();
}

std::uint32_t JointSystem::piece_of(std::uint32_t body) const {
    return impl_->is_direct() ? impl_->group.piece_of(body) : JointGroup::kNoPiece;
}

void JointSystem::respond(const ImpulseLine& pushed,
                          std::span<const ImpulseLine> lines,
                          std::span<double> changes) {
    impl_->group.respond(impl_->direct.matrix(), pushed, lines, changes);
}

void JointSystem::solve_piece(std::uint32_t piece) {
    JointGroup& group = impl_->group;
    group.read_velocities();
    impl_->direct.solve_component(group, group.topology->components[piece]);
    group.write_velocities();
}

void JointSystem::note_impulses() {
    impl_->noted_impulses = impl_->group.impulses;
    impl_->noted_bounds.clear();
    for (const JointBound& bound : impl_->group.bounds)
        impl_->noted_bounds.push_back(bound.impulse);
}

void JointSystem::return_impulses() {
    impl_->group.impulses = impl_->noted_impulses;
    for (std::size_t i = 0; i < impl_->noted_bounds.size(); ++i)
        impl_->group.bounds[i].impulse = impl_->noted_bounds[i];
}

void JointSystem::end_impacts() {
    impl_->group.collect_totals();
    impl_->for_springs([](JointSpring& spring) { spring.before_Ns = spring.damped_Ns = 0; });
    for (ElasticBlock& block : impl_->stiff.blocks) block.before = {0, 0, 0};
}

void JointSystem::begin_motion(bool hold_steady_changes) {
    Impl& impl = *impl_;
    if (impl.is_direct() && (hold_steady_changes || impl.group.pushes_steadily()))
        impl.direct.hold_steady_changes(impl.group);
    bool any = false;
    impl.for_springs([&](const JointSpring& spring) { any = any || spring.ahead_Ns != 0; });
    if (!any && impl.stiff.blocks.empty()) return;
    impl.group.read_velocities();
    impl.for_springs([&](JointSpring& spring) { SpringLine(spring).take_back_ahead(spring); });
    for (ElasticBlock& block : impl.stiff.blocks) take_back_ahead(block, impl.group);
    impl.group.write_velocities();
}

void JointSystem::correct_positions() {
    const TraceSpan span("joint positions");
    Impl& impl = *impl_;
    for (JointBody& body : impl.group.bodies) body.read_pose();
    impl.phase = Impl::Phase::Moved;
    if (!impl.is_direct()) {
        for (JointBody& body : impl.group.bodies) body.update_inertia();
        return;
    }
    impl.group.read_velocities();
    impl.direct.correct_positions(impl.group, impl.stiff);
    impl.group.write_velocities();
    for (const JointBody& body : impl.group.bodies) body.write_pose();
}

void JointSystem::refresh() {
    Impl& impl = *impl_;
    PL_ASSERT(impl.phase == Impl::Phase::Moved, "correct_positions() before refresh()");
    impl.phase = Impl::Phase::Ready;
    impl.group.refresh();
    if (impl.is_direct()) {
        impl.direct.factor(impl.group);
        if (!impl.direct.holds_half()) return;
        impl.group.read_velocities();
        impl.direct.hold_second_half(impl.group);
        impl.group.write_velocities();
    } else {
        impl.iterative.refresh(impl.group);
    }
}

void JointSystem::finish() {
    Impl& impl = *impl_;
    impl.group.collect_totals();
    for (std::size_t i = 0; i < impl.group.joints.size(); ++i) impl.finish_joint(i);
    impl.for_springs([&](const JointSpring& spring) {
        auto& loads = impl.group.joints[spring.joint].bound_load;
        const double per_s = 2 / impl.group.substep_s;
        loads[0] = static_cast<Real>(spring.before_Ns * per_s);
        loads[1] = static_cast<Real>(spring.damped_Ns * per_s);
        loads[2] = static_cast<Real>(spring.before_mps);
    });
    for (const ElasticBlock& block : impl.stiff.blocks) keep_speed(block, impl.group);
    for (const JointBound& bound : impl.group.bounds) {
        bound.store_load(impl.group.joints[bound.joint_index], impl.group.substep_s);
    }
    if (impl.is_direct()) {
        if (impl.substeps > 0)
            keep_mean_loads(
                impl.group.totals, impl.substeps * impl.group.substep_s, impl.group.joints);
        impl.work.unresolved = impl.direct.unresolved();
    } else {
        impl.iterative.finish(impl.group);
    }
    impl.work.row_solves = impl.group.row_solves;
    impl.work.method = impl.method;
}

bool JointSystem::solves_before_motion() const {
    return !impl_->is_direct() || !impl_->group.bounds.empty();
}

double JointSystem::most_speed() const {
    if (!impl_->is_direct()) return std::numeric_limits<double>::infinity();
    double most = 0;
    for (const JointRows& rows : impl_->group.rows) {
        const Vec3d speeds = glm::abs(masked(rows.speeds(impl_->group.bodies), rows.active));
        most = std::max({most, speeds.x, speeds.y, speeds.z});
    }
    return most;
}

bool JointSystem::has_stiff_springs() const {
    return !impl_->stiff.empty();
}

const JointWork& JointSystem::work() const {
    return impl_->work;
}

}  // namespace plumbline::physics
