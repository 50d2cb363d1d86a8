// A strip of cloth that hangs or falls, for tests.
#pragma once

#include "engine/physics/sheet.h"

#include <algorithm>
#include <cstdint>

namespace plumbline::physics {

inline constexpr Vec3d kDown_mps2{0, -9.81, 0};
inline constexpr double kSheetStep_s = 1.0 / 60;

inline void run_sheet(Sheet& sheet,
                      int steps,
                      const Vec3d& gravity_mps2,
                      std::uint32_t most = 1000) {
    for (int i = 0; i < steps; ++i) {
        const std::uint32_t count = sheet.plan(kSheetStep_s, most);
        for (std::uint32_t k = 0; k < count; ++k) {
            sheet.accelerate(gravity_mps2);
            sheet.move(sheet.substep_s());
        }
    }
}

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
