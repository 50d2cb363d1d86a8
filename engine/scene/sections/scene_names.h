// Entities by name, copies of arrays ("pile.3.0.7") included without making them.
#pragma once

#include "engine/scene/sections/scene_parts.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace plumbline::scene {

/// Looks at the scene and its places for as long as it lives.
class SceneNames {
public:
    SceneNames(const SceneDescription& scene, const LoadContext& context);

    struct Found {
        const EntityDescription* entity{nullptr};  ///< the prefab's for a copy
        Vec3 position_m{0, 0, 0};
    };
    std::optional<Found> find(std::string_view name) const;
    /// The nearest name of an entity or array, or empty.
    std::string nearest(std::string_view name) const;
    /// `; did you mean "crate"?`, or empty with nothing near.
    std::string hint(std::string_view name) const;
    /// Where a found name is given.
    SourceLocation location(std::string_view name) const;
    /// Where the array stands that a copy of that name belongs to.
    std::optional<SourceLocation> copy_location(std::string_view name) const;

private:
    /// The array and the three indices that a name like "pile.3.0.7" means.
    struct Copy {
        std::size_t array{0};
        std::array<int, 3> index{};
    };
    std::optional<Copy> copy_of(std::string_view name) const;

    const SceneDescription& scene_;
    const LoadContext& context_;
    std::unordered_map<std::string, std::size_t> entities_;
    std::unordered_map<std::string, std::size_t> arrays_;
};

/// A key that names an entity with a body, or the world.
struct NamedEnd {
    const EntityDescription* entity{nullptr};  ///< null: the world, or nothing good
    Vec3 position_m{0, 0, 0};
    bool good{false};
};
/// Leaves the name in `name`; `or_world`: it may be "world". Absent: nothing good.
NamedEnd read_named_end(TableReader& table,
                        std::string_view key,
                        const SceneNames& names,
                        std::string& name,
                        bool or_world);

/// Every name that two things share is an error that gives both places; "world" is taken too.
void check_names(const SceneDescription& scene, LoadContext& context);

}  // namespace plumbline::scene
