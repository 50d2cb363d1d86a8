// The process that reads Collada and FBX may crash, hang, babble or die half way: each is one
// message with the file's name, and nobody stays behind. Its parts are played by shell scripts.
#include "engine/assets/foreign/foreign_import_impl.h"
#include "tests/engine/assets/fixture.h"

#include <sys/wait.h>

#include <cerrno>

namespace plumbline::assets::test {
namespace {

constexpr std::string_view kLooksLikeCollada = "<?xml version=\"1.0\"?><COLLADA></COLLADA>";

class ForeignWorker : public ::testing::Test {
protected:
    /// What import says of a file whose reader does that.
    Error error_of(const std::string& script, ForeignReader reader = {}) {
        reader.program = folder_.write("reader", "#!/bin/sh\n" + script + "\n");
        fs::permissions(reader.program, fs::perms::owner_all);
        const fs::path file = folder_.write("m.dae", kLooksLikeCollada);
        ModelReferences references(file, folder_.path());
        const Result<ModelData> model =
            import_foreign(file, kLooksLikeCollada, "m.dae", references, reader);
        EXPECT_FALSE(model.ok());
        expect_nothing_is_left();
        return model.ok() ? Error{} : model.error();
    }

    void expect_nothing_is_left() const {
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(errno, ECHILD);
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 2)
            << "only the reader and the model lie there";
    }

    static void expect_refused(const Error& error, std::string_view why) {
        EXPECT_EQ(error.message, fmt::format("model m.dae is refused: {}", why));
        EXPECT_EQ(error.exit_code, ExitCode::Refused);
    }
    std::string reader() const { return (folder_.path() / "reader").string(); }

private:
    TempFolder folder_;
};

TEST_F(ForeignWorker, that_crashes_is_one_message) {
    expect_refused(error_of("kill -SEGV $$"),
                   "its reader was ended by signal 11 (Segmentation fault)");
    expect_refused(error_of("kill -ABRT $$"), "its reader was ended by signal 6 (Aborted)");
    expect_refused(error_of("exit 3"), "its reader ended with exit code 3");
}

TEST_F(ForeignWorker, that_is_killed_half_way_is_one_message) {
    expect_refused(error_of("printf Mhalf; kill -KILL $$"),
                   "its reader was ended by signal 9 (Killed)");
    expect_refused(error_of("kill -XCPU $$"),
                   "its reader was ended by signal 24 (CPU time limit exceeded)");
}

TEST_F(ForeignWorker, that_hangs_is_given_up) {
    expect_refused(error_of("printf M; exec sleep 600", {.most_s = 0.2}),
                   reader() + " did not end within 0.2 s");
    // Whoever closes his output and stays is no better.
    expect_refused(error_of("exec >&-; exec sleep 600", {.most_s = 0.2}),
                   "its reader was ended by signal 9 (Killed)");
}

TEST_F(ForeignWorker, that_answers_too_much_is_stopped) {
    expect_refused(error_of("exec cat /dev/zero", {.most_bytes = 1'000'000}),
                   reader() + " answered more than 1000000 bytes");
}

TEST_F(ForeignWorker, that_answers_nonsense_is_not_believed) {
    expect_refused(error_of("exit 0"), "its reader says nothing");
    expect_refused(error_of("printf M"), "its reader's answer breaks off");
    expect_refused(error_of("printf 'M%0500d' 0"), "its reader's answer breaks off");
    EXPECT_EQ(error_of("printf 'Emodel m.dae is refused: why not'").message,
              "model m.dae is refused: why not");
}

TEST_F(ForeignWorker, that_is_not_there_is_one_message) {
    const TempFolder folder;
    const fs::path file = folder.write("m.dae", kLooksLikeCollada);
    ModelReferences references(file, folder.path());
    const Result<ModelData> model = import_foreign(
        file, kLooksLikeCollada, "m.dae", references, {.program = folder.path() / "none"});
    ASSERT_FALSE(model.ok());
    expect_refused(
        model.error(),
        fmt::format("cannot start {}/none: No such file or directory", folder.path().string()));
}

}  // namespace
}  // namespace plumbline::assets::test
