// The wind's field: what it averages to, how it travels, and that air neither piles up nor thins out.
#include "engine/scene/environment/wind_field.h"

#include "tests/support/near.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

const WindDescription kWind{
    .direction = {0.8_r, 0, 0.6_r}, .speed_mps = 4, .gusts = 0.5_r, .gust_size_m = 8};

TEST(WindField, TheMeanOfGustsIsTheMeanWind) {
    const Vec3 place{3, 1, -2};
    Vec3d sum{0};
    constexpr int kSamples = 40'000;
    for (int i = 0; i < kSamples; ++i) sum += Vec3d(wind_at(kWind, place, 0.05 * i));
    EXPECT_TRUE(test::near(sum / double{kSamples}, Vec3d{3.2, 0.0, 2.4}, 0.01));
}

TEST(WindField, GustsReachWhatTheSceneSaysAndNoMore) {
    Real strongest = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 gust = wind_at(kWind, {0, 0, 0}, 0.1 * i) - kWind.direction * kWind.speed_mps;
        strongest = std::max(strongest, glm::length(gust));
        EXPECT_EQ(gust.y, Real{0});
    }
    EXPECT_LE(strongest, Real{2} * 1.0001_r) << "half of 4 m/s";
    EXPECT_GT(strongest, 1.2_r);
}

TEST(WindField, TheMeanCarriesGustsAlong) {
    const Vec3 place{1, 0, 5};
    const Vec3 later_place = place + kWind.direction * (kWind.speed_mps * 2.5_r);
    EXPECT_TRUE(test::near(wind_at(kWind, later_place, 12.5), wind_at(kWind, place, 10.0), 1e-3));
}

TEST(WindField, HasNoDivergence) {
    constexpr Real kWay_m = 0.02_r;
    for (int i = 0; i < 50; ++i) {
        const Vec3 place{0.37_r * static_cast<Real>(i), 0, -0.81_r * static_cast<Real>(i)};
        const auto along = [&](const Vec3& axis) {
            return glm::dot(wind_at(kWind, place + axis * kWay_m, 3.0) -
                                wind_at(kWind, place - axis * kWay_m, 3.0),
                            axis) /
                   (2 * kWay_m);
        };
        EXPECT_NEAR(along({1, 0, 0}) + along({0, 0, 1}), 0.0, 2e-3) << i;
    }
}

TEST(WindField, WithoutGustsItIsTheSameEverywhere) {
    WindDescription still = kWind;
    still.gusts = 0;
    EXPECT_TRUE(test::near(wind_at(still, {50, 2, -7}, 99.0), Vec3{3.2_r, 0, 2.4_r}, 1e-5));
}

}  // namespace
}  // namespace plumbline::scene
