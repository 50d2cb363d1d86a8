// Continuous collision of one body: it stops where it meets something on its way.
#pragma once

#include "engine/physics/collision/sweep/time_of_impact.h"
#include "engine/physics/world/body_record.h"

namespace plumbline::physics {

class StepWorld;

/// Whether the body moved or turned so far since record.before that it may have passed something unseen: by more
/// than its inner radius.
bool moves_past_itself(const BodyRecord& record);

/// The first impact on the body's path since record.before. Bodies of the group are passed through.
Impact first_impact(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group);

/// On an impact the body stops there and keeps its velocity, so that the next step's contact bounces it as it
/// should. Whether there was one.
bool stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s);
/// Puts the body where it was after this share of its displacement since record.before.
void stop_at_share(BodyRecord& record, Real share);

}  // namespace plumbline::physics
