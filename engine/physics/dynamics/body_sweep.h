// Continuous collision: a body stops where it meets something on its way, and what it will meet is foreseen.
#pragma once

#include "engine/physics/collision/sweep/time_of_impact.h"
#include "engine/physics/world/body_record.h"

#include <span>
#include <unordered_map>
#include <vector>

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

/// Whether an impact of the two can be solved within the step: no joint holds the other, and once the step has begun
/// they are of one island, if both can be pushed.
bool may_meet(const BodyRecord& record, const BodyRecord& other, const Outlook& outlook);

/// What a body will meet first, and when, if nobody's velocity changes before.
struct PredictedImpact {
    double share{1};             ///< of the step: until then it meets nothing
    BodyRecord* other{nullptr};  ///< none: and nothing is known of what comes then
};

/// What bodies do in the rest of a step if nothing meets them, and what they meet first. Each body's path is worked out once. Impacts are of what is left of the step, or of as much of it as gyroscopic torque lets
/// say. Left out is what is no pair, what a body touches with several parts and what joints hold; and once the step has
/// begun the bodies of other islands. Bodies must not move, nor gain or lose points, while a forecast is in use.
class Forecast {
public:
    /// Forgets all.
    void begin(const Outlook& outlook);
    /// What the body meets first.
    PredictedImpact first_impact(const BodyRecord& record);
    /// When the first of the bodies that outrun their points meets something, 1: none does.
    double next_impact(std::span<BodyRecord* const> bodies);

private:
    struct Course {
        Vec3 gain_mps2{0, 0, 0};
        BodyPath path;
        Bounds swept;
        double until{0};          ///< up to which share the path tells; 0: it is not known yet
        bool is_compared{false};  ///< next_impact() has looked at all of its pairs
    };

    Course& course_of(const BodyRecord& record);
    const Course& on_path(const BodyRecord& record, double until);
    BodyPath predicted_path(const BodyRecord& record, const Course& course, double until) const;
    bool may_come_near(const BodyRecord& a, const BodyRecord& b);
    PredictedImpact first_impact(const BodyRecord& record, double latest, bool once_a_pair);

    Outlook outlook_{};
    std::unordered_map<const BodyRecord*, Course> bodies_;
    Course other_;  ///< of one whose path is asked for up to another share
};

/// What can be pushed, is a pair of one of the two that meet, and may be met in what is then left of the step, wherever the
/// impact leads.
std::vector<BodyRecord*> reached_after(const BodyRecord& record,
                                       const PredictedImpact& impact,
                                       const Outlook& outlook);

/// The first impact on the body's path since record.before. Bodies of the group are passed through.
Impact first_impact(const StepWorld& world, const BodyRecord& record, std::uint32_t unseen_group);

/// On an impact the body stops there and keeps its velocity, so that the next step's contact bounces it as it
/// should. Whether there was one.
bool stop_at_hit(const StepWorld& world, BodyRecord& record, Real duration_s);
/// Puts the body where it was after this share of its displacement since record.before.
void stop_at_share(BodyRecord& record, Real share);

}  // namespace plumbline::physics
