// Sound files (WAV, FLAC, Ogg, Opus, MP3, whatever libsndfile reads) to SoundData.
#pragma once

#include "engine/assets/sound_data.h"
#include "engine/core/result.h"

#include <filesystem>

namespace plumbline::assets {

/// A file that breaks off keeps what was decoded, with one warning. Over limits.h: refused.
Result<SoundData> import_sound(const std::filesystem::path& file);

}  // namespace plumbline::assets
