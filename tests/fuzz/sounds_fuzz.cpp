// Sounds: WAV, FLAC, Ogg Vorbis, Opus and MP3.
#include "engine/assets/sound_import.h"
#include "tests/fuzz/fuzz_target.h"

#include <sndfile.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace plumbline::fuzz {
namespace {

/// A tenth of a second of a tone.
std::string tone(int format) {
    std::array<short, 4800> samples{};
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<short>(8000.0 * std::sin(static_cast<double>(i) * 0.05));
    std::string pattern = (std::filesystem::temp_directory_path() / "tone-XXXXXX").string();
    const int number = ::mkstemp(pattern.data());
    SF_INFO info{};
    info.samplerate = 48'000;
    info.channels = 1;
    info.format = format;
    SNDFILE* file = sf_open_fd(number, SFM_WRITE, &info, 1);
    if (file == nullptr) std::abort();
    sf_write_short(file, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(file);
    std::ifstream stream(pattern, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove(pattern);
    return bytes;
}

}  // namespace

std::vector<std::string> seeds() {
    return {tone(SF_FORMAT_WAV | SF_FORMAT_PCM_16),
            tone(SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM),
            tone(SF_FORMAT_FLAC | SF_FORMAT_PCM_16),
            tone(SF_FORMAT_OGG | SF_FORMAT_VORBIS),
            tone(SF_FORMAT_OGG | SF_FORMAT_OPUS),
            tone(SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III)};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace plumbline::assets;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const plumbline::Result<SoundData> sound = decode_sound(bytes, "mutant");
    if (!sound) return sound.error().message.empty() ? 1 : 0;
    plumbline::fuzz::note_taken();
    if (!is_playable(*sound) || sound->samples.empty()) std::abort();
    return 0;
}
