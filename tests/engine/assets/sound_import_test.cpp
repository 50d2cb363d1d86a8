// Sounds: samples as stored, and headers that make no sense.

#include "engine/assets/sound_import.h"

#include "engine/assets/asset_library.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

struct WavHeader {
    std::uint16_t channels{1};
    std::uint32_t rate_hz{44'100};
    std::uint16_t bits{16};
    std::uint32_t data_bytes{0};
    std::uint16_t format{1};  // PCM
};

std::string wav(const WavHeader& header, const std::string& data) {
    const auto frame_bytes = static_cast<std::uint16_t>(header.channels * header.bits / 8);
    std::string bytes = "RIFF";
    append_bytes<std::uint32_t>(bytes, {36 + header.data_bytes});
    bytes += "WAVEfmt ";
    append_bytes<std::uint32_t>(bytes, {16});
    append_bytes<std::uint16_t>(bytes, {header.format, header.channels});
    append_bytes<std::uint32_t>(bytes, {header.rate_hz, header.rate_hz * frame_bytes});
    append_bytes<std::uint16_t>(bytes, {frame_bytes, header.bits});
    bytes += "data";
    append_bytes<std::uint32_t>(bytes, {header.data_bytes});
    return bytes + data;
}

std::string pcm16(std::initializer_list<std::int16_t> samples) {
    std::string data;
    append_bytes<std::int16_t>(data, samples);
    return data;
}

struct SoundImport {
    Result<SoundData> sound;
    std::string log;

    explicit SoundImport(std::string_view bytes)
        : sound((::testing::internal::CaptureStderr(), import_in_folder(bytes))),
          log(::testing::internal::GetCapturedStderr()) {}

