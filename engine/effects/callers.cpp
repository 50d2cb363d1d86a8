#include "engine/effects/callers.h"

#include <fmt/format.h>

namespace plumbline::effects {
namespace {

/// Beyond this many, callers are counted, not named.
constexpr std::size_t kCallersNamed = 8;

}  // namespace

std::string setting(std::string_view name, const scene::Origin& origin) {
    if (origin.line <= 0) return std::string(name);
    return fmt::format("{} ({})", name, scene::to_string(origin));
}

void EntityCallers::add(ecs::Entity entity) {
    if (++count_ <= kCallersNamed) callers_.push_back(simulation_.describe(entity));
}

Callers EntityCallers::take() {
    if (count_ > kCallersNamed)
        callers_.push_back(fmt::format("and {} more", count_ - kCallersNamed));
    return std::move(callers_);
}

}  // namespace plumbline::effects
