// Sound files (WAV, FLAC, Ogg, Opus, MP3, whatever libsndfile reads) to SoundData.
#pragma once

#include "engine/assets/sound_data.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// A file that breaks off keeps what was decoded, with one warning. Over limits.h: refused.
Result<SoundData> import_sound(const std::filesystem::path& file);
/// The same for bytes that are there already; `name` is for messages.
Result<SoundData> decode_sound(std::string_view bytes, const std::string& name);
/// The bytes for that. The error is for what is no regular file, or too large.
Result<std::string> read_sound_file(const std::filesystem::path& file);
/// Whether its sample rate and number of channels are ones that import_sound gives.
bool is_playable(const SoundData& sound);

}  // namespace plumbline::assets
