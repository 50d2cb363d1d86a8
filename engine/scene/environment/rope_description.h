// What a scene file says of a rope, as plain data in SI units.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// `[[rope]]`.
struct RopeDescription {
    std::string name;
    std::string a;             ///< "world" or an entity
    std::string b;             ///< the same; empty: a free end
    Vec3 anchor_a_m{0, 0, 0};  ///< world, at the start
    Vec3 anchor_b_m{0, 0, 0};  ///< of a free end: where it is at the start
    std::vector<Vec3>
        path_m;  ///< from a to b at the start; empty: straight, or hanging where it is longer
    double length_m{0};   ///< unstretched
    double damping_s{0};  ///< of the material
    double radius_m{0.01};
    double mass_kg{0.1};
    double stiffness_N{0};  ///< E A; 0: does not stretch
    double bend_Nm2{0};     ///< E I
    double friction{0.5};
    double break_N{0};            ///< 0: never
    std::optional<int> pieces{};  ///< none: by fidelity
    std::string material;         ///< what it looks like
    SourceLocation location{};
};

/// From the first point to the last along all of them.
template <class T>
double length_of(const std::vector<glm::vec<3, T>>& path_m) {
    double sum_m = 0;
    for (std::size_t i = 1; i < path_m.size(); ++i)
        sum_m += glm::distance(Vec3d(path_m[i - 1]), Vec3d(path_m[i]));
    return sum_m;
}

}  // namespace plumbline::scene
