#include "engine/assets/foreign/decoder.h"

#include "engine/assets/byte_reader.h"
#include "engine/assets/foreign/model_export_impl.h"
#include "engine/assets/image/image_codecs_impl.h"
#include "engine/assets/model/model_readers_impl.h"
#include "engine/assets/sound_import.h"
#include "engine/core/io/output.h"
#include "engine/core/limits.h"
#include "engine/core/process/process.h"
#include "engine/core/process/sandbox.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

constexpr char kDecoded = 'D';
constexpr char kRefused = 'R';

constexpr std::size_t kMiB = 1024ULL * 1024;
constexpr std::size_t kMostMemory = 1536 * kMiB;

/// What the decoder of a kind of file may take: so much, and more by the file's size.
struct Allowance {
    std::string_view kind;
    std::size_t memory_bytes;
    std::size_t memory_per_byte;
    std::size_t answer_bytes;

    std::size_t memory_of(std::size_t file_bytes) const {
        return std::min(memory_bytes + memory_per_byte * file_bytes, kMostMemory);
    }
    static unsigned cpu_s(std::size_t file_bytes) {
        return 10 + static_cast<unsigned>(file_bytes / (4 * kMiB));
    }
};
// Pixels and samples are bounded by limits.h, however small the file; a model grows with its file.
constexpr Allowance kImages{"image", 1024 * kMiB, 2, limits::kImageBytes + 64};
constexpr Allowance kSounds{"sound", 256 * kMiB, 2, limits::kSoundBytes + 64};
constexpr Allowance kModels{"model", 256 * kMiB, 24, kMostMemory};

const Allowance& allowance_of(std::string_view kind) {
    for (const Allowance* each : {&kImages, &kSounds}) {
        if (each->kind == kind) return *each;
    }
    return kModels;
}

Error refused(const Allowance& allowance, const std::string& name, std::string_view why) {
    return {.message = fmt::format("{} {} is refused: {}", allowance.kind, name, why),
            .exit_code = ExitCode::Refused};
}

template <class T>
void append_number(std::string& bytes, T value) {
    bytes.append(static_cast<const char*>(static_cast<const void*>(&value)), sizeof(T));
}

template <class T>
void append_block(std::string& bytes, const std::vector<T>& values) {
    bytes.append(static_cast<const char*>(static_cast<const void*>(values.data())),
                 values.size() * sizeof(T));
}

std::string answer_of(const ImageData& image) {
    std::string bytes;
    bytes.reserve(image.bytes.size() + 16);
    append_number(bytes, image.width);
    append_number(bytes, image.height);
    append_number(bytes, image.format);
    append_block(bytes, image.bytes);
    return bytes;
}

std::string answer_of(const SoundData& sound) {
    std::string bytes;
    append_number(bytes, sound.sample_rate_hz);
    append_number(bytes, sound.channels);
    append_block(bytes, sound.samples);
    return bytes;
}

Result<std::string> decode(const Allowance& allowance,
                           std::string_view bytes,
                           const std::string& name) {
    try {
        if (&allowance == &kModels) return glb_of_foreign_model(bytes, name);
        if (&allowance == &kSounds) {
            const Result<SoundData> sound = decode_sound(bytes, name);
            if (!sound) return sound.error();
            return answer_of(*sound);
        }
        const Result<ImageData> image = decode_image(bytes, name);
        if (!image) return image.error();
        return answer_of(*image);
    } catch (const std::bad_alloc&) {
        return refused(allowance,
                       name,
                       fmt::format("its reader may take {} MiB, which is too little",
                                   allowance.memory_of(bytes.size()) / kMiB));
    }
}

/// The program that has the decoders in it: this one, as a rule.
fs::path decoder_program() {
    std::error_code failed;
    const fs::path self = fs::read_symlink("/proc/self/exe", failed);
    const fs::path beside = self.parent_path() / "plumbline";
    return fs::is_regular_file(beside, failed) ? beside : fs::path{};
}

using Answer = std::vector<std::uint8_t>;

std::string_view text_of(const Answer& answer) {
    return {static_cast<const char*>(static_cast<const void*>(answer.data())), answer.size()};
}

