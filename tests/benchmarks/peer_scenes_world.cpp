#include "tests/benchmarks/peer_scenes_world.h"

#include "engine/physics/totals.h"
#include "engine/scene/open_scene.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::bench {

namespace {

Result<physics::ShapeDef> shape_of(const scene::EntityDescription& entity) {
    if (const auto* shape = std::get_if<physics::ShapeDef>(&entity.body->shape)) return *shape;
    if (const auto* primitive = std::get_if<scene::Primitive>(&entity.visual)) {
        return std::visit([](const auto& shape) { return physics::ShapeDef{shape}; }, *primitive);
    }
    return Error{fmt::format("{}: its shape comes from a model", entity.name), ExitCode::Refused};
}

/// Entities first, then arrays with x fastest: the scene builder's order.
std::vector<scene::EntityDescription> spelt_out(const scene::SceneDescription& scene) {
    std::vector<scene::EntityDescription> entities = scene.entities;
    for (const scene::ArrayDescription& array : scene.arrays) {
        for (int z = 0; z < array.count[2]; ++z) {
            for (int y = 0; y < array.count[1]; ++y) {
                for (int x = 0; x < array.count[0]; ++x) {
                    scene::EntityDescription copy = array.prefab;
                    const Vec3 cell{
                        static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
                    copy.name = fmt::format("{}.{}.{}.{}", array.name, x, y, z);
                    copy.world_from_body.position = array.origin_m + array.spacing_m * cell;
                    entities.push_back(std::move(copy));
                }
            }
        }
    }
    return entities;
}

Result<Done> add_bodies(PeerScene& scene) {
    for (const scene::EntityDescription& entity : spelt_out(scene.description)) {
        if (!entity.body) continue;
        const Result<physics::ShapeDef> shape = shape_of(entity);
        if (!shape) return shape.error();
        scene.bodies.push_back({.name = entity.name,
                                .body = *entity.body,
                                .shape = *shape,
                                .start = entity.world_from_body});
    }
    return Done{};
}

Result<std::size_t> index_of(const PeerScene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (scene.bodies[i].name == name) return i;
    }
    return Error{fmt::format("a joint needs a body \"{}\"", name), ExitCode::Refused};
}

Result<Done> add_joints(PeerScene& scene) {
    for (const scene::JointDescription& joint : scene.description.joints) {
        if (joint.kind != scene::JointKind::BallAndSocket)
            return Error{"joints other than ball-and-socket joints have no match here",
                         ExitCode::Refused};
        const Result<std::size_t> a = index_of(scene, joint.a);
        const Result<std::size_t> b = index_of(scene, joint.b);
        if (!a) return a.error();
        if (!b) return b.error();
        scene.joints.push_back(
            {.a = *a, .b = *b, .anchor_m = joint.anchor_a_m, .collide = joint.collide});
    }
    return Done{};
}

void let_everything_sleep(scene::SceneDescription& description) {
    for (scene::EntityDescription& entity : description.entities) {
        if (entity.body) entity.body->can_sleep = true;
    }
    for (scene::ArrayDescription& array : description.arrays) {
        if (array.prefab.body) array.prefab.body->can_sleep = true;
    }
}

class OurWorld final : public SteppedWorld {
public:
    explicit OurWorld(const PeerScene& scene) : scene_(scene) {}

    Result<Done> build(const OurSettings& settings) {
        scene::SimulationOverrides overrides{
            .solver = settings.solver, .step_hz = settings.hz, .threads = settings.threads};
        if (settings.substeps > 0) overrides.substeps = settings.substeps;
        auto built =
            scene::build_simulation(scene_.description, overrides, library_, scene_.surfaces);
        if (!built) return built.error();
        simulation_ = std::move(*built);
        for (const PeerBody& body : scene_.bodies) {
            const ecs::Entity entity = simulation_->find(body.name);
            bodies_.push_back(simulation_->registry.get<scene::BodyRef>(entity).body);
        }
        return Done{};
    }

    // The physics alone: what a scene does around it is not the solver's cost.
    void step() override { simulation_->physics.step(); }

    void read(std::vector<BodyView>& views) const override {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!scene_.bodies[i].dynamic()) continue;
            const physics::BodyState state = simulation_->physics.state(bodies_[i]);
            views[i] = {.position = Vec3d(state.world_from_body.position),
                        .orientation = Quatd(state.world_from_body.orientation),
                        .velocity_mps = Vec3d(state.velocity_mps),
                        .angular_velocity_radps = Vec3d(state.angular_velocity_radps)};
        }
    }
    bool all_asleep() const override { return awake_count(simulation_->physics) == 0; }
    const physics::StepCost* cost() const override { return &simulation_->physics.report().cost; }
    std::span<const physics::IslandReport> islands() const override {
        return simulation_->physics.report().islands;
    }

private:
    const PeerScene& scene_;
    assets::AssetLibrary library_;
    std::unique_ptr<scene::Simulation> simulation_;
    std::vector<physics::BodyId> bodies_;
};

}  // namespace

Result<PeerScene> load_peer_scene(const std::filesystem::path& repository,
                                  const std::string& name,
                                  SleepMode sleep) {
    const std::filesystem::path assets = repository / "assets";
    Diagnostics faults;
    PeerScene scene;
    scene.name = name;
    Result<scene::OpenedScene> opened =
        scene::open_scene(assets / "scenes/bench/peers" / fmt::format("{}.toml", name),
                          {.folders = {.assets = assets,
                                       .shaders = repository / "shaders",
                                       .config = repository / "config"}},
                          faults);
    if (!opened) return opened.error();
    scene.surfaces = std::move(opened->surfaces);
    scene.description = std::move(opened->description);
    if (sleep == SleepMode::EveryBody) let_everything_sleep(scene.description);
    if (const Result<Done> done = add_bodies(scene); !done) return done.error();
    if (const Result<Done> done = add_joints(scene); !done) return done.error();
    return scene;
}

Result<std::unique_ptr<SteppedWorld>> make_our_world(const PeerScene& scene,
                                                     const OurSettings& settings) {
    auto world = std::make_unique<OurWorld>(scene);
    if (const Result<Done> done = world->build(settings); !done) return done.error();
    return std::unique_ptr<SteppedWorld>(std::move(world));
}

}  // namespace plumbline::bench
