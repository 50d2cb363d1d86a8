// Bodies that nothing touches: thrown ones (A01) and tops (A05, A06, H78, the peers' T-handle).
#include "engine/study/scenarios/families/flight.h"

#include "engine/study/angle_between.h"
#include "engine/study/scenarios/families/tops.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

TEST(Flight, A01ThrownBodiesFollowTheParabola) {
    for (const int hz : {30, 60, 240}) {
        ThrownBall thrown(balanced(hz));
        // Neither company nor a floor out of reach makes a difference.
        thrown.world.fixed_box({0, -2, 0}, {200, 2, 200});
        const BodyId fallen = thrown.world.box({5, 25, 0}, {1, 1, 1});
        double off_m = 0;
        for (int i = 1; i <= 2 * hz; ++i) {
            thrown.world.physics.step();
            const double t = static_cast<double>(i) / hz;
            off_m = std::max(off_m, glm::length(thrown.off_m(t)));
            const Vec3d expected = thrown_m({5, 25, 0}, {0, 0, 0}, t);
            off_m = std::max(off_m, glm::distance(thrown.world.at(fallen), expected));
        }
        expect_at_most(fmt::format("A01 projectile {} Hz", hz), off_m / 20, kDouble ? 1e-13 : 2e-7);
    }
}

struct Place {
    std::string name;
    Setting setting;
    Company company;
};
/// A free body has no sub-steps: every S is asked where it has company.
std::vector<Place> places() {
    std::vector<Place> all{{"alone", balanced(), Company::None}};
    for (const Setting& setting : every_s())
        all.push_back({name_of(setting), setting, Company::Tied});
    return all;
}

ConservedErrors conserved_errors_of(FreeBody& body, double seconds) {
    Stepper stepper(Stepper::Mode::Errors, {});
    return conserved_errors(body.world, seconds, stepper);
}

TEST(Tops, A05ABoxOfThreeLengthsFlipsOnTime) {
    const double flips_s[] = {2.76718, 9.21780, 15.66843};
    for (const Place& place : places()) {
        FreeBody top(place.setting, box_of_three_lengths(), place.company);
        std::vector<double> found_s;
        double before = 5;
        double spin_off = 0;
        for (int i = 1; i <= 60 * 17; ++i) {
            top.world.physics.step();
            const Vec3d spin = top.now().own_spin_radps;
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
        FreeBody again(place.setting, box_of_three_lengths(), place.company);
        const ConservedErrors drift = conserved_errors_of(again, 60);
        expect_at_most("A05 energy 60 s " + place.name, drift.energy, 1e-3);
        expect_at_most("A05 momentum 60 s " + place.name, drift.momentum, 1e-4);
    }
}

TEST(Tops, A06ADiscPrecessesAboutItsMomentum) {
    const Precession expected = disc_precession();
    const Vec3d up = expected.about();
    const Vec3d side = glm::normalize(expected.start - up * glm::dot(expected.start, up));
    const Vec3d ahead = glm::cross(up, side);
    for (const Place& place : places()) {
        FreeBody top(place.setting, wobbling_disc(), place.company);
        const double rate = expected.rate_radps;
        double phase = 0;
        double cone_off = 0;
        for (int i = 0; i < 3600; ++i) {
            top.world.physics.step();
            const Vec3d now = top.axis();
            const double angle = std::atan2(glm::dot(now, ahead), glm::dot(now, side));
            phase += std::remainder(angle - phase - rate / 60, 2 * kPi_d) + rate / 60;
            const double cone_rad = std::acos(std::min(1.0, glm::dot(now, up)));
            cone_off = std::max(cone_off, std::abs(cone_rad - expected.cone_rad()));
        }
        expect_at_most(
            "A06 precession rate " + place.name, std::abs(phase / (rate * 60) - 1), 1e-3);
        expect_at_most("A06 cone drift rad " + place.name, cone_off, 1e-3);
        FreeBody again(place.setting, wobbling_disc(), place.company);
        const ConservedErrors drift = conserved_errors_of(again, 60);
        expect_at_most("A06 energy 60 s " + place.name, drift.energy, 1e-3);
        expect_at_most("A06 momentum 60 s " + place.name, drift.momentum, 1e-4);
    }
}

TEST(Tops, ATHandleTumblesAsTheIntegralSays) {
    const FreeBodyDef def = t_handle();
    const TurningBody expected =
        turned_for({.own_spin_radps = def.spin_radps}, *def.inertia_kgm2, 10);
    for (const Place& place : places()) {
        FreeBody top(place.setting, def, place.company);
        const ConservedErrors first = conserved_errors_of(top, 10);
        expect_at_most("T-handle orientation at 10 s deg " + place.name,
                       degrees(angle_between_rad(top.now().turn, expected.turn)),
                       2);
        const ConservedErrors rest = conserved_errors_of(top, 50);
        expect_at_most("T-handle energy 60 s " + place.name, first.energy + rest.energy, 1e-3);
        expect_at_most(
            "T-handle momentum 60 s " + place.name, first.momentum + rest.momentum, 1e-3);
    }
}

TEST(Tops, H78SpinningBodiesGainNothing) {
    struct Case {
        std::string name;
        FreeBodyDef def;
    };
    const Case cases[] = {
        {"T-shape",
         {.shape = physics::BoxShape{.size_m = vec(1, 0.6, 0.2)}, .spin_radps = {10, 1, 0}}},
        {"rod",
         {.shape = physics::BoxShape{.size_m = vec(0.05, 1, 0.05)}, .spin_radps = {5, 500, 0}}}};
    for (const Case& one : cases) {
        for (const Place& place : places()) {
            FreeBody top(place.setting, one.def, place.company);
            const ConservedErrors drift = conserved_errors_of(top, 10);
            const std::string row = fmt::format("H78 {} {} ", one.name, place.name);
            expect_at_most(row + "energy 10 s", drift.energy, 1e-3);
            expect_at_most(row + "momentum 10 s", drift.momentum, 0.02);
        }
    }
}

}  // namespace
}  // namespace plumbline::study
