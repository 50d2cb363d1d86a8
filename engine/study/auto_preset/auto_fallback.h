// What preset = "auto" comes to without a study.
#pragma once

#include "engine/scene/scene_description.h"

#include <string>

namespace plumbline::study {

/// Whether the preset is "auto" and the rest of [accuracy] leaves it anything to choose.
bool leaves_a_choice(const scene::Accuracy& asked);

/// The numbers of "balanced", and a warning that says why.
scene::Accuracy balanced(const scene::SceneDescription& description, const std::string& why);

}  // namespace plumbline::study
