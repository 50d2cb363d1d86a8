#include "engine/effects/callers.h"

#include "engine/scene/simulation/entity_lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::effects {
namespace {

/// Beyond this many, callers are counted, not named.
constexpr std::size_t kCallersNamed = 8;

}  // namespace

std::string setting(std::string_view name, const SourceLocation& location) {
    if (location.line <= 0) return std::string(name);
    return fmt::format("{} ({})", name, to_string(location));
}

void EntityCallers::add(ecs::Entity entity) {
    if (++count_ <= kCallersNamed) callers_.push_back(describe(simulation_, entity));
}

Callers EntityCallers::take() {
    if (count_ > kCallersNamed)
        callers_.push_back(fmt::format("and {} more", count_ - kCallersNamed));
    return std::move(callers_);
}

Callers dynamic_bodies_of(const scene::Simulation& simulation,
                          bool (*is_of_kind)(const scene::SurfaceTable&, std::uint16_t surface)) {
    EntityCallers callers(simulation);
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (moving.kind != physics::BodyKind::Dynamic) continue;
        if (!simulation.registry.alive(moving.entity)) continue;
        const auto surface = simulation.registry.get<scene::SurfaceRef>(moving.entity).surface;
        if (is_of_kind(simulation.surfaces(), surface)) callers.add(moving.entity);
    }
    return callers.take();
}

Callers wearers_of(const scene::Simulation& simulation,
                   bool (*is_of_kind)(const assets::MaterialData&)) {
    EntityCallers callers(simulation);
    for (auto [entity, visual] : simulation.registry.view<const scene::Visual>()) {
        const bool wears = std::ranges::any_of(visual.materials, [&](assets::MaterialId id) {
            return id.value != 0 && is_of_kind(simulation.library().material(id));
        });
        if (wears) callers.add(entity);
    }
    return callers.take();
}

}  // namespace plumbline::effects
