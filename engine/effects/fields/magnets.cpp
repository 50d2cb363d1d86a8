// Magnets as dipoles: on each other, and in a uniform field.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/effects/fields/field_effect.h"
#include "engine/physics/medium.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumbline::effects {
namespace {

using physics::BodyId;
using physics::BodyInField;

constexpr double kMu0Over4Pi = 1e-7;
/// Of the lighter one's weight: pairs that pull less are left out.
constexpr double kLeastPull = 1e-4;
/// Of the smaller one's size, added to the distance squared: no pull is without bounds where two centres meet.
constexpr double kSoftening = 0.01;
/// Slower magnets wake none that sleep.
constexpr double kWaking_mps = 0.01;

struct Dipole {
    Vec3d moment_body_Am2{0, 0, 0};
    Quatd mass_from_body{1, 0, 0, 0};
    double size_m{0};
    double mass_kg{0};  ///< 0: never moves
    BodyInField* in_call{nullptr};
};

/// A dipole somewhere.
struct Placed {
    Vec3d at_m{0, 0, 0};
    Vec3d moment_Am2{0, 0, 0};
};

/// What a pulls b by; a is pulled by the opposite force.
struct Pull {
    Vec3d force_on_b_N{0, 0, 0};
    Vec3d torque_on_a_Nm{0, 0, 0};
    Vec3d torque_on_b_Nm{0, 0, 0};
    double energy_J{0};
    double stiffness_Npm{0};
    double torque_stiffness_Nm{0};
};

/// Two dipoles, softened so that force and torques still come from one energy: U = mu0/(4 pi) (m1.m2/q3 - 3 (m1.r)(m2.r)/q5)
/// with q2 = r2 + e2. Without softening Griffiths, Introduction to Electrodynamics, 5.4.3 and 6.1.
Pull pull_between(const Placed& a, const Placed& b, double softening_m) {
    const Vec3d r = b.at_m - a.at_m;
    const double q2 = glm::dot(r, r) + softening_m * softening_m;
    const double q = std::sqrt(q2);
    const double q3 = q2 * q;
    const double q5 = q3 * q2;
    const Vec3d& ma = a.moment_Am2;
    const Vec3d& mb = b.moment_Am2;
    const double a_r = glm::dot(ma, r);
    const double b_r = glm::dot(mb, r);
    const double a_b = glm::dot(ma, mb);
    const Vec3d field_at_b = kMu0Over4Pi * (3 * a_r / q5 * r - ma / q3);
    const Vec3d field_at_a = kMu0Over4Pi * (3 * b_r / q5 * r - mb / q3);
    Pull pull;
    pull.energy_J = kMu0Over4Pi * (a_b / q3 - 3 * a_r * b_r / q5);
    pull.force_on_b_N =
        3 * kMu0Over4Pi / q5 * (a_b * r + a_r * mb + b_r * ma - 5 * a_r * b_r / q2 * r);
    pull.torque_on_a_Nm = glm::cross(ma, field_at_a);
    pull.torque_on_b_Nm = glm::cross(mb, field_at_b);
    const double moments = glm::length(ma) * glm::length(mb);
    pull.torque_stiffness_Nm = 2 * kMu0Over4Pi * moments / q3;
    pull.stiffness_Npm = 6 * kMu0Over4Pi * moments / q5;
    return pull;
}

class Magnets final : public FieldEffect<Dipole> {
public:
    explicit Magnets(scene::Simulation& simulation) : FieldEffect(simulation, "magnets") {
        list_now();
        prepare();
    }

    int substeps() const override {
        return field_substeps(simulation_.description().forces.fidelity.magnets);
    }

    bool acts_on(BodyId body) const override {
        return receivers_.has(body) &&
               simulation_.physics.state(body).kind == physics::BodyKind::Dynamic;
    }

    void list_pairs(std::vector<Pair>& pairs) const override {
        for (const auto& [a, b] : pairs_) {
            const BodyId first = receivers_.all()[a].body;
            const BodyId second = receivers_.all()[b].body;
            if (simulation_.physics.state(first).pushable() &&
                simulation_.physics.state(second).pushable())
                pairs.emplace_back(first, second);
        }
    }