    static Result<SoundData> import_in_folder(std::string_view bytes) {
        const TempFolder folder;
        return import_sound(folder.write("s.wav", bytes));
    }
    std::string error() const { return sound.ok() ? "" : sound.error().message; }
};

TEST(SoundsAhead, change_nothing_of_what_is_heard) {
    const TempFolder folder;
    const auto file = folder.write("s.wav", wav({.data_bytes = 6}, pcm16({1, -2, 3})));
    const auto broken = folder.write("t.wav", "RIFF");
    for (int i = 0; i < 20; ++i) {
        AssetLibrary library;
        if (i > 0) library.prefetch_sounds({broken, file, folder.path() / "absent.wav"});
        // Before, while or after the thread decodes it.
        if (i > 10) std::this_thread::sleep_for(std::chrono::milliseconds(i - 10));
        const Result<SoundId> sound = library.sound(file);
        ASSERT_TRUE(sound.ok());
        EXPECT_EQ(library.sound(*sound).samples, (std::vector<std::int16_t>{1, -2, 3}));
        EXPECT_EQ(library.sound(file)->value, sound->value);
        EXPECT_FALSE(library.sound(broken).ok());
        EXPECT_FALSE(library.sound(folder.path() / "absent.wav").ok());
    }
}

TEST(SoundImport, gives_back_every_16_bit_sample_exactly) {
    const std::initializer_list<std::int16_t> samples{0, 1, -1, 255, 12'345, -32'768, 32'767, -7};
    const SoundImport import(
        wav({.channels = 2, .rate_hz = 48'000, .data_bytes = 16}, pcm16(samples)));
    ASSERT_TRUE(import.sound.ok()) << import.error();
    EXPECT_EQ(import.sound->samples, std::vector<std::int16_t>(samples));
    EXPECT_EQ(import.sound->channels, 2);
    EXPECT_EQ(import.sound->sample_rate_hz, 48'000);
    EXPECT_EQ(import.log, "");
}

TEST(SoundImport, widens_8_bit_and_limits_floats) {
    const SoundImport bytes(wav({.bits = 8, .data_bytes = 2}, std::string("\x00\xC0", 2)));
    ASSERT_TRUE(bytes.sound.ok()) << bytes.error();
    EXPECT_EQ(bytes.sound->samples, (std::vector<std::int16_t>{-32'768, 16'384}));
    std::string data;
    append_bytes<float>(data, {0.5F, 2.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()});
    const SoundImport floats(wav({.bits = 32, .data_bytes = 16, .format = 3}, data));
    ASSERT_TRUE(floats.sound.ok()) << floats.error();
    EXPECT_EQ(floats.sound->samples, (std::vector<std::int16_t>{16'384, 32'767, -32'768, 0}));
}

// EXPERIENCE G24
TEST(SoundImport, takes_one_sample_and_192_khz) {
    const SoundImport import(wav({.rate_hz = 192'000, .data_bytes = 2}, pcm16({5})));
    ASSERT_TRUE(import.sound.ok()) << import.error();
    EXPECT_EQ(import.sound->samples, std::vector<std::int16_t>{5});
}

TEST(SoundImport, names_the_field_that_makes_no_sense) {
    const std::string data = pcm16({1, 2, 3, 4, 5, 6, 7, 8, 9});
    EXPECT_TRUE(contains(SoundImport(wav({.rate_hz = 0, .data_bytes = 18}, data)).error(),
                         "is refused: its sample rate is 0 Hz"));
    EXPECT_TRUE(contains(SoundImport(wav({.channels = 9, .data_bytes = 18}, data)).error(),
                         "is refused: it has 9 channels; 1 to 8 are read"));
    const SoundImport empty(wav({.data_bytes = 0}, ""));
    EXPECT_TRUE(contains(empty.error(), "is refused: it has 0 frames")) << empty.error();
    EXPECT_EQ(empty.sound.error().exit_code, ExitCode::Refused);
    EXPECT_FALSE(SoundImport("this is no sound").sound.ok());
}

/// A list with a part of -8 bytes: with it, libsndfile 1.2.0 opens a file for ever.
std::string endless_list() {
    constexpr char kChunk[] =
        "\x4c\x49\x53\x54\x35\x00\x00\x00\x49\x4e\x46\x4f\x65\x74\x69\x6d"
        "\xf8\xff\xff\xff\x88\x00\xff\xff\xff\x00\xff\xff\x00\x00\x42\xd2"
        "\xff\x00\x00\xff\x00\x00\x00\x6c\x61\x62\x6c\x10\x00\x00\x00\x00"
        "\x00\xff\x00\x00\xff\x00\x01\x00\x00\xff\x00\x21\x00";
    return {kChunk, sizeof(kChunk)};  // its last zero pads it to an even length
}

// EXPERIENCE B7
TEST(SoundImport, ends_with_chunks_that_libsndfile_never_leaves) {
    const std::string whole = wav({.data_bytes = 6}, pcm16({1, 2, 3}));
    const std::size_t data = whole.find("data");
    const SoundImport between(whole.substr(0, data) + endless_list() + whole.substr(data));
    ASSERT_TRUE(between.sound.ok()) << between.error();
    EXPECT_EQ(between.sound->samples, (std::vector<std::int16_t>{1, 2, 3}));
    const SoundImport behind(whole + endless_list());
    ASSERT_TRUE(behind.sound.ok()) << behind.error();
    EXPECT_EQ(behind.sound->samples, (std::vector<std::int16_t>{1, 2, 3}));
    const SoundImport alone(whole.substr(0, data) + endless_list());
    EXPECT_TRUE(contains(alone.error(), "is refused: it has no samples")) << alone.error();
}

TEST(SoundImport, takes_containers_that_are_asked_for_only) {
    const SoundImport aiff(std::string("FORM\0\0\0\x2e"
                                       "AIFFCOMM\0\0\0\x12",
                                       20) +
                           std::string(40, '\0'));
    EXPECT_TRUE(contains(aiff.error(), "its content is none of WAV, Ogg, FLAC and MP3"))
        << aiff.error();
    EXPECT_TRUE(contains(SoundImport("RIFF").error(), "none of WAV"));
    EXPECT_TRUE(contains(SoundImport(wav({}, "").substr(0, 20)).error(), "no samples"));
}

TEST(SoundImport, keeps_what_decoded_of_a_file_that_breaks_off) {
    const SoundImport import(wav({.data_bytes = 2'000}, pcm16({1, 2, 3})));
    ASSERT_TRUE(import.sound.ok()) << import.error();
    EXPECT_EQ(import.sound->samples, (std::vector<std::int16_t>{1, 2, 3}));
    EXPECT_TRUE(contains(import.log, "breaks off; the 0.00 s that decoded are used")) << import.log;
    EXPECT_EQ(import.log.find("breaks off"), import.log.rfind("breaks off"));  // once
}

TEST(SoundImport, keeps_what_decoded_of_an_ogg_that_breaks_off) {
    std::ifstream stream(fs::path(PL_SOURCE_DIR) / "assets/sounds/loop_fountain.ogg",
                         std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_GT(whole.size(), 20'000U);
    const SoundImport all(whole);
    const SoundImport half(std::string_view(whole).substr(0, whole.size() / 2));
    ASSERT_TRUE(all.sound.ok()) << all.error();
    ASSERT_TRUE(half.sound.ok()) << half.error();
    EXPECT_EQ(all.log, "");
    EXPECT_LT(half.sound->samples.size(), all.sound->samples.size() * 2 / 3);
    EXPECT_GT(half.sound->samples.size(), all.sound->samples.size() / 3);
    EXPECT_TRUE(contains(half.log, "breaks off")) << half.log;
}

// EXPERIENCE G24
TEST(SoundImport, refuses_more_than_its_limit) {
    // 8 bits a sample in the file become 16: one more frame than fits.
    constexpr std::uint32_t kFrames = limits::kSoundBytes / 2;
    const SoundImport most(wav({.bits = 8, .data_bytes = kFrames}, std::string(kFrames, '\x80')));
    ASSERT_TRUE(most.sound.ok()) << most.error();
    EXPECT_EQ(most.sound->samples.size(), kFrames);
    const SoundImport more(
        wav({.bits = 8, .data_bytes = kFrames + 1}, std::string(kFrames + 1, '\x80')));
    EXPECT_TRUE(contains(more.error(), "it has 33554433 frames; 33554432 of 1 channels are read"))
        << more.error();
}

}  // namespace
}  // namespace plumbline::assets::test
