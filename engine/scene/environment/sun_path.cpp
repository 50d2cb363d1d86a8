#include "engine/scene/environment/sun_path.h"

#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kRadPerHour = glm::pi<double>() / 12;

/// The equator's sky: its pole, its highest point, and west.
struct SkyFrame {
    Vec3d pole;
    Vec3d highest;
    Vec3d west;
};

SkyFrame frame_of(const TimeDescription& place) {
    const double turn = place.north_rad;
    const Vec3d north{-portable_sin(turn), 0, -portable_cos(turn)};
    const Vec3d up{0, 1, 0};
    const double sine = portable_sin(place.latitude_rad);
    const double cosine = portable_cos(place.latitude_rad);
    return {.pole = cosine * north + sine * up,
            .highest = cosine * up - sine * north,
            .west = glm::cross(up, north)};
}

}  // namespace

Vec3f sky_pole(const TimeDescription& place) {
    return Vec3f(frame_of(place).pole);
}

Vec3d to_sun_at(const TimeDescription& place, double hour) {
    constexpr double kTilt_rad = radians_from_degrees(23.45);
    const double declination =
        kTilt_rad * portable_sin(2 * glm::pi<double>() * (284 + place.day_of_year) / 365);
    const double angle = kRadPerHour * (hour - 12);
    const SkyFrame sky = frame_of(place);
    return portable_sin(declination) * sky.pole +
           portable_cos(declination) *
               (portable_cos(angle) * sky.highest + portable_sin(angle) * sky.west);
}

double hour_of_sun(const TimeDescription& place, const Vec3f& to_sun) {
    const SkyFrame sky = frame_of(place);
    const Vec3d sun(to_sun);
    const double angle = portable_atan2(glm::dot(sun, sky.west), glm::dot(sun, sky.highest));
    const double hour = 12 + angle / kRadPerHour;
    return hour >= 24 ? hour - 24 : hour;
}

}  // namespace plumbline::scene
