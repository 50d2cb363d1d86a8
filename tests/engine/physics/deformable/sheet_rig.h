// A strip of cloth that hangs or falls, for tests.
#pragma once

#include "engine/physics/sheet.h"
#include "tests/engine/physics/deformable/point_rig.h"

#include <algorithm>
#include <cstdint>

namespace plumbline::physics {

inline constexpr Vec3d kDown_mps2{0, -9.81, 0};

inline SheetDef strip(std::uint32_t cells, double stretch_Npm) {
    return {.size_m = {0.2, 1},
            .cells = {std::max(2U, cells / 5), cells},
            .stretch_Npm = stretch_Npm,
            .shear_Npm = stretch_Npm / 3,
            .damping_s = 0.02};
}

inline void pin_top(Sheet& sheet) {
    for (std::uint32_t i = 0; i < sheet.columns(); ++i) sheet.pin(i);
}

}  // namespace plumbline::physics
