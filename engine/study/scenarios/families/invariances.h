// Scenes that must end the same in whatever frame they are built.
#pragma once

#include "engine/study/scenarios/world/framed_world.h"

#include <span>

namespace plumbline::study {

/// A scene and the one place that it ends at, with the length that counts as 1.
struct FramedScene {
    const char* name;
    double scale_m;
    Vec3d (*end_m)(const Frame& frame, Stepper& stepper);
};
/// A sliding box, a pendulum, a bounce, a ball that comes to roll and a tower of five.
std::span<const FramedScene> framed_scenes();

/// A40: 23 turns of the world, gravity with it.
std::vector<Frame> turned_frames();
/// A42: along a direction askew to all axes.
Frame drifting_frame(double speed_mps);
/// A41.
Frame far_frame(double distance_m);

/// A44: an elastic ball flies about in a smooth room for so long, then its velocity is turned round:
/// how far from its start it is after as long again.
double back_in_time_m(double seconds, Stepper& stepper);

}  // namespace plumbline::study
