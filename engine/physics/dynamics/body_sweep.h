// Continuous collision of one body: it stops where it meets something on its way.
#pragma once

#include "engine/physics/collision/sweep/time_of_impact.h"
#include "engine/physics/world/body_record.h"

namespace plumbline::physics {

class StepWorld;

/// Whether the body moved or turned so far since record.before that it may have passed something unseen: by more
/// than its inner radius.
bool moves_past_itself(const BodyRecord& record);

/// The overlap from which on something crosses the body, m; infinite: it is not swept.
double crossing_of(const BodyRecord& record);
/// The change of speed by the step's forces; contacts bear them where there are any.
Vec3 gain_mps2(const BodyRecord& record);

/// From when on the rest of a step is looked at, and how bodies turn in it.
struct Outlook {
    double now{0};  ///< a share of the step
    double step_s{1.0 / 60.0};
    bool gyroscopic_torque{true};
};
/// Whether in what is left of the step, at the velocities and under the forces of now, the body moves farther than
/// contact points are looked for ahead of it.
bool outruns_points(const BodyRecord& record, const Outlook& outlook);

/// Nearer than that the two touch: beyond the distance at which an impact is found. Infinite: neither is swept.
double touching_m(const BodyRecord& a, const BodyRecord& b);
/// Whether the pair's points, as the step found them last, have one where the bodies touch.
bool touch(const Pair& pair);
/// Whether the body touches nothing.
bool flies(const BodyRecord& record);

/// The first impact on the body's path since record.before. Bodies of the group are passed through.
Impact first_impact(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group);

/// On an impact the body stops there and keeps its velocity, so that the next step's contact bounces it as it
/// should. Whether there was one.
bool stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s);
/// Puts the body where it was after this share of its displacement since record.before.
void stop_at_share(BodyRecord& record, Real share);

}  // namespace plumbline::physics
