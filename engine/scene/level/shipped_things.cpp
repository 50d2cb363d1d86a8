#include "engine/scene/level/shipped_things.h"

#include "engine/scene/scene_file.h"

#include <utility>

namespace plumbline::scene {

SceneDescription shipped_things(const std::filesystem::path& assets_folder) {
    const std::filesystem::path file = assets_folder / "scenes" / "things.toml";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return {};
    Diagnostics faults;
    Result<SceneDescription> things = read_description(file, assets_folder, faults);
    return things ? std::move(*things) : SceneDescription{};
}

EntityDescription thing_of(const EntityDescription& prefab, std::string_view name) {
    EntityDescription thing = prefab;
    thing.name = name;
    if (!thing.body) thing.body.emplace();
    thing.body->kind = physics::BodyKind::Dynamic;
    return thing;
}

}  // namespace plumbline::scene
