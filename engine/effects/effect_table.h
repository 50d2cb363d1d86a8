// THE list of effects. To add one: a source file that defines its row, its name in the list below,
// a test; no other code needs editing.
#pragma once

#include "engine/effects/effect.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace plumbline::effects {

/// What a run serves; an effect of a domain that nobody serves is not made. `simulate` serves steps
/// only, `render` steps and image, `play` all three.
enum class Domain : std::uint8_t { Step, Frame, Sound };

/// One caller: "entity fountain (garden.toml:120)", "[sun] shadow (garden.toml:31)", "switch flashlight".
using Callers = std::vector<std::string>;

struct EffectRow {
    std::string_view name;  ///< as in reports: "sun_shadow"; also of its live switch
    Domain domain;
    Callers (*called_for_by)(const scene::Simulation&);  ///< empty: not called for
    std::unique_ptr<Effect> (*make)(scene::Simulation&);
    /// What its callers depend on beside entities that come and go and its own switch: while the
    /// number stays the same, so do they. Null: nothing.
    std::uint64_t (*key)(const scene::Simulation&){nullptr};
    std::string_view gpu_owner{};  ///< name in Renderer::gpu_bytes(); empty: none
    std::string_view passes{};  ///< prefix of its passes in FrameStats ("shadow.sun"); empty: none
};

// Each is defined in the source file of its name, those that only fill in the frame in one for their folder. A row may call for rows below it: impact sounds
// ask for contact events. Sounds come before what changes them.
#define PL_EFFECTS(ROW)       \
    ROW(sun_shadow)           \
    ROW(light_shadows)        \
    ROW(flashlight)           \
    ROW(fog)                  \
    ROW(skybox)               \
    ROW(refraction)           \
    ROW(caustics)             \
    ROW(ambient_occlusion)    \
    ROW(indirect_light)       \
    ROW(sun_shafts)           \
    ROW(depth_of_field)       \
    ROW(motion_blur)          \
    ROW(post)                 \
    ROW(model_animation)      \
    ROW(contact_look)         \
    ROW(triggers)             \
    ROW(viewer_aids)          \
    ROW(light_cubes)          \
    ROW(wind)                 \
    ROW(grass)                \
    ROW(flock)                \
    ROW(fountain)             \
    ROW(impact_sounds)        \
    ROW(rolling_sounds)       \
    ROW(ambient_sounds)       \
    ROW(footsteps)            \
    ROW(creak_sounds)         \
    ROW(wind_sound)           \
    ROW(sound_paths)          \
    ROW(room_reverb)          \
    ROW(continuous_collision) \
    ROW(gyroscopic_torque)    \
    ROW(contact_events)

#define PL_DECLARE_ROW(name) EffectRow name();
PL_EFFECTS(PL_DECLARE_ROW)
#undef PL_DECLARE_ROW

/// The usual make() of a row: T is made of the simulation, or of nothing.
template <class T>
std::unique_ptr<Effect> make_effect(scene::Simulation& simulation) {
    if constexpr (std::is_constructible_v<T, scene::Simulation&>)
        return std::make_unique<T>(simulation);
    else
        return std::make_unique<T>();
}

/// An effect without a state: kShow fills in the frame.
template <void (*kShow)(const scene::Simulation&, render::RenderFrame&)>
class FrameEffect final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        kShow(simulation, frame);
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

/// `values`: for draft, balanced and precise.
template <class T>
constexpr T by_fidelity(scene::Fidelity fidelity, const std::array<T, 3>& values) {
    return values[static_cast<std::size_t>(fidelity)];
}

/// In the order of the list.
std::span<const EffectRow> effect_table();

}  // namespace plumbline::effects
