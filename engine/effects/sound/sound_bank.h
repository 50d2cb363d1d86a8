// The sounds of an effect: decoded when first wanted, asked for by file.
#pragma once

#include "engine/scene/simulation.h"

#include <filesystem>
#include <map>

namespace plumbline::effects {

class SoundBank {
public:
    /// Null for a file that cannot be read; it is tried, and warned of, once.
    assets::SoundId get(scene::Simulation& simulation, const std::filesystem::path& file);
    /// One of several variations; null when there are none.
    assets::SoundId pick(scene::Simulation& simulation,
                         const std::vector<std::filesystem::path>& files,
                         Random& random);
    std::uint64_t bytes() const { return bytes_; }

private:
    std::map<std::filesystem::path, assets::SoundId> sounds_;
    std::uint64_t bytes_{0};
};

}  // namespace plumbline::effects
