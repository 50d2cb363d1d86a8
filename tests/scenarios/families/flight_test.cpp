// Bodies that nothing touches: thrown ones (A01) and tops (A05, A06, H78, the peers' T-handle).
#include "tests/scenarios/families/rig.h"

#include <functional>

namespace plumbline::physics {
namespace {

TEST(Flight, A01ThrownBodiesFollowTheParabola) {
    for (const int hz : {30, 60, 240}) {
        Rig rig(balanced(hz));
        rig.floor();
        const BodyId ball = rig.ball({0, 0.5, 0}, 0.1, {.velocity_mps = {3, 10, 0}});
        const BodyId fallen = rig.box({5, 25, 0}, {1, 1, 1});
        double off_m = 0;
        for (int i = 1; i <= 2 * hz; ++i) {
            rig.world.step();
            const double t = static_cast<double>(i) / hz;
            const Vec3d expected{3 * t, 0.5 + 10 * t - 0.5 * kG * t * t, 0};
            off_m = std::max(off_m, glm::distance(rig.at(ball), expected));
            off_m = std::max(off_m, std::abs(rig.at(fallen).y - (25 - 0.5 * kG * t * t)));
        }
        expect_at_most(fmt::format("A01 projectile {} Hz", hz), off_m / 20, kDouble ? 1e-13 : 2e-7);
    }
}

/// Orientation and body-frame spin of a free body, by fourth-order Runge-Kutta.
struct FreeBody {
    Quatd turn;
    Vec3d spin;  ///< body axes
};
FreeBody turned_for(FreeBody body, const Vec3d& inertia, double seconds) {
    constexpr double kStep_s = 1e-4;
    const auto rate = [&](const FreeBody& at) {
        const Vec3d& w = at.spin;
        return FreeBody{at.turn * Quatd(0, w.x, w.y, w.z) * 0.5,
                        Vec3d{(inertia.y - inertia.z) * w.y * w.z / inertia.x,
                              (inertia.z - inertia.x) * w.z * w.x / inertia.y,
                              (inertia.x - inertia.y) * w.x * w.y / inertia.z}};
    };
    const auto ahead = [](const FreeBody& at, const FreeBody& by, double h) {
        return FreeBody{at.turn + by.turn * h, at.spin + by.spin * h};
    };
    const int steps = static_cast<int>(seconds / kStep_s + 0.5);
    for (int i = 0; i < steps; ++i) {
        const FreeBody a = rate(body);
        const FreeBody b = rate(ahead(body, a, kStep_s / 2));
        const FreeBody c = rate(ahead(body, b, kStep_s / 2));
        const FreeBody d = rate(ahead(body, c, kStep_s));
        body = ahead(body, a, kStep_s / 6);
        body = ahead(body, b, kStep_s / 3);
        body = ahead(body, c, kStep_s / 3);
        body = ahead(body, d, kStep_s / 6);
        body.turn = glm::normalize(body.turn);
    }
    return body;
}

double angle_between(const Quatd& a, const Quatd& b) {
    const Quatd between = glm::conjugate(a) * b;
    return 2 * std::asin(std::min(1.0, glm::length(Vec3d{between.x, between.y, between.z})));
}

Vec3d body_spin(const Rig& rig, BodyId id) {
    return glm::conjugate(rig.turn(id)) * rig.spin(id);
}

/// A top in a world without gravity; in an island of its own, or one that others could push.
struct Top {
    Rig rig;
    BodyId body;
    Vec3d inertia;

    /// `in_island`: a spring without strength ties it to another body.
    Top(const WorldDef& def, const ShapeDef& shape, BodyDef body_def, bool in_island)
        : rig(afloat(def)) {
        body_def.kind = BodyKind::Dynamic;
        body_def.can_sleep = false;
        body = rig.add(shape, {0, 0, 0}, body_def);
        inertia = Vec3d{rig.world.mass_properties(body).inertia_kgm2};
        if (!in_island) return;
        const BodyId other = rig.ball({5, 0, 0}, 0.1);
        rig.join({.kind = JointKind::Spring,
                  .a = body,
                  .b = other,
                  .anchor_a_world = {0, 0, 0},
                  .anchor_b_world = {5, 0, 0}});
    }

