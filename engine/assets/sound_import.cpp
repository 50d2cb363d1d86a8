#include "engine/assets/sound_import.h"

#include "engine/assets/byte_reader.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>

namespace plumbline::assets {
namespace {

constexpr int kMaxChannels = 8;
constexpr int kMaxRate_hz = 384'000;
constexpr std::size_t kFramesPerRead = 4'096;

/// A file's bytes with a place in them, as libsndfile's virtual files want it.
struct MemoryFile {
    std::string_view bytes;
    sf_count_t place{0};

    sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }
};

sf_count_t size_of(void* user) {
    return static_cast<MemoryFile*>(user)->size();
}

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    auto& file = *static_cast<MemoryFile*>(user);
    sf_count_t start = 0;
    if (whence == SEEK_CUR) start = file.place;
    if (whence == SEEK_END) start = file.size();
    file.place = std::clamp(start + offset, sf_count_t{0}, file.size());
    return file.place;
}

sf_count_t read(void* target, sf_count_t count, void* user) {
    auto& file = *static_cast<MemoryFile*>(user);
    const sf_count_t got = std::clamp(count, sf_count_t{0}, file.size() - file.place);
    std::memcpy(target, file.bytes.data() + file.place, static_cast<std::size_t>(got));
    file.place += got;
    return got;
}

sf_count_t refuse_write(const void* /*source*/, sf_count_t /*count*/, void* /*user*/) {
    return 0;
}

sf_count_t tell(void* user) {
    return static_cast<MemoryFile*>(user)->place;
}

/// libsndfile takes a shortened RIFF or Ogg file for a shorter sound; the containers know better.
bool breaks_off(std::string_view bytes) {
    if (bytes.starts_with("RIFF") && bytes.size() >= 8) {
        return std::size_t{little_u32(bytes, 4)} + 8 > bytes.size() + 1;  // +1: missing pad byte
    }
    if (bytes.starts_with("OggS")) {
        const std::size_t last_page = bytes.rfind("OggS");
        constexpr std::size_t kFlags = 5;
        constexpr unsigned kEndOfStream = 4;
        return last_page + kFlags >= bytes.size() ||
               (static_cast<std::uint8_t>(bytes[last_page + kFlags]) & kEndOfStream) == 0;
    }
    return false;
}

constexpr std::size_t kChunkHead = 8;  // four letters and a length

/// A WAV file of what is played alone: format, number of frames, samples. libsndfile never ends
/// with some of the other chunks, whose lengths it does not check. The error says what is missing.
Result<std::string> plain_wav(std::string_view bytes) {
    constexpr std::size_t kFirstChunk = 12;
    std::string plain = "RIFF....WAVE";
    std::string_view kept;
    for (std::size_t at = kFirstChunk; at + kChunkHead <= bytes.size() && kept != "data";) {
        const std::string_view id = bytes.substr(at, 4);
        const std::size_t length = little_u32(bytes, at + 4);
        if (id == "fmt " || id == "fact" || id == "data") {
            kept = id;
            const std::string_view content = bytes.substr(at + kChunkHead, length);
            plain += id;
            for (std::size_t i = 0; i < 4; ++i)
                plain += static_cast<char>(content.size() >> (8 * i) & 0xFFU);
            plain += content;
            if (content.size() % 2 != 0) plain += '\0';
        }
        at += kChunkHead + length + length % 2;
    }
    if (kept != "data") return Error{.message = "it has no samples"};
    const std::size_t size = plain.size() - kChunkHead;
    for (std::size_t i = 0; i < 4; ++i) plain[4 + i] = static_cast<char>(size >> (8 * i) & 0xFFU);
    return plain;
}

