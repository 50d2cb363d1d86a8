// The scenes of assets/scenes/bench/peers as plain data, and worlds that step them: ours, and stock
// Bullet as a newcomer would use it.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/physics_world.h"
#include "engine/scene/scene_description.h"
#include "engine/scene/surfaces.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace plumbline::bench {

/// A body of the scene, arrays spelt out, in the order in which every world gets them.
struct PeerBody {
    std::string name;
    scene::BodyDescription body;
    physics::ShapeDef shape;
    Pose start{};

    bool dynamic() const { return body.kind == physics::BodyKind::Dynamic; }
    double mass_kg() const { return static_cast<double>(body.mass_kg.value_or(Real{0})); }
    Vec3d inertia_kgm2() const { return Vec3d(body.inertia_kgm2.value_or(Vec3{0, 0, 0})); }
};

/// A ball-and-socket joint between two of the bodies.
struct PeerJoint {
    std::size_t a{0};
    std::size_t b{0};
    Vec3 anchor_m{0, 0, 0};  ///< world, at the start
    bool collide{false};
};

struct PeerScene {
    std::string name;
    scene::SceneDescription description;
    scene::SurfaceTable surfaces;
    std::vector<PeerBody> bodies;
    std::vector<PeerJoint> joints;
};

enum class SleepMode : std::uint8_t {
    AsInScene,
    EveryBody,  ///< every body may sleep
};

/// `name` as in assets/scenes/bench/peers, without ".toml".
Result<PeerScene> load_peer_scene(const std::filesystem::path& repository,
                                  const std::string& name,
                                  SleepMode sleep);

/// Where a body is and how it moves; in these scenes origin and centre of mass are one.
struct BodyView {
    Vec3d position{0, 0, 0};
    Quatd orientation{1, 0, 0, 0};
    Vec3d velocity_mps{0, 0, 0};
    Vec3d angular_velocity_radps{0, 0, 0};
};

class SteppedWorld {
public:
    virtual ~SteppedWorld() = default;
    SteppedWorld(const SteppedWorld&) = delete;
    SteppedWorld& operator=(const SteppedWorld&) = delete;

    virtual void step() = 0;
    /// One entry per body of the scene; static ones are left as they are.
    virtual void read(std::vector<BodyView>& views) const = 0;
    virtual bool all_asleep() const = 0;
    /// Of the latest step; null where nobody counts.
    virtual const physics::StepCost* cost() const { return nullptr; }
    /// Sub-steps by island in the latest step; empty where nobody says.
    virtual std::span<const physics::IslandReport> islands() const { return {}; }

protected:
    SteppedWorld() = default;
};

/// btDiscreteDynamicsWorld with everything at its default, as its own examples set it up.
/// The scene must outlive it.
std::unique_ptr<SteppedWorld> make_bare_world(const PeerScene& scene, double step_s);
/// The same program with SmallStepDynamicsWorld in its place.
std::unique_ptr<SteppedWorld> make_drop_in_world(const PeerScene& scene, double step_s);

struct OurSettings {
    physics::Solver solver{physics::Solver::BulletSi};
    int hz{60};
    int substeps{0};  ///< 0: as the scene says
    int threads{1};
};
/// PhysicsWorld, filled by the scene builder. The scene must outlive it.
Result<std::unique_ptr<SteppedWorld>> make_our_world(const PeerScene& scene,
                                                     const OurSettings& settings);

}  // namespace plumbline::bench
