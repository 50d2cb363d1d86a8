// How hard a bond is pulled by the springs in it.
#pragma once

#include "engine/physics/fracture.h"

namespace plumbline::physics {

/// Pa, tension positive: the larger of what bends and twists at the rim, and what pulls and shears in the middle, as the principal
/// stress of the bond's own traction (Rankine). `mean_Pa`: mean traction; `turn`, Pa/m: how it changes across the bond, about its
/// centre. `is_whole`: the bond is all of a section, which warps by itself; else it slides with the rest.
double principal_Pa(const FractureBond& bond,
                    const Vec3d& mean_Pa,
                    const Vec3d& turn,
                    bool is_whole);

}  // namespace plumbline::physics
