// Many images on one.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/scene/scene_description.h"

#include <vector>

namespace plumbline::game {

/// Rgb8 images of one size, each at a third of its sides, three in a row on dark ground.
assets::ImageData contact_sheet(const std::vector<assets::ImageData>& images);

/// The scene's own [[view]] list; without one its first view and a round trip about what it sees.
std::vector<scene::ViewDescription> tour_stops(const scene::SceneDescription& scene);

}  // namespace plumbline::game
