#include "engine/scene/accuracy.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <array>

namespace plumbline::scene {

void read_plaque(TableReader& table, PlaqueDescription& plaque) {
    plaque.title = read_short_text(table, "title");
    plaque.formula = read_short_text(table, "formula");
    plaque.of = read_short_text(table, "of");
    table.require("of", "the entity that is measured");
    plaque.from = read_short_text(table, "from");
    table.read_choice(
        "quantity",
        plaque.quantity,
        {"period_s", "height_m", "speed_mps", "distance_m", "lean_deg", "spin_degps"});
    table.require("quantity", "what is measured");
    table.read_choice("axis", plaque.axis, {"x", "y", "z"});
    table.read("expected", plaque.expected, {-1e9, 1e9, "a number from -1e9 to 1e9"});
    table.require("expected", "what the formula gives");
    plaque.effect = read_short_text(table, "effect");
    if (!plaque.effect.empty() &&
        std::ranges::find(effects_with_fidelity(), plaque.effect) == effects_with_fidelity().end())
        table.error("effect", "no effect with a fidelity is called \"{}\"", shown(plaque.effect));
    const bool is_between =
        plaque.quantity == PlaqueQuantity::Distance || plaque.quantity == PlaqueQuantity::Lean;
    if (is_between) table.require("from", "the entity that it is measured from");
}

void check_plaques(const SceneDescription& scene, LoadContext& context) {
    const auto has_plaque = [](const EntityDescription& e) { return e.plaque.has_value(); };
    if (std::ranges::none_of(scene.entities, has_plaque)) return;
    const SceneNames names(scene, context);
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const auto& plaque = scene.entities[i].plaque;
        if (!plaque) continue;
        for (const auto& [key, name] : {std::pair{"of", plaque->of}, {"from", plaque->from}}) {
            if (name.empty() || names.find(name)) continue;
            context.faults.error(context.entity_locations[i],
                                 fmt::format("entity[{}].plaque.{}", i, key),
                                 "no entity is called \"{}\"{}",
                                 shown(name),
                                 names.hint(name));
        }
    }
}

}  // namespace plumbline::scene