/// What the decoder made of the bytes, behind kDecoded.
Result<Answer> decoded_apart(const Allowance& allowance,
                             std::string_view bytes,
                             const std::string& name,
                             const Decoder& decoder) {
    const fs::path program = decoder.program.empty() ? decoder_program() : decoder.program;
    if (program.empty())
        return refused(allowance, name, "the program plumbline, which reads it, is not here");
    const std::string size = fmt::format("{}", bytes.size());
    Answer answer;
    const auto take = [&](std::string_view piece) {
        answer.insert(answer.end(), piece.begin(), piece.end());
        return answer.size() <= allowance.answer_bytes;
    };
    const Result<ChildEnd> end = output_to(
        take,
        {.program = program, .arguments = {"decoder", std::string(allowance.kind), size, name}},
        bytes,
        decoder.limit_s.value_or(3.0 * Allowance::cpu_s(bytes.size())));
    if (!end) return refused(allowance, name, end.error().message);
    if (!end->good || answer.empty()) {
        return refused(
            allowance, name, fmt::format("its reader {}", end->good ? "says nothing" : end->words));
    }
    if (answer.front() == kDecoded) return answer;
    return Error{.message = std::string(text_of(answer).substr(1)), .exit_code = ExitCode::Refused};
}

constexpr std::string_view kBreaksOff = "its reader's answer breaks off";

}  // namespace

ExitCode run_decoder(std::string_view kind, std::size_t file_bytes, const std::string& name) {
    const Allowance& allowance = allowance_of(kind);
    const auto answer = [&]() -> Result<std::string> {
        const Result<Done> confined =
            enter_sandbox({.memory_bytes = allowance.memory_of(file_bytes),
                           .cpu_s = Allowance::cpu_s(file_bytes)});
        if (!confined) return refused(allowance, name, confined.error().message);
        std::string bytes(file_bytes, '\0');
        if (!receive_all(bytes)) return refused(allowance, name, "it breaks off");
        return decode(allowance, bytes, name);
    }();
    const char verdict = answer ? kDecoded : kRefused;
    const bool written = write_output("-", {&verdict, 1}) &&
                         write_output("-", answer ? *answer : answer.error().message);
    return written ? ExitCode::Good : ExitCode::RunFailed;
}

Result<ImageData> decode_image_apart(std::string_view bytes,
                                     const std::string& name,
                                     const ImageBytesAllowed& allowed,
                                     const Decoder& decoder) {
    Result<Answer> answer = decoded_apart(kImages, bytes, name, decoder);
    if (!answer) return answer.error();
    ByteReader reader(text_of(*answer).substr(1));
    ImageData image;
    image.width = reader.number<std::uint32_t>();
    image.height = reader.number<std::uint32_t>();
    const auto format = reader.number<std::uint8_t>();
    image.format = static_cast<PixelFormat>(format);
    if (format > static_cast<std::uint8_t>(PixelFormat::Rgba16F))
        return refused(kImages, name, kBreaksOff);
    const std::string fault = size_fault(image.width, image.height, image.format, allowed);
    if (!fault.empty()) return refused(kImages, name, fault);
    if (reader.left() != std::size_t{image.width} * image.height * bytes_per_pixel(image.format)) {
        return refused(kImages, name, kBreaksOff);
    }
    answer->erase(answer->begin(), answer->end() - static_cast<std::ptrdiff_t>(reader.left()));
    image.bytes = std::move(*answer);  // large ones are not held twice
    return image;
}

Result<SoundData> decode_sound_apart(std::string_view bytes,
                                     const std::string& name,
                                     const Decoder& decoder) {
    const Result<Answer> answer = decoded_apart(kSounds, bytes, name, decoder);
    if (!answer) return answer.error();
    ByteReader reader(text_of(*answer).substr(1));
    SoundData sound;
    sound.sample_rate_hz = reader.number<std::int32_t>();
    sound.channels = reader.number<std::int32_t>();
    const std::string_view samples = reader.take(reader.left());
    if (!is_playable(sound) || samples.empty() ||
        samples.size() % (sizeof(std::int16_t) * static_cast<std::size_t>(sound.channels)) != 0) {
        return refused(kSounds, name, kBreaksOff);
    }
    sound.samples.resize(samples.size() / sizeof(std::int16_t));
    std::memcpy(sound.samples.data(), samples.data(), samples.size());
    return sound;
}

Result<ModelData> read_foreign_model(std::string_view bytes,
                                     const std::string& name,
                                     ModelReferences& references,
                                     const Decoder& decoder) {
    const std::string fault = foreign_model_fault(bytes);
    if (!fault.empty()) return refused(kModels, name, fault);
    const Result<Answer> glb = decoded_apart(kModels, bytes, name, decoder);
    if (!glb) return glb.error();
    references.expect_paths_of_another_machine();
    return read_gltf(text_of(*glb).substr(1), name, references);
}

}  // namespace plumbline::assets
