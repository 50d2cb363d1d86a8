#include "engine/scene/build/collision_groups.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

constexpr std::size_t kGroupBits = 32;

physics::Material material_of(const BodyDescription& part, const Surface& surface) {
    return {.friction = part.friction.value_or(surface.friction),
            .restitution = part.restitution.value_or(surface.restitution),
            .rolling_m = part.rolling_friction,
            .spinning_m = part.spinning_friction,
            .friction_rule = part.friction_rule,
            .restitution_rule = part.restitution_rule};
}

}  // namespace

Result<std::uint32_t> CollisionGroups::bit(const std::string& name) {
    if (const auto known = bits_.find(name); known != bits_.end()) return known->second;
    if (bits_.size() >= kGroupBits) {
        return Error{fmt::format("group \"{}\" is one too many: there can be {} beside \"default\"",
                                 name,
                                 kGroupBits - 1),
                     ExitCode::Refused};
    }
    const std::uint32_t bit = 1U << bits_.size();
    bits_.emplace(name, bit);
    return bit;
}

Result<physics::CollisionFilter> CollisionGroups::filter_of(const BodyDescription& body) {
    if (!body.parts.empty()) {
        physics::CollisionFilter all{.group = 0, .collides_with = 0};
        for (const BodyDescription& part : body.parts) {
            const Result<physics::CollisionFilter> own = filter_of(part);
            if (!own) return own.error();
            all.group |= own->group;
            all.collides_with |= own->collides_with;
        }
        return all;
    }
    const Result<std::uint32_t> group = bit(body.group);
    if (!group) return group.error();
    std::uint32_t collides_with = body.collides_with.empty() ? ~0U : 0U;
    for (const std::string& name : body.collides_with) {
        const Result<std::uint32_t> other = bit(name);
        if (!other) return other.error();
        collides_with |= *other;
    }
    if (body.avoids_own_group) collides_with &= ~*group;
    return physics::CollisionFilter{.group = *group, .collides_with = collides_with};
}

Result<std::vector<physics::PartTraits>> CollisionGroups::parts_of(const BodyDescription& body,
                                                                   const Surface& surface) {
    std::vector<physics::PartTraits> parts;
    for (const BodyDescription& part : body.parts) {
        const Result<physics::CollisionFilter> filter = filter_of(part);
        if (!filter) return filter.error();
        parts.push_back({material_of(part, surface), *filter});
    }
    return parts;
}

}  // namespace plumbline::scene
