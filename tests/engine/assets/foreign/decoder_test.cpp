// The process that decodes foreign files may crash, hang, answer nonsense or die half way: each is one
// message with the file's name, and no process stays behind. Its parts are played by shell scripts.
#include "engine/assets/foreign/decoder.h"

#include "tests/engine/assets/fixture.h"

#include <sys/wait.h>

#include <cerrno>

namespace plumbline::assets::test {
namespace {

constexpr std::string_view kLooksLikeCollada = "<?xml version=\"1.0\"?><COLLADA></COLLADA>";

class DecoderProcess : public ::testing::Test {
protected:
    /// A decoder that does that.
    Decoder decoder_of(const std::string& script, std::optional<double> limit_s = {}) {
        const fs::path program = folder_.write("reader", "#!/bin/sh\n" + script + "\n");
        fs::permissions(program, fs::perms::owner_all);
        return {.program = program, .limit_s = limit_s};
    }
    /// What is said of a model whose decoder does that.
    Error error_of(const std::string& script, std::optional<double> limit_s = {}) {
        const Decoder decoder = decoder_of(script, limit_s);
        ModelReferences references(folder_.path() / "m.dae", folder_.path());
        const Result<ModelData> model =
            read_foreign_model(kLooksLikeCollada, "m.dae", references, decoder);
        EXPECT_FALSE(model.ok());
        expect_nothing_is_left();
        return model.ok() ? Error{} : model.error();
    }

    void expect_nothing_is_left() const {
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(errno, ECHILD);
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1)
            << "only the reader lies there";
    }

    static void expect_refused(const Error& error, std::string_view why) {
        EXPECT_EQ(error.message, fmt::format("model m.dae is refused: {}", why));
        EXPECT_EQ(error.exit_code, ExitCode::Refused);
    }
    std::string reader() const { return (folder_.path() / "reader").string(); }

private:
    TempFolder folder_;
};

TEST_F(DecoderProcess, that_crashes_is_one_message) {
    expect_refused(error_of("kill -SEGV $$"),
                   "its reader was ended by signal 11 (Segmentation fault)");
    expect_refused(error_of("kill -ABRT $$"), "its reader was ended by signal 6 (Aborted)");
    expect_refused(error_of("exit 3"), "its reader ended with exit code 3");
}

TEST_F(DecoderProcess, that_is_killed_half_way_is_one_message) {
    expect_refused(error_of("printf Dhalf; kill -KILL $$"),
                   "its reader was ended by signal 9 (Killed)");
    expect_refused(error_of("kill -XCPU $$"),
                   "its reader was ended by signal 24 (CPU time limit exceeded)");
}

TEST_F(DecoderProcess, that_hangs_is_given_up) {
    expect_refused(error_of("printf D; exec sleep 600", 0.2),
                   reader() + " did not end within 0.2 s");
    // Whoever closes his output and stays is no better.
    expect_refused(error_of("exec >&-; exec sleep 600", 0.2),
                   "its reader was ended by signal 9 (Killed)");
}

TEST_F(DecoderProcess, that_answers_too_much_is_stopped) {
    const Result<SoundData> sound =
        decode_sound_apart("RIFF", "a.wav", decoder_of("exec cat /dev/zero"));
    ASSERT_FALSE(sound.ok());
    EXPECT_EQ(sound.error().message,
              fmt::format("sound a.wav is refused: {} answered too much", reader()));
}

TEST_F(DecoderProcess, that_answers_nonsense_is_not_believed) {
    expect_refused(error_of("exit 0"), "its reader says nothing");
    EXPECT_TRUE(contains(error_of("printf D").message, "model m.dae is refused: "));
    EXPECT_TRUE(contains(error_of("printf 'D%0500d' 0").message, "model m.dae is refused: "));
    EXPECT_EQ(error_of("printf 'Rmodel m.dae is refused: why not'").message,
              "model m.dae is refused: why not");
}

TEST_F(DecoderProcess, whose_image_or_sound_is_of_another_size_is_not_believed) {
    // 2 x 1 pixels of R8, then of a format that there is not, of no size, and 9 times too large.
    const std::string size = "printf 'D\\2\\0\\0\\0\\1\\0\\0\\0";
    const Result<ImageData> good =
        decode_image_apart("", "a.png", any_image_bytes, decoder_of(size + "\\0ab'"));
    ASSERT_TRUE(good.ok()) << good.error().message;
    EXPECT_EQ(good->bytes, (std::vector<std::uint8_t>{'a', 'b'}));
    for (const char* rest : {"\\0a'", "\\0abc'", "\\5ab'", "'"}) {
        const Result<ImageData> image =
            decode_image_apart("", "a.png", any_image_bytes, decoder_of(size + rest));
        ASSERT_FALSE(image.ok()) << rest;
        EXPECT_EQ(image.error().message, "image a.png is refused: its reader's answer breaks off");
    }
    const auto none = [](std::size_t) { return false; };
    EXPECT_TRUE(
        contains(decode_image_apart("", "a.png", none, decoder_of(size + "\\0ab'")).error().message,
                 "it takes 2 bytes; all images of a scene may take"));
    for (const char* answer : {"D",
                               "D\\1\\0\\0\\0\\1\\0\\0\\0",
                               "D\\1\\0\\0\\0\\0\\0\\0\\0ab",
                               "D\\1\\0\\0\\0\\1\\0\\0\\0abc"}) {
        const Result<SoundData> sound =
            decode_sound_apart("", "a.ogg", decoder_of(fmt::format("printf '{}'", answer)));
        ASSERT_FALSE(sound.ok()) << answer;
        EXPECT_EQ(sound.error().message, "sound a.ogg is refused: its reader's answer breaks off");
    }
}

TEST_F(DecoderProcess, that_is_not_there_is_one_message) {
    const TempFolder folder;
    ModelReferences references(folder.path() / "m.dae", folder.path());
    const Result<ModelData> model = read_foreign_model(
        kLooksLikeCollada, "m.dae", references, {.program = folder.path() / "none"});
    ASSERT_FALSE(model.ok());
    expect_refused(
        model.error(),
        fmt::format("cannot start {}/none: No such file or directory", folder.path().string()));
}

}  // namespace
}  // namespace plumbline::assets::test
