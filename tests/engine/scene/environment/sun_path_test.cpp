// The sun's way over the sky.
#include "engine/scene/environment/sun_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kLatitude_deg = 48;
constexpr int kEquinox = 81;  // declination 0
constexpr int kSolstice = 172;

TimeDescription place(int day, double latitude_deg = kLatitude_deg) {
    return {.latitude_rad = radians_from_degrees(latitude_deg), .day_of_year = day};
}

double height_deg(const Vec3d& to_sun) {
    return degrees_from_radians(std::asin(to_sun.y));
}

TEST(SunPath, NoonIsAsHighAsLatitudeAndDeclinationSay) {
    EXPECT_NEAR(height_deg(to_sun_at(place(kEquinox), 12)), 90 - kLatitude_deg, 0.01);
    EXPECT_NEAR(height_deg(to_sun_at(place(kSolstice), 12)), 90 - kLatitude_deg + 23.45, 0.01);
    EXPECT_NEAR(height_deg(to_sun_at(place(kSolstice), 0)), kLatitude_deg + 23.45 - 90, 0.01);
}

TEST(SunPath, RisesInTheEastStandsInTheSouthAndSetsInTheWest) {
    // North is -Z, so east is +X and south +Z.
    const TimeDescription here = place(kEquinox);
    EXPECT_NEAR(glm::distance(to_sun_at(here, 6), Vec3d(1, 0, 0)), 0, 1e-9);
    EXPECT_NEAR(glm::distance(to_sun_at(here, 18), Vec3d(-1, 0, 0)), 0, 1e-9);
    EXPECT_GT(to_sun_at(here, 12).z, 0.7);
    // South of the equator it stands in the north at noon.
    EXPECT_LT(to_sun_at(place(kEquinox, -kLatitude_deg), 12).z, -0.7);
    EXPECT_NEAR(to_sun_at(place(kEquinox, -kLatitude_deg), 18).x, -1, 1e-9);
}

TEST(SunPath, NorthTurnsTheWholeSky) {
    TimeDescription here = place(kSolstice);
    const Vec3d before = to_sun_at(here, 9);
    here.north_rad = glm::pi<double>() / 2;  // north is -X
    const Vec3d after = to_sun_at(here, 9);
    EXPECT_NEAR(glm::distance(after, Vec3d(before.z, before.y, -before.x)), 0, 1e-9);
}

TEST(SunPath, HourAndSunAreEachOthersInverse) {
    for (const double latitude_deg : {-70.0, -35.0, 0.0, 48.0}) {
        const TimeDescription here = place(200, latitude_deg);
        for (double hour = 0; hour < 24; hour += 0.7) {
            EXPECT_NEAR(hour_of_sun(here, Vec3f(to_sun_at(here, hour))), hour, 1e-4);
        }
    }
}

TEST(SunPath, AnHourIsFifteenDegreesAboutThePole) {
    const TimeDescription here = place(120);
    const Vec3d pole(sky_pole(here));
    const Vec3d turned = glm::angleAxis(-glm::pi<double>() / 12, pole) * to_sun_at(here, 14);
    EXPECT_NEAR(glm::distance(turned, to_sun_at(here, 15)), 0, 1e-6);
    EXPECT_NEAR(pole.y, std::sin(radians_from_degrees(kLatitude_deg)), 1e-6);
}

}  // namespace
}  // namespace plumbline::scene
