#include "engine/physics/deformable/part_contacts.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr int kPartSweeps = 2;
/// Least cosine between a contact's normal and those of the surfaces.
constexpr double kFacing = 0.5;
constexpr double kStraight = 0.9;
/// How much faster than at the start points may become in a step.
constexpr double kFaster = 1.5;
constexpr double kFaster_mps = 0.2;
/// How far points move, at most, and how many sub-steps they take between two looks at what touches.
constexpr double kLookOfThickness = 0.25;
constexpr double kMostLooked = 8;
/// Looked at beyond what moves there meanwhile.
constexpr double kLookAhead_m = 5e-4;

}  // namespace

PartContacts::PartContacts(PointBody& body, const SurfaceTraits& traits)
    : first_(&body),
      traits_(traits),
      rest_m_(body.positions_m().begin(), body.positions_m().end()),
      near_(body, nullptr, traits.thickness_m) {}

PartContacts::PartContacts(PointBody& first, PointBody& second, const SurfaceTraits& traits)
    : first_(&first),
      second_(&second),
      traits_(traits),
      near_(first, &second, traits.thickness_m) {}

double PartContacts::inverse_mass(std::uint32_t point) const {
    return near_.is_of_second(point) ? second_->inverse_mass(point - first_->positions_m().size())
                                     : first_->inverse_mass(point);
}

void PartContacts::change_velocity(std::uint32_t point, const Vec3d& by_mps) {
    if (!near_.is_of_second(point)) return first_->change_velocity(point, by_mps);
    second_->change_velocity(point - first_->positions_m().size(), by_mps);
}

void PartContacts::begin_step(double seconds) {
    seconds_ = seconds;
    near_.begin_step(seconds);
    look_anew();
}

void PartContacts::look_anew() {
    find_normals();
    looked_for_s_ = 0;
    look_in_s_ = 0;
    fastest_mps_ =
        kFaster *
            std::max(physics::fastest_mps(first_->velocities_mps()),
                     second_ != nullptr ? physics::fastest_mps(second_->velocities_mps()) : 0) +
        kFaster_mps;
}

/// For a few sub-steps: while nothing moves by much of the thickness.
void PartContacts::look(double h) {
    // Most of what moves slowly needs no new list.
    if (near_.keep_up(fastest_mps_ * seconds_)) look_anew();
    const double before_s = looked_for_s_;
    looked_for_s_ =
        std::clamp(kLookOfThickness * traits_.thickness_m / fastest_mps_, h, kMostLooked * h);
    look_in_s_ = looked_for_s_;
    contacts_.clear();
    for (PartPair& pair : near_.pairs()) {
        pair.idle_s -= before_s;
        if (pair.idle_s < looked_for_s_) add(pair, looked_for_s_);
    }
}

void PartContacts::solve(double h) {
    if (look_in_s_ < h / 2) look(h);
    look_in_s_ -= h;
    for (Contact& contact : contacts_) {
        contact.pressed_Ns = 0;
        contact.rubbed_Ns = {0, 0, 0};
    }
    for (int sweep = 0; sweep < kPartSweeps; ++sweep) {
        for (Contact& contact : contacts_) solve_one(contact, h);
    }
}

void PartContacts::follow(double h) {
    for (Contact& contact : contacts_)
        contact.gap_m += h * glm::dot(contact.normal, contact.difference(near_.velocities_mps()));
}

/// Points' normals, of what encloses something; of the rest 0.
void PartContacts::find_normals() {
    const PointValues at_m = near_.positions_m();
    normals_.assign(at_m.size(), Vec3d{0, 0, 0});
    if (!near_.enclose()) return;
    for (const auto& [a, b, c] : near_.parts().triangles) {
        if (!near_.encloses(a)) continue;
        const Vec3d normal = glm::cross(at_m[b] - at_m[a], at_m[c] - at_m[a]);
        for (const std::uint32_t point : {a, b, c}) normals_[point] += normal;
    }
    for (Vec3d& normal : normals_) normal = normalize_or(normal, Vec3d{0, 0, 0});
}

