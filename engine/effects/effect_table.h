// THE list of effects: name, what calls for it, how to make it. To add one: its source, a row here,
// a test, a line in a scene; nothing else needs editing.
#pragma once

#include "engine/effects/effect.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::effects {

/// What a run serves; an effect of a domain that nobody serves is not made. `simulate` serves steps
/// only, `render` steps and picture, `play` all three.
enum class Domain : std::uint8_t { Step, Picture, Sound };

/// One caller: "entity fountain (garden.toml:120)", "[sun] shadow (garden.toml:31)", "switch flashlight".
using Callers = std::vector<std::string>;

struct EffectRow {
    std::string_view name;  ///< as in reports: "sun_shadow"
    Domain domain;
    Callers (*called_for_by)(const scene::Simulation&);  ///< empty: not called for
    std::unique_ptr<Effect> (*make)(scene::Simulation&);
    std::string_view gpu_owner;  ///< name in Renderer::gpu_bytes(); empty: none
    std::string_view passes;     ///< prefix of its passes in FrameStats ("shadow.sun"); empty: none
};

/// sun_shadow flashlight fog skybox post impact_sounds ambient_sounds footsteps
/// continuous_collision gyroscopic_torque contact_events
std::span<const EffectRow> effect_table();

}  // namespace plumbline::effects
