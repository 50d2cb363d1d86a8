// What bodies will do in the rest of a step if nothing meets them, and what meets first.
#pragma once

#include "engine/physics/dynamics/body_sweep.h"

#include <span>
#include <unordered_map>
#include <vector>

namespace plumbline::physics {

/// Whether an impact of the two can be solved within the step: no joint holds the other, and once the step has begun
/// they are of one island, if both can be pushed.
bool may_meet(const BodyRecord& record, const BodyRecord& other, const Outlook& outlook);

/// What a body will meet first, and when, if nobody's velocity changes before.
struct PredictedImpact {
    double share{1};             ///< of the step: until then it meets nothing
    BodyRecord* other{nullptr};  ///< none: and nothing is known of what comes then
};

/// Each body's path is worked out once. Impacts are of what is left of the step, or of as much of it as gyroscopic torque lets
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
        double until{0};  ///< up to which share the path tells; 0: it is not known yet
        bool is_compared{false};
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

}  // namespace plumbline::physics