/// Out of the second, and into the first, as far as they enclose something.
Vec3d PartContacts::facing_of(const Contact& contact, bool are_edges) const {
    const auto& [a, b, c, d] = contact.points;
    if (are_edges) return normals_[c] + normals_[d] - normals_[a] - normals_[b];
    return normals_[b] + normals_[c] + normals_[d] - normals_[a];
}

/// Turns the normal to the side where the first should be; false: they do not face each other.
bool PartContacts::turn(const PartPair& pair, Contact& contact, double& distance_m) const {
    const Vec3d facing = facing_of(contact, pair.are_edges);
    const bool is_known = facing != Vec3d{0, 0, 0};
    const double cosine = is_known ? glm::dot(contact.normal, glm::normalize(facing)) : 1;
    const bool has_passed = is_known ? cosine < 0 : contact.side != 0 && contact.side == -pair.side;
    if (!has_passed) return cosine > kFacing;
    contact.normal = -contact.normal;
    distance_m = -distance_m;
    // Beyond its edge another triangle is nearer.
    return !is_known || -cosine > (contact.side == 0 ? kStraight : kFacing);
}

void PartContacts::add(PartPair& pair, double seconds) {
    Contact contact{near_.place_of(pair)};
    const Vec3d apart_m = contact.difference(near_.positions_m());
    double distance_m = glm::length(apart_m);
    pair.idle_s = (distance_m - traits_.thickness_m) / (2 * fastest_mps_);
    if (pair.are_edges && contact.side == 0) {
        if (contact.run_along) pair.side = 0;  // it may be another when they cross again
        return;                                // an end is closer: its point
    }
    if (!(distance_m > 0)) return;
    contact.normal = apart_m / distance_m;
    if (!turn(pair, contact, distance_m)) return;
    const double opening = glm::dot(contact.normal, contact.difference(near_.velocities_mps()));
    if (distance_m + std::min(opening, 0.0) * seconds > traits_.thickness_m + kLookAhead_m) {
        pair.side = 0;
        return;
    }
    pair.idle_s = 0;
    if (pair.side == 0) pair.side = contact.side;
    contact.gap_m = distance_m - traits_.thickness_m;
    if (second_ == nullptr) {
        // Neighbours are closer than a coarse thread is thick.
        const double rest_m = glm::length(contact.difference(rest_m_));
        contact.gap_m = distance_m - std::min(traits_.thickness_m, rest_m / 2);
    }
    for (std::size_t i = 0; i < 4; ++i)
        contact.inverse_mass +=
            contact.weights[i] * contact.weights[i] * inverse_mass(contact.points[i]);
    if (contact.inverse_mass > 0) contacts_.push_back(contact);
}

void PartContacts::solve_one(Contact& contact, double h) {
    const Vec3d relative = contact.difference(near_.velocities_mps());
    const double opening = glm::dot(contact.normal, relative);
    const double wanted = wanted_opening_mps(contact.gap_m, h);
    if (opening >= wanted && contact.pressed_Ns == 0) return;
    const double pressed_Ns =
        std::max(contact.pressed_Ns + (wanted - opening) / contact.inverse_mass, 0.0);
    Vec3d rubbed_Ns =
        contact.rubbed_Ns - (relative - contact.normal * opening) / contact.inverse_mass;
    const double most_Ns = traits_.friction * pressed_Ns;
    const double size_Ns = glm::length(rubbed_Ns);
    if (size_Ns > most_Ns) rubbed_Ns *= most_Ns / size_Ns;
    const Vec3d impulse_Ns =
        contact.normal * (pressed_Ns - contact.pressed_Ns) + rubbed_Ns - contact.rubbed_Ns;
    contact.pressed_Ns = pressed_Ns;
    contact.rubbed_Ns = rubbed_Ns;
    for (std::size_t i = 0; i < 4; ++i)
        change_velocity(contact.points[i],
                        impulse_Ns * (contact.weights[i] * inverse_mass(contact.points[i])));
}

void PartContacts::serialize(Archive& archive) {
    near_.serialize(archive);
}

}  // namespace plumbline::physics
