// What things are made of: friction and sound by name, from config/surfaces.toml.
#pragma once

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/core/text/diagnostics.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

struct Surface {
    std::string name;  ///< "wood"
    Real friction{0.5_r};
    Real restitution{0};
    Real density_kgpm3{700};
    std::vector<std::filesystem::path> impact_sounds;  ///< variations, one picked at random
    std::vector<std::filesystem::path> step_sounds;
    std::filesystem::path roll_sound;  ///< loops; empty: none
    std::filesystem::path scrape_sound;
    std::filesystem::path creak_sound;  ///< of joints as they turn
    float loudness{1.0F};               ///< of impacts, of what rolls and scrapes
    float absorption{0.1F};             ///< 0…1: the share of sound's energy that it swallows
    std::string caption;  ///< of its impacts: "chimes ring"; empty: "wood hits stone", by the names
};

/// Index 0 is the default surface. Which of two surfaces sounds when they meet, and how.
struct SurfaceTable {
    std::vector<Surface> surfaces;

    std::uint16_t find(std::string_view name) const;  ///< 0 when unknown
    const Surface& get(std::uint16_t index) const { return surfaces[index]; }
    /// Whether things of that surface sound when they hit. The default surface does not: a scene
    /// whose materials name no surface has asked for no sound.
    bool is_heard(std::uint16_t index) const {
        return index != 0 && !get(index).impact_sounds.empty();
    }
};

/// Missing file: a table with the default surface only and a fault. Bad entries cost only themselves.
SurfaceTable load_surfaces(const std::filesystem::path& file,
                           const std::filesystem::path& assets_folder,
                           Diagnostics& faults);

}  // namespace plumbline::scene
