#include "engine/study/gallery/measures.h"

#include "engine/physics/totals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace plumbline::study {
namespace {

constexpr double kDegrees = 57.295779513082321;

Vec3d at(const Pose& pose) {
    return Vec3d{pose.position};
}
Vec3d position(const BodyObservation& body) {
    return at(body.now.world_from_body) - at(body.other_now.world_from_body);
}
Vec3d start_position(const BodyObservation& body) {
    return at(body.start.world_from_body) - at(body.other_start.world_from_body);
}
Vec3d moved(const BodyObservation& body) {
    return position(body) - start_position(body);
}
Vec3d velocity(const BodyObservation& body) {
    return Vec3d{body.now.velocity_mps} - Vec3d{body.other_now.velocity_mps};
}
Vec3d start_velocity(const BodyObservation& body) {
    return body.start.velocity_mps - body.other_start.velocity_mps;
}
/// World axes: what turns the body from its start to now.
Quatd turned(const BodyObservation& body) {
    return Quatd{body.now.world_from_body.orientation} *
           glm::conjugate(Quatd{body.start.world_from_body.orientation});
}
double angle_between_deg(const Vec3d& a, const Vec3d& b) {
    const double lengths = glm::length(a) * glm::length(b);
    if (lengths == 0) return 0;
    return kDegrees * std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0));
}
double share_of(double change, double of) {
    return of != 0 ? change / of : change;
}
double change_of(const Vec3d& start, const Vec3d& now) {
    return share_of(glm::distance(now, start), glm::length(start));
}
double across(const Vec3d& v) {
    return std::hypot(v.x, v.z);
}

/// Mean over the latest step.
double contact_force_N(const BodyObservation& body) {
    double sum = 0;
    for (const physics::ContactEvent& contact : body.contacts) {
        const bool mine = contact.a == body.id || contact.b == body.id;
        const bool asked =
            body.other == physics::BodyId{} || contact.a == body.other || contact.b == body.other;
        if (mine && asked) sum += static_cast<double>(contact.impulse_Ns);
    }
    return sum / body.step_s;
}

double mean_displacement_m(std::span<const BodyObservation> bodies) {
    double sum = 0;
    for (const BodyObservation& body : bodies) sum += glm::length(moved(body));
    return bodies.empty() ? 0 : sum / static_cast<double>(bodies.size());
}
double mean_height_m(std::span<const BodyObservation> bodies) {
    double sum = 0;
    for (const BodyObservation& body : bodies) sum += position(body).y;
    return bodies.empty() ? 0 : sum / static_cast<double>(bodies.size());
}
/// The steepest line from the top of a heap to its foot: height of the highest body over how far
/// out 90 % of them lie.
double heap_slope_deg(std::span<const BodyObservation> bodies) {
    if (bodies.empty()) return 0;
    Vec3d middle{0, 0, 0};
    for (const BodyObservation& body : bodies)
        middle += position(body) / static_cast<double>(bodies.size());
    std::vector<double> out_m;
    double top_m = 0;
    for (const BodyObservation& body : bodies) {
        out_m.push_back(across(position(body) - middle));
        top_m = std::max(top_m, position(body).y);
    }
    const auto at_90 = out_m.begin() + static_cast<std::ptrdiff_t>(out_m.size() * 9 / 10);
    std::ranges::nth_element(out_m, at_90);
    return kDegrees * std::atan2(top_m, *at_90);
}

double energy_gain(const WorldObservation& look) {
    return (look.totals.energy_J() - look.start.energy_J - look.added_energy_J) /
           look.start.energy_scale_J;
}

