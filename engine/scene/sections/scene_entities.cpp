// [[entity]], [[prefab]], [[array]]: what stands in the scene.
#include "engine/assets/model_import.h"
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::scene {
namespace {

constexpr std::size_t kNameBytes = 64;
constexpr std::size_t kPrefabChain = 32;

void read_visual(TableReader& table, EntityDescription& entity, const LoadContext& context) {
    const std::string_view key = table.either("model", "primitive");
    if (key == "model") {
        const auto model = read_file_reference(
            table, key, assets::kModelExtensions, "a box stands in for it", context);
        if (model) entity.visual = ModelVisual{.file = model->file, .root = model->root};
    } else if (key == "primitive") {
        if (const auto primitive = read_entity_primitive(table)) entity.visual = *primitive;
    }
}

void read_sound(TableReader& table, SoundDescription& sound, const LoadContext& context) {
    sound.file = read_sound_file(table, "file", context);
    table.read("loop", sound.loop);
    table.read("gain", sound.gain, kGain);
    table.read("radius_m", sound.radius_m, kSize_m);
    table.read("by_wind", sound.by_wind);
    table.read("by_flow", sound.by_flow);
}

void read_motion(TableReader& table, MotionDescription& motion) {
    if (const TomlNode* node = table.find("points_m")) {
        const TomlArray* points = node->array();
        if (points == nullptr || points->size() > 1000) {
            table.error("points_m", "{}; expected up to 1000 points [x, y, z]", found(*node));
        } else {
            for (std::size_t i = 0; i < points->size(); ++i) {
                const auto point = vector_of((*points)[i],
                                             fmt::format("{}[{}]", table.path_of("points_m"), i),
                                             kCoordinate_m,
                                             table.faults());
                if (point) motion.points_m.push_back(Vec3(*point));
            }
        }
    }
    constexpr Range kSpin_degps{-36'000, 36'000, "degrees per second from -36000 to 36000"};
    table.read("period_s", motion.period_s, {0.05, 1e5, "seconds from 0.05 to 100000"});
    table.read_degrees("spin_degps", motion.spin_radps, kSpin_degps);
}

void read_trigger(TableReader& table, TriggerDescription& trigger, const LoadContext& context) {
    table.read("spawn", trigger.spawn);
    if (table.has("spawn")) {
        if (!context.prefabs.contains(trigger.spawn)) {
            const std::string hint = suggestion(trigger.spawn, context.prefabs);
            table.error("spawn", "no prefab is called \"{}\"{}", shown(trigger.spawn), hint);
        }
        table.require("at_m", "where it appears");
    }
    table.read("at_m", trigger.at_m, kCoordinate_m);
    table.read("of", trigger.of);
    table.read("times", trigger.times, 1, 10'000);
    table.read("remove", trigger.remove);
    table.read("impulse_Ns", trigger.impulse_Ns, {-1e9, 1e9, "N s from -1e9 to 1e9"});
    table.read("gravity_mps2", trigger.gravity_mps2, {-1e3, 1e3, "m/s2 from -1000 to 1000"});
    table.read("explode", trigger.explode);
    table.read("light", trigger.light);
    table.read("message", trigger.message);
    if (table.has("sound")) trigger.sound = read_sound_file(table, "sound", context);
    table.read("count", trigger.count);
    constexpr std::array kActions{"spawn",
                                  "remove",
                                  "impulse_Ns",
                                  "gravity_mps2",
                                  "explode",
                                  "light",
                                  "message",
                                  "sound",
                                  "count"};
    if (std::ranges::none_of(kActions, [&table](const char* key) { return table.has(key); }))
        table.faults().error(table.location(),
                             table.path(),
                             "does nothing; expected one or more of {}",
                             fmt::join(kActions, ", "));
}

/// A volume needs a shape, and nothing that stops what comes in.
void check_trigger(TableReader& table, const EntityDescription& entity) {
    if (!entity.trigger) return;
    if (entity.body) table.error("trigger", "is passed through: the entity has no body");
    const auto* primitive = std::get_if<Primitive>(&entity.visual);
    if (primitive == nullptr || std::holds_alternative<physics::PlaneShape>(*primitive))
        table.error("trigger", "is the volume of a primitive other than a plane; there is none");
}

void read_material_name(TableReader& table,
                        std::string_view key,
                        std::string& name,
                        const LoadContext& context) {
    table.read(key, name);
    if (!table.has(key) || context.material_locations.contains(name)) return;
    const std::string hint = suggestion(name, context.material_locations);
    table.error(key, "no material is called \"{}\"{}", shown(name), hint);
}

/// Sizes as they are once the scale is applied.
void check_scaled_size(TableReader& table, const EntityDescription& entity) {
    const auto check = [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        Vec3 size{1, 1, 1};
        if constexpr (std::is_same_v<Shape, physics::BoxShape>)
            size = shape.size_m;
        else if constexpr (std::is_same_v<Shape, physics::PlaneShape>)
            size = Vec3{shape.size_m.x, Real{1}, shape.size_m.y};
        else if constexpr (std::is_same_v<Shape, physics::SphereShape>)
            size = Vec3{shape.radius_m, shape.radius_m, shape.radius_m};
        else
            size = Vec3{shape.radius_m, shape.height_m, shape.radius_m};
        const Vec3 scaled = size * entity.scale;
        for (int i = 0; i < 3; ++i) {
            const auto length_m = static_cast<double>(scaled[i]);
            if (length_m >= limits::kSizeMin_m * 0.999 && length_m <= limits::kSizeMax_m * 1.001)
                continue;
            table.error(
                "scale", "makes a length of {:.4g} m; expected {}", length_m, kSize_m.expected);
            return;
        }
    };
    if (const auto* primitive = std::get_if<Primitive>(&entity.visual))
        std::visit(check, *primitive);
}

std::array<int, 3> read_count(TableReader& table) {
    constexpr std::string_view kExpected = "three whole numbers from 1 to 50000";
    std::array<int, 3> count{1, 1, 1};
    const TomlNode* node = table.find("count");
    if (node == nullptr) return count;
    const TomlArray* array = node->array();
    if (array == nullptr || array->size() != 3) {
        table.error("count", "{}; expected {}", found(*node), kExpected);
        return count;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* value = std::get_if<std::int64_t>(&(*array)[i].value);
        if (value != nullptr && *value >= 1 &&
            *value <= static_cast<std::int64_t>(limits::kBodies)) {
            count[i] = static_cast<int>(*value);
            continue;
        }
        table.faults().error((*array)[i].location,
                             fmt::format("{}[{}]", table.path_of("count"), i),
                             "{}; expected {}",
                             found((*array)[i]),
                             kExpected);
    }
    return count;
}

}  // namespace

bool is_good_name(std::string_view name) {
    return !name.empty() && name.size() <= kNameBytes &&
           std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

std::string read_short_text(TableReader& table, const char* key) {
    const TomlNode* node = table.find(key);
    std::string text = table.text(key);
    if (node != nullptr && node->text() != nullptr && !is_good_name(text)) {
        table.error(key, "{}; expected 1 to {} letters", found(*node), kNameBytes);
        return {};
    }
    return text;
}

std::string read_name(TableReader& table) {
    return read_short_text(table, "name");
}

EntityDescription read_entity(TableReader& table, EntityUse use, LoadContext& context) {
    EntityDescription entity;
    entity.location = table.location();
    table.find("prefab");
    table.find("name");
    entity.label = read_short_text(table, "label");
    entity.world_from_body = read_pose(table);
    table.read("scale", entity.scale, {1e-3, 1e4, "a factor from 0.001 to 10000"});
    read_visual(table, entity, context);
    read_material_name(table, "material", entity.material, context);
    read_material_name(table, "contact_material", entity.contact_material, context);
    table.read("casts_shadow", entity.casts_shadow);
    table.read_table("light", entity.light, read_light);
    table.read_table("sound", entity.sound, read_sound, context);
    if (entity.sound && entity.sound->file.empty()) entity.sound.reset();
    table.read_table("motion", entity.motion, read_motion);
    table.read_table("body", entity.body, read_body, entity.visual, use);
    table.read_table("trigger", entity.trigger, read_trigger, context);
    check_trigger(table, entity);
    table.read_table("plaque", entity.plaque, read_plaque);
    if (!entity.contact_material.empty() && !entity.body && use == EntityUse::Entity)
        table.error("contact_material", "nothing touches an entity without a body");
    check_scaled_size(table, entity);
    const bool is_kinematic = entity.body && entity.body->kind == physics::BodyKind::Kinematic;
    if (use == EntityUse::Entity && entity.motion && !is_kinematic)
        table.error("motion", "only kinematic bodies follow a path; set body.kind = \"kinematic\"");
    table.finish();
    return entity;
}

Layered layered(const TomlNode& table,
                const std::string& path,
                LoadContext& context,
                std::vector<std::string> chain) {
    std::vector<const TomlNode*> layers{&table};
    bool complete = true;
    while (const TomlNode* named = find_key(*layers.back()->table(), "prefab")) {
        const auto refuse = [&](std::string message) {
            complete = false;
            context.faults.error(named->location, path + ".prefab", std::move(message));
        };
        const std::string* name = named->text();
        if (name == nullptr) {
            refuse(found(*named) + "; expected the name of a prefab in quotes");
            break;
        }
        const auto prefab = context.prefabs.find(*name);
        if (prefab == context.prefabs.end()) {
            const std::string hint = suggestion(*name, context.prefabs);
            refuse(fmt::format("no prefab is called \"{}\"{}", shown(*name), hint));
            break;
        }
        const bool again = std::ranges::find(chain, *name) != chain.end();
        chain.push_back(*name);
        if (again) {
            refuse(fmt::format("a prefab starts from itself: {}", fmt::join(chain, " -> ")));
            break;
        }
        if (chain.size() > kPrefabChain) {
            refuse(fmt::format("more than {} prefabs start from one another", kPrefabChain));
            break;
        }
        layers.push_back(prefab->second.node);
    }
    return {TableReader(std::move(layers), path, context.faults), complete};
}

void read_prefabs(SceneDescription& scene, LoadContext& context) {
    for (const auto& [name, source] : context.prefabs) {
        if (context.faults.is_full()) return;
        Layered prefab_source = layered(*source.node, source.path, context, {name});
        EntityDescription prefab = read_entity(prefab_source.table, EntityUse::Prefab, context);
        prefab.name = name;
        scene.prefabs.emplace(name, std::move(prefab));
    }
}

void read_entities(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("entity");
    scene.entities.reserve(nodes.size());
    for (std::size_t i = 0; i < nodes.size() && !context.faults.is_full(); ++i) {
        const std::string path = fmt::format("entity[{}]", i);
        // The name is the entity's own: its prefab's names the prefab.
        TableReader own(nodes[i], path, context.faults);
        const std::string name = read_name(own);
        Layered source = layered(nodes[i], path, context);
        // Without its prefab, what it lacks is not its own fault.
        const EntityUse use = source.complete ? EntityUse::Entity : EntityUse::Prefab;
        EntityDescription entity = read_entity(source.table, use, context);
        entity.name = name.empty() ? path : name;
        context.entity_locations.push_back(own.has("name") ? own.find("name")->location
                                                           : own.location());
        scene.entities.push_back(std::move(entity));
    }
}

void read_arrays(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("array");
    for (std::size_t i = 0; i < nodes.size() && !context.faults.is_full(); ++i) {
        TableReader table = root.item("array", nodes, i);
        ArrayDescription array;
        array.name = read_name(table);
        if (array.name.empty()) array.name = table.path();
        table.read("origin_m", array.origin_m, kCoordinate_m);
        table.read("spacing_m", array.spacing_m, kCoordinate_m);
        array.count = read_count(table);
        table.read_degrees("turn_deg", array.turn_rad, kTurn_deg);
        const std::optional<Quat> turn = read_turn(table);
        table.require("prefab", "the name of the prefab to copy");
        if (auto prefab = layered(nodes[i], table.path(), context).table.without_top()) {
            array.prefab = read_entity(*prefab, EntityUse::Entity, context);
            array.prefab.name = table.text("prefab");
            if (turn) array.prefab.world_from_body.orientation = *turn;
        }
        table.finish();
        context.array_locations.push_back(table.location());
        scene.arrays.push_back(std::move(array));
    }
}

}  // namespace plumbline::scene
