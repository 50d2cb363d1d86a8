#include "engine/effects/effect_table.h"

#include <array>

namespace plumbline::effects {
namespace {

EffectRow named(std::string_view name, Domain domain, EffectRow row) {
    row.name = name;
    row.domain = domain;
    return row;
}

}  // namespace

std::span<const EffectRow> effect_table() {
#define PL_TAKE_ROW(name, domain) named(#name, Domain::domain, name()),
    static const std::array kTable{PL_EFFECTS(PL_TAKE_ROW)};
#undef PL_TAKE_ROW
    return kTable;
}

}  // namespace plumbline::effects