    struct Drift {
        double energy{0};    ///< most, relative
        double momentum{0};  ///< most, relative, direction included
    };
    Drift run_for(double seconds) {
        const double start_J = rig.world.energy().kinetic_J;
        const Vec3d start = rig.world.angular_momentum_kgm2ps();
        Drift drift;
        const int steps = steps_of(rig.world.def(), seconds);
        for (int i = 0; i < steps; ++i) {
            rig.world.step();
            const double now_J = rig.world.energy().kinetic_J;
            const Vec3d now = rig.world.angular_momentum_kgm2ps();
            drift.energy = std::max(drift.energy, std::abs(now_J / start_J - 1));
            drift.momentum =
                std::max(drift.momentum, glm::distance(now, start) / glm::length(start));
        }
        return drift;
    }
};

struct Place {
    std::string name;
    WorldDef def;
    bool in_island;
};
/// A free body has no sub-steps: every S is asked where it has company.
std::vector<Place> places() {
    std::vector<Place> all{{"alone", balanced(), false}};
    for (const Setting& setting : every_s()) all.push_back({setting.name, setting.def, true});
    return all;
}

TEST(Tops, A05ABoxOfThreeLengthsFlipsOnTime) {
    const double flips_s[] = {2.76718, 9.21780, 15.66843};
    for (const Place& place : places()) {
        Top top(place.def,
                BoxShape{.size_m = {1, 2, 3}},
                {.angular_velocity_radps = vec(0.01, 5, 0.01)},
                place.in_island);
        std::vector<double> found_s;
        double before = 5;
        double spin_off = 0;
        for (int i = 1; i <= 60 * 17; ++i) {
            top.rig.world.step();
            const Vec3d spin = body_spin(top.rig, top.body);
            if (spin.y * before < 0) found_s.push_back((i - spin.y / (spin.y - before)) / 60);
            before = spin.y;
            if (i == 600) spin_off = glm::distance(spin, Vec3d{1.035165, 4.771933, -1.292900}) / 5;
        }
        ASSERT_EQ(found_s.size(), 3U) << place.name;
        double off_s = 0;
        for (std::size_t i = 0; i < 3; ++i)
            off_s = std::max(off_s, std::abs(found_s[i] - flips_s[i]));
        expect_at_most("A05 flip time s " + place.name, off_s, 0.02);
        expect_at_most("A05 spin at 10 s " + place.name, spin_off, 0.01);
        const Top::Drift drift = Top(place.def,
                                     BoxShape{.size_m = {1, 2, 3}},
                                     {.angular_velocity_radps = vec(0.01, 5, 0.01)},
                                     place.in_island)
                                     .run_for(60);
        expect_at_most("A05 energy 60 s " + place.name, drift.energy, 1e-3);
        expect_at_most("A05 momentum 60 s " + place.name, drift.momentum, 1e-4);
    }
}

TEST(Tops, A06ADiscPrecessesAboutItsMomentum) {
    const double tilt = 20 * kPiD / 180;
    for (const Place& place : places()) {
        Top top(place.def,
                CylinderShape{.radius_m = 0.5_r, .height_m = 0.1_r},
                {.angular_velocity_radps = vec(30 * std::sin(tilt), 30 * std::cos(tilt), 0)},
                place.in_island);
        const double across = top.inertia.x;
        const Vec3d momentum = top.rig.world.angular_momentum_kgm2ps();
        const Vec3d up = glm::normalize(momentum);
        const double rate = glm::length(momentum) / across;
        const auto axis = [&] { return top.rig.turn(top.body) * Vec3d{0, 1, 0}; };
        const Vec3d side = glm::normalize(axis() - up * glm::dot(axis(), up));
        const Vec3d ahead = glm::cross(up, side);
        const double cone = std::acos(glm::dot(axis(), up));
        double phase = 0;
        double cone_off = 0;
        for (int i = 0; i < 3600; ++i) {
            top.rig.world.step();
            const Vec3d now = axis();
            const double angle = std::atan2(glm::dot(now, ahead), glm::dot(now, side));
            phase += std::remainder(angle - phase - rate / 60, 2 * kPiD) + rate / 60;
            cone_off =
                std::max(cone_off, std::abs(std::acos(std::min(1.0, glm::dot(now, up))) - cone));
        }
        expect_at_most(
            "A06 precession rate " + place.name, std::abs(phase / (rate * 60) - 1), 1e-3);
        expect_at_most("A06 cone drift rad " + place.name, cone_off, 1e-3);
        Top again(place.def,
                  CylinderShape{.radius_m = 0.5_r, .height_m = 0.1_r},
                  {.angular_velocity_radps = vec(30 * std::sin(tilt), 30 * std::cos(tilt), 0)},
                  place.in_island);
        const Top::Drift drift = again.run_for(60);
        expect_at_most("A06 energy 60 s " + place.name, drift.energy, 1e-3);
        expect_at_most("A06 momentum 60 s " + place.name, drift.momentum, 1e-4);
    }
}

TEST(Tops, ATHandleTumblesAsTheIntegralSays) {
    const Vec3d inertia{1.5619047619047626, 3.573333333333334, 4.761904761904763};
    const Vec3 spin = vec(0.01, 5, 0.01);
    const BodyDef handle{
        .mass_kg = 56, .inertia_kgm2 = Vec3(inertia), .angular_velocity_radps = spin};
    const FreeBody expected = turned_for({Quatd(1, 0, 0, 0), Vec3d(spin)}, inertia, 10);
    for (const Place& place : places()) {
        Top top(place.def, BoxShape{.size_m = vec(1, 0.6, 0.2)}, handle, place.in_island);
        const Top::Drift first = top.run_for(10);
        expect_at_most("T-handle orientation at 10 s deg " + place.name,
                       degrees(angle_between(top.rig.turn(top.body), expected.turn)),
                       2);
        const Top::Drift rest = top.run_for(50);
        expect_at_most("T-handle energy 60 s " + place.name, first.energy + rest.energy, 1e-3);
        expect_at_most(
            "T-handle momentum 60 s " + place.name, first.momentum + rest.momentum, 1e-3);
    }
}

TEST(Tops, H78SpinningBodiesGainNothing) {
    struct Case {
        std::string name;
        ShapeDef shape;
        Vec3 spin;
    };
    const Case cases[] = {{"T-shape", BoxShape{.size_m = vec(1, 0.6, 0.2)}, vec(10, 1, 0)},
                          {"rod", BoxShape{.size_m = vec(0.05, 1, 0.05)}, vec(5, 500, 0)}};
    for (const Case& one : cases) {
        for (const Place& place : places()) {
            Top top(place.def, one.shape, {.angular_velocity_radps = one.spin}, place.in_island);
            const Top::Drift drift = top.run_for(10);
            const std::string row = fmt::format("H78 {} {} ", one.name, place.name);
            expect_at_most(row + "energy 10 s", drift.energy, 1e-3);
            expect_at_most(row + "momentum 10 s", drift.momentum, 0.02);
        }
    }
}

}  // namespace
}  // namespace plumbline::physics
