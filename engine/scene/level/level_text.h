// A scene as play has changed it, as the text of a scene file.
#pragma once

#include "engine/scene/simulation.h"

#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

struct LevelText {
    std::string toml;
    std::vector<std::string> notes;  ///< what it lacks, for a person
};

/// A scene file that starts from `base`, as files name it, and begins as `simulation` is now, at rest: what was dropped
/// stands where it is, what was moved, frozen or removed is so.
LevelText level_text(const Simulation& simulation, std::string_view title, std::string_view base);

}  // namespace plumbline::scene