/// The containers that scenes may use; libsndfile knows more, and trusts some of them too much.
bool is_known_container(std::string_view bytes) {
    if (bytes.size() < 12) return false;
    const bool mpeg_frame =
        bytes[0] == '\xff' && (static_cast<unsigned>(bytes[1]) & 0xE0U) == 0xE0U;
    return (bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WAVE") ||
           bytes.starts_with("OggS") || bytes.starts_with("fLaC") || bytes.starts_with("ID3") ||
           mpeg_frame;
}

/// Some containers with senseless headers are turned away by libsndfile with a general message;
/// the field at fault is read here so that the message can name it.
std::string wav_field_at_fault(std::string_view bytes) {
    constexpr std::size_t kChannels = 22;
    constexpr std::size_t kRate = 24;
    if (!bytes.starts_with("RIFF") || bytes.size() < 28 || bytes.substr(12, 4) != "fmt ") return {};
    const std::uint32_t channels = little_u32(bytes, kChannels) & 0xFFFFU;
    const std::uint32_t rate_hz = little_u32(bytes, kRate);
    if (rate_hz == 0) return "its sample rate is 0 Hz";
    if (channels == 0 || channels > kMaxChannels) {
        return fmt::format("it has {} channels; 1 to {} are read", channels, kMaxChannels);
    }
    return {};
}

/// A broken-off Ogg file does not know its length; it is decoded to see.
bool has_unknown_length(const SF_INFO& header) {
    return header.frames == SF_COUNT_MAX;
}

sf_count_t frames_allowed(const SF_INFO& header) {
    return static_cast<sf_count_t>(limits::kSoundBytes / sizeof(std::int16_t)) / header.channels;
}

/// What is wrong with a header, or nothing.
std::string header_fault(const SF_INFO& header) {
    if (header.samplerate < 1 || header.samplerate > kMaxRate_hz) {
        return fmt::format(
            "its sample rate is {} Hz; 1 to {} are read", header.samplerate, kMaxRate_hz);
    }
    if (header.channels < 1 || header.channels > kMaxChannels) {
        return fmt::format("it has {} channels; 1 to {} are read", header.channels, kMaxChannels);
    }
    if (header.frames < 1) return fmt::format("it has {} frames", header.frames);
    if (header.frames > frames_allowed(header) && !has_unknown_length(header)) {
        return fmt::format("it has {} frames; {} of {} channels are read",
                           header.frames,
                           frames_allowed(header),
                           header.channels);
    }
    return {};
}

std::int16_t sample_of(float value) {
    if (!(std::abs(value) <= 1.0F)) {  // also NaN, which becomes silence
        if (std::isnan(value)) return 0;
        value = std::copysign(1.0F, value);
    }
    const float scaled = std::round(value * 32'768.0F);
    return static_cast<std::int16_t>(std::clamp(scaled, -32'768.0F, 32'767.0F));
}

}  // namespace

Result<std::string> read_sound_file(const std::filesystem::path& file) {
    Result<std::string> bytes = read_file(file, limits::kSoundBytes);
    if (!bytes) return Error{.message = bytes.error().message, .exit_code = ExitCode::Refused};
    return bytes;
}

Result<SoundData> import_sound(const std::filesystem::path& file) {
    const Result<std::string> bytes = read_sound_file(file);
    if (!bytes) return bytes.error();
    return decode_sound(*bytes, file.string());
}

bool is_playable(const SoundData& sound) {
    return sound.sample_rate_hz >= 1 && sound.sample_rate_hz <= kMaxRate_hz &&
           sound.channels >= 1 && sound.channels <= kMaxChannels;
}

Result<SoundData> decode_sound(std::string_view bytes, const std::string& name) {
    const auto refuse = [&](std::string_view why) {
        return Error{.message = fmt::format("sound {} is refused: {}", name, why),
                     .exit_code = ExitCode::Refused};
    };
    const std::string wav_fault = wav_field_at_fault(bytes);
    if (!wav_fault.empty()) return refuse(wav_fault);

    if (!is_known_container(bytes)) return refuse("its content is none of WAV, Ogg, FLAC and MP3");
    Result<std::string> plain = std::string();
    const bool is_wav = bytes.starts_with("RIFF");
    if (is_wav) plain = plain_wav(bytes);
    if (!plain) return refuse(plain.error().message);

    MemoryFile memory{.bytes = is_wav ? *plain : bytes};
    SF_VIRTUAL_IO access{
        .get_filelen = size_of, .seek = seek, .read = read, .write = refuse_write, .tell = tell};
    SF_INFO header{};
    const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> source(
        sf_open_virtual(&access, SFM_READ, &header, &memory), sf_close);
    if (source == nullptr) return refuse(sf_strerror(nullptr));
    const std::string fault = header_fault(header);
    if (!fault.empty()) return refuse(fault);

    SoundData sound{.sample_rate_hz = header.samplerate, .channels = header.channels};
    const auto channels = static_cast<std::size_t>(header.channels);
    const std::size_t wanted =
        static_cast<std::size_t>(std::min(header.frames, frames_allowed(header))) * channels;
    if (!has_unknown_length(header)) sound.samples.reserve(wanted);
    std::vector<float> block(kFramesPerRead * channels);
    while (sound.samples.size() < wanted) {
        const sf_count_t got =
            sf_readf_float(source.get(), block.data(), static_cast<sf_count_t>(kFramesPerRead));
        if (got <= 0) break;
        const std::size_t count =
            std::min(static_cast<std::size_t>(got) * channels, wanted - sound.samples.size());
        for (std::size_t i = 0; i < count; ++i) sound.samples.push_back(sample_of(block[i]));
    }
    if (sound.samples.empty()) return refuse("nothing in it could be decoded");
    if (sound.samples.size() < wanted || breaks_off(bytes)) {
        const std::size_t frames = sound.samples.size() / channels;
        log_warning("sound {} breaks off; the {:.2f} s that decoded are used",
                    name,
                    static_cast<double>(frames) / header.samplerate);
    }
    return sound;
}

}  // namespace plumbline::assets
