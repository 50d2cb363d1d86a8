#include "engine/physics/fracture/bond_stress.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

double twisted_Pa(const FractureBond& bond, const Vec3d& turn, bool is_whole) {
    if (is_whole) return std::abs(glm::dot(bond.normal, bond.second_m4 * turn)) / bond.torsion_m3;
    double farthest_m = 0;
    for (const Vec3d& corner : bond.corners_m)
        farthest_m = std::max(farthest_m, glm::distance(corner, bond.center_m));
    return std::abs(glm::dot(bond.normal, turn)) * farthest_m;
}

double principal_of(double pulled_Pa, double sheared_Pa) {
    return pulled_Pa / 2 + std::sqrt(pulled_Pa * pulled_Pa / 4 + sheared_Pa * sheared_Pa);
}

}  // namespace

double principal_Pa(const FractureBond& bond,
                    const Vec3d& mean_Pa,
                    const Vec3d& turn,
                    bool is_whole) {
    const double pulled_Pa = glm::dot(mean_Pa, bond.normal);
    const double sheared_Pa = glm::length(mean_Pa - pulled_Pa * bond.normal);
    const double twist_Pa = twisted_Pa(bond, turn, is_whole);
    double rim_Pa = pulled_Pa;
    for (const Vec3d& corner : bond.corners_m) {
        const Vec3d bent_Pa = glm::cross(turn, corner - bond.center_m);
        rim_Pa = std::max(rim_Pa, pulled_Pa + glm::dot(bent_Pa, bond.normal));
    }
    return std::max(principal_of(rim_Pa, twist_Pa), principal_of(pulled_Pa, sheared_Pa + twist_Pa));
}

}  // namespace plumbline::physics
