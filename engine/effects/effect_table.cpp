#include "engine/effects/effect_table.h"

#include <array>

namespace plumbline::effects {

std::span<const EffectRow> effect_table() {
#define PL_TAKE_ROW(name) name(),
    static const std::array kTable{PL_EFFECTS(PL_TAKE_ROW)};
#undef PL_TAKE_ROW
    return kTable;
}

}  // namespace plumbline::effects
