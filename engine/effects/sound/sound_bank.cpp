#include "engine/effects/sound/sound_bank.h"

namespace plumbline::effects {

assets::SoundId SoundBank::get(scene::Simulation& simulation, const std::filesystem::path& file) {
    if (const auto known = sounds_.find(file); known != sounds_.end()) return known->second;
    const Result<assets::SoundId> loaded = simulation.library().sound(file);
    assets::SoundId sound{};
    if (loaded) {
        sound = *loaded;
        bytes_ += simulation.library().sound(sound).samples.size() * sizeof(std::int16_t);
    } else {
        simulation.warnings.push_back(loaded.error().message);
    }
    sounds_.emplace(file, sound);
    return sound;
}

assets::SoundId SoundBank::pick(scene::Simulation& simulation,
                                const std::vector<std::filesystem::path>& files,
                                Random& random) {
    if (files.empty()) return {};
    return get(simulation, files[random.below(static_cast<std::uint32_t>(files.size()))]);
}

}  // namespace plumbline::effects
