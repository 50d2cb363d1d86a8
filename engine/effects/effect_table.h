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
    /// Both from the list below. The name is that of reports, "sun_shadow", and of its live switch.
    std::string_view name{};
    Domain domain{Domain::Step};
    Callers (*called_for_by)(const scene::Simulation&);  ///< empty: not called for
    std::unique_ptr<Effect> (*make)(scene::Simulation&){nullptr};
    std::size_t bytes{0};  ///< of what it makes
    /// What its callers depend on beside entities that come and go and its own switch: while the
    /// number stays the same, so do they. Null: nothing.
    std::uint64_t (*key)(const scene::Simulation&){nullptr};
    std::string_view gpu_owner{};  ///< name in Renderer::gpu_bytes(); empty: none
    std::string_view passes{};  ///< prefix of its passes in FrameStats ("shadow.sun"); empty: none
};

// Each is defined in the source file of its name, those that only fill in the frame in one for their folder. A row may call for rows below it: impact sounds
// ask for contact events. Sounds come before what changes them.
#define PL_EFFECTS(ROW)             \
    ROW(sun_shadow, Frame)          \
    ROW(light_shadows, Frame)       \
    ROW(flashlight, Frame)          \
    ROW(fog, Frame)                 \
    ROW(skybox, Frame)              \
    ROW(refraction, Frame)          \
    ROW(caustics, Frame)            \
    ROW(ambient_occlusion, Frame)   \
    ROW(indirect_light, Frame)      \
    ROW(sun_shafts, Frame)          \
    ROW(depth_of_field, Frame)      \
    ROW(motion_blur, Frame)         \
    ROW(post, Frame)                \
    ROW(model_animation, Frame)     \
    ROW(contact_look, Frame)        \
    ROW(triggers, Step)             \
    ROW(viewer_aids, Frame)         \
    ROW(light_cubes, Frame)         \
    ROW(wind, Frame)                \
    ROW(grass, Frame)               \
    ROW(flock, Frame)               \
    ROW(fountain, Frame)            \
    ROW(impact_sounds, Sound)       \
    ROW(rolling_sounds, Sound)      \
    ROW(plaques, Step)              \
    ROW(joint_bars, Frame)          \
    ROW(ambient_sounds, Sound)      \
    ROW(footsteps, Sound)           \
    ROW(creak_sounds, Sound)        \
    ROW(wind_sound, Sound)          \
    ROW(sound_paths, Sound)         \
    ROW(room_reverb, Sound)         \
    ROW(explosion, Step)            \
    ROW(drag, Step)                 \
    ROW(buoyancy, Step)             \
    ROW(water, Step)                \
    ROW(magnets, Step)              \
    ROW(conveyor, Step)             \
    ROW(rope, Step)                 \
    ROW(cloth, Step)                \
    ROW(soft, Step)                 \
    ROW(vehicles, Step)             \
    ROW(fracture, Step)             \
    ROW(continuous_collision, Step) \
    ROW(gyroscopic_torque, Step)    \
    ROW(contact_events, Step)       \
    ROW(burst_sounds, Sound)

#define PL_DECLARE_ROW(name, domain) EffectRow name();
PL_EFFECTS(PL_DECLARE_ROW)
#undef PL_DECLARE_ROW

/// A row whose effect is a T, made of the simulation or of nothing.
template <class T>
EffectRow with_effect(EffectRow row) {
    row.bytes = sizeof(T);
    row.make = [](scene::Simulation& simulation) -> std::unique_ptr<Effect> {
        if constexpr (std::is_constructible_v<T, scene::Simulation&>)
            return std::make_unique<T>(simulation);
        else
            return std::make_unique<T>();
    };
    return row;
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
};

/// `values`: for draft, balanced and precise.
template <class T>
constexpr T by_fidelity(scene::Fidelity fidelity, const std::array<T, 3>& values) {
    return values[static_cast<std::size_t>(fidelity)];
}

/// In the order of the list.
std::span<const EffectRow> effect_table();

}  // namespace plumbline::effects
