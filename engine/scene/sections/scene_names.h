// Entities by name, copies of arrays ("pile.3.0.7") included without making them.
#pragma once

#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

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

/// The key `to`, an entity with a body, in `to`; "world" and absent: empty.
void read_holder(TableReader& table, const SceneNames& names, std::string& to);

/// Names those of an array of tables that have none, "rope#1"; a name that is `taken` or an entity's is an error. `others`: "another rope or
/// entity".
template <class T>
void name_each(TableReader& root,
               std::string_view key,
               std::vector<T>& things,
               const SceneNames& names,
               std::set<std::string>& taken,
               std::string_view others) {
    const auto nodes = root.tables(key);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::string& name = things[i].name;
        if (name.empty()) name = fmt::format("{}#{}", key, i + 1);
        if (taken.insert(name).second && !names.find(name)) continue;
        root.item(key, nodes, i).error("name", "\"{}\" is the name of {}", shown(name), others);
    }
}

/// Every name that two things share is an error that gives both places; "world" is taken too.
void check_names(const SceneDescription& scene, LoadContext& context);
/// What plaques measure.
void check_plaques(const SceneDescription& scene, LoadContext& context);

}  // namespace plumbline::scene