    double energy_J() const override {
        const Vec3d field_T(simulation_.description().forces.magnetic_field_T);
        double sum = 0;
        std::vector<Placed> placed;
        for (const auto& entry : receivers_.all()) {
            placed.push_back(standing(entry));
            sum -= glm::dot(placed.back().moment_Am2, field_T);
        }
        for (const auto& [a, b] : pairs_)
            sum += pull_between(placed[a], placed[b], softening_m(a, b)).energy_J;
        return sum;
    }

private:
    using Entry = Receivers<Dipole>::Entry;

    void list_receivers() override {
        receivers_.clear();
        simulation_.registry.view<const scene::Magnet, const scene::BodyRef>().each(
            [this](ecs::Entity, const scene::Magnet& magnet, const scene::BodyRef& ref) {
                const physics::BodyState state = simulation_.physics.state(ref.body);
                const Vec3d half_m = physics::half_extent_m(simulation_.physics, ref.body);
                receivers_.add(
                    ref.body,
                    {.moment_body_Am2 = Vec3d(magnet.moment_Am2),
                     .mass_from_body = physics::mass_from_body(simulation_.physics, ref.body),
                     .size_m = 2 * std::min({half_m.x, half_m.y, half_m.z}),
                     .mass_kg = static_cast<double>(state.mass.mass_kg)});
            });
    }

    Placed standing(const Entry& entry) const {
        const physics::BodyState state = simulation_.physics.state(entry.body);
        return {Vec3d(state.center_of_mass_world()),
                Quatd(state.world_from_body.orientation) * entry.own.moment_body_Am2};
    }

    Placed placed(const Entry& entry) const {
        if (entry.own.in_call == nullptr) return standing(entry);
        const BodyInField& body = *entry.own.in_call;
        return {body.center_m,
                body.world_from_mass * (entry.own.mass_from_body * entry.own.moment_body_Am2)};
    }

    double softening_m(std::size_t a, std::size_t b) const {
        return kSoftening *
               std::min(receivers_.all()[a].own.size_m, receivers_.all()[b].own.size_m);
    }

    /// Who pulls whom in the step to come; that wakes.
    void prepare() override {
        const std::vector<Entry>& all = receivers_.all();
        std::vector<Placed> now;
        for (const Entry& entry : all) now.push_back(standing(entry));
        std::vector<std::size_t> by_x(all.size());
        std::iota(by_x.begin(), by_x.end(), std::size_t{0});
        std::ranges::sort(by_x, {}, [&now](std::size_t i) { return now[i].at_m.x; });
        double strongest = 0;
        double lightest_kg = HUGE_VAL;
        for (const Entry& entry : all) {
            strongest = std::max(strongest, glm::length(entry.own.moment_body_Am2));
            if (entry.own.mass_kg > 0) lightest_kg = std::min(lightest_kg, entry.own.mass_kg);
        }
        pairs_.clear();
        for (std::size_t i = 0; i < by_x.size(); ++i) {
            for (std::size_t j = i + 1; j < by_x.size(); ++j) {
                const std::size_t a = std::min(by_x[i], by_x[j]);
                const std::size_t b = std::max(by_x[i], by_x[j]);
                const double apart_m = now[by_x[j]].at_m.x - now[by_x[i]].at_m.x;
                if (apart_m > reach_m(strongest * strongest, lightest_kg)) break;
                if (pulls(a, b, now)) pairs_.emplace_back(a, b);
            }
        }
        std::ranges::sort(pairs_);
        for (const auto& [a, b] : pairs_) wake_each_other(all[a].body, all[b].body);
    }

    /// Where the pull of such moments is the least that counts.
    static double reach_m(double moments_A2m4, double mass_kg) {
        const double least_N = kLeastPull * mass_kg * physics::kStandardGravity_mps2;
        return std::sqrt(std::sqrt(6 * kMu0Over4Pi * moments_A2m4 / least_N));
    }

