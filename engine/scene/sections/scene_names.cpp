#include "engine/scene/sections/scene_names.h"

#include "engine/core/text/nearest_name.h"

#include <fmt/format.h>

#include <charconv>

namespace plumbline::scene {

SceneNames::SceneNames(const SceneDescription& scene, const LoadContext& context)
    : scene_(scene), context_(context) {
    for (std::size_t i = 0; i < scene.entities.size(); ++i)
        entities_.emplace(scene.entities[i].name, i);
    for (std::size_t i = 0; i < scene.arrays.size(); ++i) arrays_.emplace(scene.arrays[i].name, i);
}

std::optional<SceneNames::Copy> SceneNames::copy_of(std::string_view name) const {
    Copy copy;
    for (std::size_t axis = 3; axis-- > 0;) {
        const std::size_t dot = name.rfind('.');
        if (dot == std::string_view::npos) return {};
        const std::string_view digits = name.substr(dot + 1);
        // "01" is not the name of copy 1.
        if (digits.empty() || (digits.size() > 1 && digits.front() == '0')) return {};
        const auto [end, fault] =
            std::from_chars(digits.data(), digits.data() + digits.size(), copy.index[axis]);
        if (fault != std::errc{} || end != digits.data() + digits.size()) return {};
        name = name.substr(0, dot);
    }
    const auto array = arrays_.find(std::string(name));
    if (array == arrays_.end()) return {};
    copy.array = array->second;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (copy.index[axis] < 0 || copy.index[axis] >= scene_.arrays[copy.array].count[axis])
            return {};
    }
    return copy;
}

std::optional<SceneNames::Found> SceneNames::find(std::string_view name) const {
    const auto entity = entities_.find(std::string(name));
    if (entity != entities_.end()) {
        const EntityDescription& found_entity = scene_.entities[entity->second];
        return Found{&found_entity, found_entity.world_from_body.position};
    }
    const auto copy = copy_of(name);
    if (!copy) return {};
    const ArrayDescription& array = scene_.arrays[copy->array];
    const Vec3 index{static_cast<Real>(copy->index[0]),
                     static_cast<Real>(copy->index[1]),
                     static_cast<Real>(copy->index[2])};
    return Found{&array.prefab, array.origin_m + index * array.spacing_m};
}

std::string SceneNames::nearest(std::string_view name) const {
    std::vector<std::string_view> known;
    for (const auto& entity : scene_.entities) known.push_back(entity.name);
    return std::string(nearest_name(name, known));
}

std::string SceneNames::hint(std::string_view name) const {
    const std::string near = nearest(name);
    return near.empty() ? near : fmt::format("; did you mean \"{}\"?", near);
}

SourceLocation SceneNames::location(std::string_view name) const {
    const auto entity = entities_.find(std::string(name));
    if (entity != entities_.end()) return context_.entity_locations[entity->second];
    return copy_location(name).value_or(SourceLocation{});
}

std::optional<SourceLocation> SceneNames::copy_location(std::string_view name) const {
    const auto copy = copy_of(name);
    if (!copy) return {};
    return context_.array_locations[copy->array];
}

void read_holder(TableReader& table, const SceneNames& names, std::string& to) {
    if (table.has("to")) read_named_end(table, "to", names, to, true);
    if (to == "world") to.clear();
}

void check_names(const SceneDescription& scene, LoadContext& context) {
    std::unordered_map<std::string, SourceLocation> taken;
    const auto take =
        [&](const std::string& name, const SourceLocation& location, std::string path) {
            if (name == "world") {
                context.faults.error(
                    location, path, "\"world\" means the world itself; use another name");
            }
            const auto [other, is_new] = taken.emplace(name, location);
            if (is_new) return;
            context.faults.error(location,
                                 std::move(path),
                                 "\"{}\" is the name of what stands at {} already",
                                 shown(name),
                                 to_string(other->second));
        };
    const SceneNames names(scene, context);
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        take(
            scene.entities[i].name, context.entity_locations[i], fmt::format("entity[{}].name", i));
    }
    for (std::size_t i = 0; i < scene.arrays.size(); ++i)
        take(scene.arrays[i].name, context.array_locations[i], fmt::format("array[{}].name", i));
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        if (const auto copy = names.copy_location(scene.entities[i].name)) {
            context.faults.error(context.entity_locations[i],
                                 fmt::format("entity[{}].name", i),
                                 "\"{}\" is the name of a copy of the array at {}",
                                 shown(scene.entities[i].name),
                                 to_string(*copy));
        }
    }
}

}  // namespace plumbline::scene
