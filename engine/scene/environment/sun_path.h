// Where the sun stands at an hour of the day, and what hour it is by where it stands.
#pragma once

#include "engine/core/math.h"
#include "engine/scene/scene_description.h"

namespace plumbline::scene {

/// Unit; the point of the sky about which all seems to turn: the celestial north pole.
Vec3f sky_pole(const TimeDescription& place);

/// Unit, towards the sun. `hour` is solar time: at 12 the sun stands highest. Its declination is that
/// of the day of the year (Cooper, "The Absorption of Radiation in Solar Stills", Solar Energy 12,
/// 1969, equation 2; good to a degree and a half).
Vec3d to_sun_at(const TimeDescription& place, double hour);

/// From 0 to 24; the inverse of to_sun_at().
double hour_of_sun(const TimeDescription& place, const Vec3f& to_sun);

}  // namespace plumbline::scene