/// docs/SCENE-FORMAT.md says what each one is.
const std::array kMeasures{
    // --- of every body named; the worst one counts
    Measure{"drift_m", +[](const BodyObservation& body) { return across(moved(body)); }},
    Measure{"displacement_m",
            +[](const BodyObservation& body) { return glm::length(moved(body)); }},
    Measure{"sag_m", +[](const BodyObservation& body) { return -moved(body).y; }},
    Measure{"height_m", +[](const BodyObservation& body) { return position(body).y; }},
    Measure{"lowest_m", +[](const BodyObservation& body) { return body.lowest_m; }},
    Measure{"x_m", +[](const BodyObservation& body) { return position(body).x; }},
    Measure{"z_m", +[](const BodyObservation& body) { return position(body).z; }},
    Measure{"from_axis_m", +[](const BodyObservation& body) { return across(position(body)); }},
    Measure{"reach_m",
            +[](const BodyObservation& body) {
                const double up = velocity(body).y;
                return position(body).y + up * up / (2 * body.gravity_mps2);
            }},
    Measure{"speed_mps", +[](const BodyObservation& body) { return glm::length(velocity(body)); }},
    Measure{"speed_x_mps", +[](const BodyObservation& body) { return velocity(body).x; }},
    Measure{"up_speed_mps", +[](const BodyObservation& body) { return velocity(body).y; }},
    Measure{"horizontal_speed_mps",
            +[](const BodyObservation& body) { return across(velocity(body)); }},
    Measure{"speed_change",
            +[](const BodyObservation& body) {
                const double before = glm::length(start_velocity(body));
                return std::abs(share_of(glm::length(velocity(body)) - before, before));
            }},
    Measure{"heading_deg",
            +[](const BodyObservation& body) {
                const Vec3d now = velocity(body);
                const Vec3d then = start_velocity(body);
                return angle_between_deg({now.x, 0, now.z}, {then.x, 0, then.z});
            }},
    Measure{"spin_radps",
            +[](const BodyObservation& body) {
                return glm::length(Vec3d{body.now.angular_velocity_radps});
            }},
    Measure{"tilt_deg",
            +[](const BodyObservation& body) {
                return angle_between_deg(turned(body) * Vec3d{0, 1, 0}, {0, 1, 0});
            }},
    Measure{"awake", +[](const BodyObservation& body) { return body.now.awake ? 1.0 : 0.0; }},
    Measure{"contact_force_N", &contact_force_N},
    // --- of all bodies named together
    Measure{"mean_displacement_m", &mean_displacement_m},
    Measure{"mean_height_m", &mean_height_m},
    Measure{"heap_slope_deg", &heap_slope_deg},
    // --- of joints
    Measure{"joint_error_m", +[](const physics::JointState& joint) { return joint.error_m; }},
    Measure{"joint_force_N",
            +[](const physics::JointState& joint) { return static_cast<double>(joint.force_N); }},
    Measure{"joint_angle_deg",
            +[](const physics::JointState& joint) {
                return kDegrees * static_cast<double>(joint.position);
            }},
    Measure{"joint_displacement_m",
            +[](const physics::JointState& joint) { return static_cast<double>(joint.position); }},
    // --- of the world
    Measure{"max_joint_error_m",
            +[](const WorldObservation& look) { return max_joint_error_m(look.world); }},
    Measure{"penetration_m",
            +[](const WorldObservation& look) {
                return look.penetration_m ? *look.penetration_m : max_penetration_m(look.world);
            }},
    Measure{"energy_gain", &energy_gain},
    Measure{"energy_loss", +[](const WorldObservation& look) { return -energy_gain(look); }},
    Measure{
        "braked_share",
        +[](const WorldObservation& look) { return look.braked_J / look.start.energy_scale_J; }},
    Measure{"kinetic_J",
            +[](const WorldObservation& look) { return look.totals.energy.kinetic_J; }},
    Measure{"momentum_change",
            +[](const WorldObservation& look) {
                return change_of(look.start.momentum_kgmps, look.totals.momentum_kgmps);
            }},
    Measure{"angular_momentum_change",
            +[](const WorldObservation& look) {
                return change_of(look.start.angular_momentum_kgm2ps,
                                 look.totals.angular_momentum_kgm2ps);
            }},
    Measure{"non_finite",
            +[](const WorldObservation& look) {
                return static_cast<double>(look.world.report().isolated.size());
            }},
    Measure{"removed",
            +[](const WorldObservation& look) { return static_cast<double>(look.removed); }},
};

}  // namespace

std::span<const Measure> measures() {
    return kMeasures;
}

const Measure* find_measure(std::string_view name) {
    const auto found = std::ranges::find(kMeasures, name, &Measure::name);
    return found != kMeasures.end() ? &*found : nullptr;
}

}  // namespace plumbline::study
