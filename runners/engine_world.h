// A scene of rigid bodies as an engine that is not ours holds it.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>

namespace plumbline::engines {

using Json = nlohmann::json;

/// Thrown where an engine has nothing for what the scene needs: the message names it, "a cone".
struct Lacks : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t kNumbers = 13;  ///< of a body's state

class EngineWorld {
public:
    virtual ~EngineWorld() = default;
    /// Position, orientation x y z w, velocity, spin: of the mass frame, world axes.
    virtual void set_state(std::size_t body, std::span<const double, kNumbers> state) = 0;
    virtual void get_state(std::size_t body, std::span<double, kNumbers> state) const = 0;
    virtual void set_gravity(const Json& gravity_mps2) = 0;
    virtual void step() = 0;
};

/// `scene` as engine/study/engines/neutral_scene.h writes it, with step_hz and knobs.
using MakeWorld = std::unique_ptr<EngineWorld> (*)(const Json& scene);

/// One entry of the table in main.cpp.
struct Engine {
    const char* name;
    const char* version;
    MakeWorld make;
};
Engine bullet_engine();
#ifdef PLUMBLINE_HAS_ODE
Engine ode_engine();
#endif

/// Refuses what none of these has: rolling friction, elastic joints, joints that break, bodies held along an axis.
void refuse_specials(const Json& scene);
/// A knob of the engine's own; `other` where the request does not set it.
int knob(const Json& scene, const char* name, int other);

}  // namespace plumbline::engines
