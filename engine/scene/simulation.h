// One running scene: entities, their bodies, and the order of one fixed step. Headless: tests,
// `simulate`, replays and the game all step this.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/audio/sound_cue.h"
#include "engine/core/random.h"
#include "engine/core/result.h"
#include "engine/ecs/registry.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/components.h"
#include "engine/scene/scene_description.h"
#include "engine/scene/surfaces.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline::scene {

/// Settings that the command line may put over the scene's own.
struct SimulationOverrides {
    std::optional<physics::Solver> solver{};
    std::optional<int> step_hz{};
    std::optional<int> substeps{};
    std::optional<int> iterations{};
    std::uint64_t seed{1};
};

/// Live switches that play may flip; effects read them.
struct LiveSwitches {
    bool flashlight{false};
    bool fog{true};  ///< shows the scene's fog, if it has one (or a default one when toggled on)
    bool fog_added{false};  ///< toggled on in a scene without [fog]
    Vec3f sun_direction{0.0F, -1.0F, 0.0F};
    float light_scale{1.0F};
};

class Simulation {
public:
    Simulation(SceneDescription description,
               const SimulationOverrides& overrides,
               assets::AssetLibrary& library,
               SurfaceTable surfaces);

    // --- the parts of one fixed step, in this order; effects/advance.h calls them
    void remember_poses();  ///< so that drawing can blend
    void step();            ///< kinematic paths, physics, new placements
    void destroy_marked();  ///< marked entities, bodies below kill_below_m

    // --- what is there
    ecs::Registry registry;
    physics::PhysicsWorld physics;
    LiveSwitches switches;
    Random random;
    std::vector<audio::SoundCue> cues;  ///< asked for since the last frame took them

    const SceneDescription& description() const { return description_; }
    const SurfaceTable& surfaces() const { return surfaces_; }
    assets::AssetLibrary& library() { return library_; }
    const assets::AssetLibrary& library() const { return library_; }

    double step_s() const { return step_s_; }
    std::uint64_t steps() const { return steps_; }
    double time_s() const { return static_cast<double>(steps_) * step_s_; }
    std::uint32_t removed_count() const { return removed_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

    /// Makes an entity as a scene file would; dropped things come this way. Null on refusal, with a
    /// warning in warnings().
    ecs::Entity spawn(const EntityDescription& description);
    /// Entity of a body, or null.
    ecs::Entity entity_of(physics::BodyId body) const;
    ecs::Entity find(std::string_view name) const;

    /// Over every dynamic and kinematic body's pose and velocity bits, in file order.
    std::uint64_t state_hash() const;

private:
    SceneDescription description_;
    assets::AssetLibrary& library_;
    SurfaceTable surfaces_;
    double step_s_;
    std::uint64_t steps_{0};
    std::uint32_t removed_{0};
    std::vector<std::string> warnings_;
    struct Build;
};

/// Loads models, makes shapes, entities and bodies. Missing or refused models: the body keeps its
/// shape, a box is drawn, and warnings() lists it.
Result<std::unique_ptr<Simulation>> build_simulation(const SceneDescription& description,
                                                     const SimulationOverrides& overrides,
                                                     assets::AssetLibrary& library,
                                                     const SurfaceTable& surfaces);

}  // namespace plumbline::scene