    bool pulls(std::size_t a, std::size_t b, const std::vector<Placed>& now) const {
        const auto mass_of = [this](std::size_t i) {
            const double mass_kg = receivers_.all()[i].own.mass_kg;
            return mass_kg > 0 ? mass_kg : HUGE_VAL;
        };
        const double lighter_kg = std::min(mass_of(a), mass_of(b));
        if (lighter_kg == HUGE_VAL) return false;
        const double moments = glm::length(now[a].moment_Am2) * glm::length(now[b].moment_Am2);
        return glm::distance(now[a].at_m, now[b].at_m) < reach_m(moments, lighter_kg);
    }

    void wake_each_other(BodyId a, BodyId b) {
        const auto moves = [](const physics::BodyState& state) {
            return state.awake && glm::length(state.velocity_mps) > static_cast<Real>(kWaking_mps);
        };
        const physics::BodyState first = simulation_.physics.state(a);
        const physics::BodyState second = simulation_.physics.state(b);
        if (moves(first) && !second.awake) simulation_.physics.wake(b);
        if (moves(second) && !first.awake) simulation_.physics.wake(a);
    }

    void push(std::span<BodyInField* const> bodies, const physics::FieldTime& time) override {
        for (BodyInField* body : bodies) receivers_.find(body->id)->own.in_call = body;
        for (const auto& [a, b] : pairs_) {
            const Entry& first = receivers_.all()[a];
            const Entry& second = receivers_.all()[b];
            if (first.own.in_call != nullptr || second.own.in_call != nullptr)
                push_pair(first, second, softening_m(a, b), time.h_s);
        }
        const Vec3d field_T(simulation_.description().forces.magnetic_field_T);
        for (BodyInField* body : bodies) {
            Entry& entry = *receivers_.find(body->id);
            const Vec3d moment = placed(entry).moment_Am2;
            const double stiffness_Nm = glm::length(moment) * glm::length(field_T);
            body->angular_impulse_Nms +=
                glm::cross(moment, field_T) *
                (time.h_s * stiff_share(stiffness_Nm, least_inertia(*body), time.h_s));
        }
        for (BodyInField* body : bodies) receivers_.find(body->id)->own.in_call = nullptr;
    }

    static double least_inertia(const BodyInField& body) {
        return std::min({body.inertia_kgm2.x, body.inertia_kgm2.y, body.inertia_kgm2.z});
    }

    /// What turns them and what pushes them across are stiff where they touch, and take one share: so the pair's impulses
    /// still sum to no angular momentum. What pulls them together is not: contacts hold it.
    void push_pair(const Entry& first, const Entry& second, double softening_m, double h) const {
        const Placed a_placed = placed(first);
        const Placed b_placed = placed(second);
        const Pull pull = pull_between(a_placed, b_placed, softening_m);
        double share = 1;
        double inverse_mass = 0;
        for (const Entry* entry : {&first, &second}) {
            if (entry->own.in_call == nullptr) continue;
            const BodyInField& body = *entry->own.in_call;
            inverse_mass += 1 / body.mass_kg;
            share = std::min(share, stiff_share(pull.torque_stiffness_Nm, least_inertia(body), h));
        }
        share = std::min(share, stiff_share(pull.stiffness_Npm, 1 / inverse_mass, h));
        const Vec3d apart = b_placed.at_m - a_placed.at_m;
        const Vec3d along = apart / std::max(glm::length(apart), 1e-12);
        const Vec3d pulling_N = along * glm::dot(along, pull.force_on_b_N);
        const Vec3d force_N = pulling_N + (pull.force_on_b_N - pulling_N) * share;
        if (BodyInField* a = first.own.in_call) {
            a->impulse_Ns -= force_N * h;
            a->angular_impulse_Nms += pull.torque_on_a_Nm * (h * share);
        }
        if (BodyInField* b = second.own.in_call) {
            b->impulse_Ns += force_N * h;
            b->angular_impulse_Nms += pull.torque_on_b_Nm * (h * share);
        }
    }

    std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< numbers of receivers
};

Callers callers_of_magnets(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("magnets", true)) return {};
    return entities_with<scene::Magnet>(simulation);
}

}  // namespace

EffectRow magnets() {
    return with_effect<Magnets>({.called_for_by = &callers_of_magnets});
}

}  // namespace plumbline::effects
