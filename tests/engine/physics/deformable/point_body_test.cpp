// What all deforming bodies share: forces become motion, pinned points go where they are led, sums are right.
#include "engine/physics/point_body.h"

#include "engine/core/io/archive.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace plumbline::physics {
namespace {

/// Three points that nothing ties together.
class Dust final : public PointBody {
public:
    Dust() {
        add_point({0, 0, 0}, 1);
        add_point({1, 0, 0}, 2);
        add_point({0, 2, 0}, 3);
    }
    std::uint32_t plan(double seconds, std::uint32_t) override {
        substep_s_ = seconds;
        return 1;
    }
    std::vector<SurfacePlace> places(std::uint32_t) const override { return {}; }
    double longest_side_m() const override { return 1; }

private:
    void add_forces() override { impulses_Ns_[1] += Vec3d{6, 0, 0} * substep_s_; }
    double elastic_J() const override { return 7; }
};

TEST(PointBody, ForcesBecomeMotion) {
    Dust dust;
    EXPECT_EQ(dust.plan(0.5, 9), 1U);
    dust.accelerate({0, -10, 0});
    dust.move(dust.substep_s());
    EXPECT_EQ(dust.velocities_mps()[0], (Vec3d{0, -5, 0}));
    EXPECT_EQ(dust.velocities_mps()[1], (Vec3d{1.5, -5, 0}));
    EXPECT_EQ(dust.positions_m()[2], (Vec3d{0, -0.5, 0}));
    const PointTotals sum = dust.totals();
    EXPECT_EQ(sum.momentum_kgmps, (Vec3d{3, -30, 0}));
    EXPECT_NEAR(sum.kinetic_J, 0.5 * (6 * 25 + 2 * 2.25), 1e-12);
    EXPECT_EQ(sum.elastic_J, 7);
    EXPECT_NEAR(sum.moment_kgm.y, -2.5 * 3 + 3 * -0.5, 1e-12);
    EXPECT_NEAR(dust.mass_kg(), 6, 1e-12);
    slow_down(dust, 0);
    EXPECT_EQ(dust.totals().kinetic_J, 0);
}

TEST(PointBody, PinnedPointsGoWhereTheyAreLed) {
    Dust dust;
    dust.pin(1);
    EXPECT_EQ(dust.inverse_mass(1), 0);
    dust.plan(0.5, 9);
    lead(dust, 1, {0, 2, 0});
    dust.accelerate({0, -10, 0});
    dust.change_velocity(0, {0, 5, 0});
    dust.move(dust.substep_s());
    EXPECT_EQ(dust.positions_m()[1], (Vec3d{1, 1, 0}));
    EXPECT_EQ(dust.positions_m()[0], (Vec3d{0, 0, 0}));
    EXPECT_EQ(dust.support_Ns(1), (Vec3d{3, -10, 0}));
    dust.unpin(1);
    EXPECT_EQ(dust.inverse_mass(1), 0.5);
}

TEST(PointBody, KnowsWhatIsNotSound) {
    Dust dust;
    EXPECT_TRUE(dust.is_sound());
    dust.change_velocity(0, {0, 2e4, 0});
    EXPECT_FALSE(dust.is_sound());
    const std::vector<Vec3d> places{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    dust.put_back(places);
    EXPECT_TRUE(dust.is_sound());
    EXPECT_EQ(dust.positions_m()[2], (Vec3d{3, 3, 3}));
    EXPECT_EQ(dust.totals().kinetic_J, 0);
    dust.change_velocity(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    EXPECT_FALSE(dust.is_sound());
}

TEST(PointBody, IsRestored) {
    Dust dust;
    dust.pin(2);
    dust.plan(0.5, 1);
    dust.accelerate({1, 2, 3});
    dust.move(dust.substep_s());
    Archive out;
    dust.serialize(out);
    const std::string bytes = out.take();
    Dust other;
    Archive in(bytes);
    other.serialize(in);
    EXPECT_FALSE(in.failed());
    EXPECT_EQ(other.inverse_mass(2), 0);
    EXPECT_EQ(other.positions_m()[0], dust.positions_m()[0]);
    EXPECT_EQ(other.velocities_mps()[1], dust.velocities_mps()[1]);
}

}  // namespace
}  // namespace plumbline::physics
