#include "engine/study/scenarios/world/peer_scene.h"

#include "engine/study/played_scene.h"

#include <fmt/format.h>

namespace plumbline::study {
namespace {

std::vector<physics::BodyId> dynamic_bodies(const scene::Simulation& simulation) {
    std::vector<physics::BodyId> bodies;
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (moving.kind == physics::BodyKind::Dynamic) bodies.push_back(moving.body);
    }
    return bodies;
}

}  // namespace

Result<std::unique_ptr<PeerScene>> PeerScene::open(std::string_view name, const Setting& setting) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const Result<scene::OpenedScene> opened = open_for_study(
        folders->assets / "scenes/bench/peers" / fmt::format("{}.toml", name), overrides(setting));
    if (!opened) return opened.error();
    auto library = std::make_unique<assets::AssetLibrary>();
    Result<std::unique_ptr<scene::Simulation>> built = opened->build(*library);
    if (!built) return built.error();
    return std::unique_ptr<PeerScene>(new PeerScene(std::move(library), std::move(*built)));
}

PeerScene::PeerScene(std::unique_ptr<assets::AssetLibrary> library,
                     std::unique_ptr<scene::Simulation> simulation)
    : library_(std::move(library)),
      simulation_(std::move(simulation)),
      world(simulation_->physics, dynamic_bodies(*simulation_)) {}

physics::BodyId PeerScene::body(std::string_view entity) const {
    const auto* ref = simulation_->registry.find<scene::BodyRef>(simulation_->find(entity));
    PL_ASSERT(ref != nullptr, "an entity of the peer scene that has a body");
    return ref->body;
}

}  // namespace plumbline::study
