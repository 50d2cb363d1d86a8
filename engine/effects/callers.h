// Naming who calls for an effect.
#pragma once

#include "engine/effects/effect_table.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::effects {

/// "[fog] (garden.toml:12)"; the name alone where it stands in no file.
std::string setting(std::string_view name, const SourceLocation& location);

/// Items of an array of tables, "[[rope]] line (yard.toml:12)"; none while the effect is called off.
template <class T>
Callers tables_of(const scene::Simulation& simulation,
                  std::string_view effect,
                  std::string_view key,
                  const std::vector<T>& items) {
    if (!simulation.switches.is_on(effect, true)) return {};
    Callers callers;
    for (const T& item : items)
        callers.push_back(setting("[[" + std::string(key) + "]] " + item.name, item.location));
    return callers;
}

/// Collects entities; names the first few.
class EntityCallers {
public:
    explicit EntityCallers(const scene::Simulation& simulation) : simulation_(simulation) {}
    void add(ecs::Entity entity);
    Callers take();

private:
    const scene::Simulation& simulation_;
    Callers callers_;
    std::size_t count_{0};
};

template <class Component>
Callers entities_with(const scene::Simulation& simulation) {
    EntityCallers callers(simulation);
    for (auto [entity, component] : simulation.registry.view<const Component>())
        callers.add(entity);
    return callers.take();
}

/// Entities with a dynamic body that is covered by a surface of that kind.
Callers dynamic_bodies_of(const scene::Simulation& simulation,
                          bool (*is_of_kind)(const scene::SurfaceTable&, std::uint16_t surface));

/// Entities that show a material of that kind.
Callers wearers_of(const scene::Simulation& simulation,
                   bool (*is_of_kind)(const assets::MaterialData&));

}  // namespace plumbline::effects
