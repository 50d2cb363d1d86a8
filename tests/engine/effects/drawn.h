// What a scene's effects add to a frame and to the ledger.
#pragma once

#include "engine/effects/effect_runtime.h"
#include "engine/scene/extract.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <string_view>

namespace plumbline::effects {

/// What `render` serves.
inline constexpr ServedDomains kImage{.frame = true};

/// One frame as the window makes it.
inline render::RenderFrame draw(test::Running& run, EffectRuntime& effects, Real blend = 1) {
    effects.refresh(*run);
    const scene::ViewPoint view = run.game.view(*run, blend, 0.0F, 0.0F);
    render::RenderFrame frame = scene::extract(*run, view, 64, 64);
    effects.extract(*run, view, frame);
    return frame;
}

inline scene::ViewPoint listener_at(const Vec3& position_m) {
    scene::ViewPoint view;
    view.world_from_camera.position = position_m;
    return view;
}

inline LedgerLine line_of(const EffectRuntime& effects, std::string_view name) {
    for (LedgerLine& line : effects.ledger()) {
        if (line.name == name) return line;
    }
    ADD_FAILURE() << "no effect " << name;
    return {};
}

}  // namespace plumbline::effects
