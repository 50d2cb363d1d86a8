#include "engine/core/io/files.h"

#include "engine/core/io/files_impl.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <thread>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using test::ScopedVariable;
using test::TemporaryFolder;

/// Works in `folder` while it lives.
class ScopedCurrentFolder {
public:
    explicit ScopedCurrentFolder(const fs::path& folder) : before_(fs::current_path()) {
        fs::current_path(folder);
    }
    ~ScopedCurrentFolder() { fs::current_path(before_); }
    ScopedCurrentFolder(const ScopedCurrentFolder&) = delete;
    ScopedCurrentFolder& operator=(const ScopedCurrentFolder&) = delete;

private:
    fs::path before_;
};

TEST(ReadFile, GivesTheBytesAsTheyAre) {
    const TemporaryFolder folder;
    const std::string bytes("a\r\n\0\xff", 5);
    EXPECT_EQ(*read_file(folder.write("a", bytes), 100), bytes);
    EXPECT_EQ(*read_file(folder.write("empty", ""), 100), "");
}

TEST(ReadFile, TakesItsLimitAndNoByteMore) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("a", "12345");
    EXPECT_TRUE(read_file(file, 5));
    const auto refused = read_file(file, 4);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, file.string() + " has 5 bytes; at most 4 are read");
}

TEST(ReadFile, NamesWhatIsNotThere) {
    const TemporaryFolder folder;
    const auto missing = read_file(folder / "none", 100);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              "cannot open " + (folder / "none").string() + ": No such file or directory");
}

TEST(ReadFile, RefusesFoldersPipesAndDevicesWithoutHanging) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const fs::path& path : {pipe, folder.path(), fs::path("/dev/zero")}) {
        const auto refused = read_file(path, 100);
        ASSERT_FALSE(refused) << path;
        EXPECT_EQ(refused.error().message, path.string() + " is not a regular file");
    }
}

TEST(WriteFile, MakesAndReplaces) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.toml";
    ASSERT_TRUE(write_file_atomically(file, "first"));
    EXPECT_EQ(folder.read("a.toml"), "first");
    ASSERT_TRUE(write_file_atomically(file, std::string("sec\0nd", 6)));
    EXPECT_EQ(folder.read("a.toml"), std::string("sec\0nd", 6));
    ASSERT_TRUE(write_file_atomically(file, ""));
    EXPECT_EQ(folder.read("a.toml"), "");
    EXPECT_EQ(folder.count(), 1U) << "nothing is left beside it";
}

TEST(WriteFile, TakesAnyNameAPersonCanType) {
    const TemporaryFolder folder;
    for (const char* name : {"two words",
                             "it's \"quoted\"",
                             "line\nbreak",
                             "$(reboot); `x` & *",
                             "not utf-8 \xff\xfe",
                             "-rf",
                             "grün.toml",
                             "%2e%2e"}) {
        ASSERT_TRUE(write_file_atomically(folder / name, name)) << name;
        EXPECT_EQ(*read_file(folder / name, 100), name);
    }
    EXPECT_EQ(folder.count(), 8U);
}

TEST(WriteFile, WorksInTheCurrentFolder) {
    const TemporaryFolder folder;
    const ScopedCurrentFolder here(folder.path());
    ASSERT_TRUE(write_file_atomically("bare.txt", "x"));
    EXPECT_EQ(folder.read("bare.txt"), "x");
}

TEST(WriteFile, ALinkStaysALink) {
    const TemporaryFolder folder;
    const fs::path real = folder.write("dotfiles/bindings.toml", "old");
    fs::create_directory(folder / "config");
    fs::create_symlink(real, folder / "config/bindings.toml");
    ASSERT_TRUE(write_file_atomically(folder / "config/bindings.toml", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "config/bindings.toml"));
    EXPECT_EQ(folder.read("dotfiles/bindings.toml"), "new");
}

TEST(WriteFile, ACircleOfLinksStays) {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    const auto written = write_file_atomically(folder / "a", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message,
              "cannot write " + (folder / "a").string() + ": Too many levels of symbolic links");
    EXPECT_TRUE(fs::is_symlink(folder / "a"));
}

TEST(WriteFile, AReplacedFileKeepsItsModeAndOwner) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("private", "old");
    const bool is_root = ::geteuid() == 0;  // only root can give files away
    if (is_root) {
        ASSERT_EQ(::chown(file.c_str(), 1234, 2345), 0);
    }
    ASSERT_EQ(::chmod(file.c_str(), 0620), 0);
    ASSERT_TRUE(write_file_atomically(file, "new"));
    struct stat status {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0620U);
    EXPECT_EQ(status.st_uid, is_root ? 1234U : ::geteuid());
    EXPECT_EQ(status.st_gid, is_root ? 2345U : ::getegid());
    EXPECT_EQ(folder.read("private"), "new");
}

// EXPERIENCE E14
TEST(WriteFile, TakesTheLongestNamesThatTheSystemTakes) {
    const TemporaryFolder folder;
    for (const std::size_t length : {230U, 255U}) {
        const std::string name(length, 'n');
        ASSERT_TRUE(write_file_atomically(folder / name, "x")) << length;
        EXPECT_EQ(folder.read(name), "x");
    }
    const auto too_long = write_file_atomically(folder / std::string(256, 'n'), "x");
    ASSERT_FALSE(too_long);
    EXPECT_NE(too_long.error().message.find("File name too long"), std::string::npos);
}

TEST(WriteFile, RefusesWhatIsNoFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const auto written = write_file_atomically(folder / "pipe", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, (folder / "pipe").string() + " is not a regular file");
    EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(WriteFile, CanBeTriedOut) {
    const TemporaryFolder folder;
    folder.write("old", "old");
    EXPECT_TRUE(check_writable(folder / "old"));
    EXPECT_TRUE(check_writable(folder / "new"));
    EXPECT_FALSE(check_writable(folder / "no folder" / "new"));
    EXPECT_FALSE(check_writable(folder.path()));
    EXPECT_EQ(folder.read("old"), "old");
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, RespectsTheMaskForNewFiles) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(0077);
    const auto written = write_file_atomically(folder / "private", "x");
    ::umask(before);
    ASSERT_TRUE(written);
    EXPECT_EQ(fs::status(folder / "private").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteFile, SaysWhereItCannotWrite) {
    const TemporaryFolder folder;
    const fs::path nowhere = folder / "no folder" / "a";
    const auto missing = write_file_atomically(nowhere, "x");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              "cannot create a file beside " + nowhere.string() + ": No such file or directory");
    fs::create_directory(folder / "folder");
    const auto onto_folder = write_file_atomically(folder / "folder", "x");
    ASSERT_FALSE(onto_folder);
    EXPECT_EQ(onto_folder.error().message,
              "cannot write " + (folder / "folder").string() + ": Is a directory");
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, TwoAtOnceLeaveOneWhole) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a";
    const std::string ones(100'000, '1');
    const std::string twos(70'000, '2');
    const auto save_often = [&](const std::string& bytes) {
        for (int i = 0; i < 50; ++i) EXPECT_TRUE(write_file_atomically(file, bytes));
    };
    std::thread other(save_often, ones);
    save_often(twos);
    other.join();
    const std::string left = folder.read("a");
    EXPECT_TRUE(left == ones || left == twos) << left.size();
    EXPECT_EQ(folder.count(), 1U);
}

/// What resolve_inside says about `reference`, below the folder that holds pack/.
std::string refusal(const TemporaryFolder& folder, std::string_view reference) {
    const auto resolved = resolve_inside(folder / "pack", reference);
    if (resolved) return "accepted: " + resolved->string();
    EXPECT_EQ(resolved.error().exit_code, ExitCode::Refused);
    return resolved.error().message;
}

TEST(ResolveInside, FindsWhatIsBelow) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("pack/textures/old oak's \"bark\".png", "x");
    const fs::path pack = folder / "pack";
    EXPECT_EQ(*resolve_inside(pack, "textures/old oak's \"bark\".png"), file);
    EXPECT_EQ(*resolve_inside(pack, "./textures/../textures/old oak's \"bark\".png"), file);
    EXPECT_EQ(*resolve_inside(pack, "not/yet/there.png"), pack / "not/yet/there.png");
    EXPECT_EQ(*resolve_inside(pack, "..."), pack / "...") << "a name like any other";
}

TEST(ResolveInside, RefusesEveryWayOut) {
    const TemporaryFolder folder;
    folder.write("pack/a.png", "x");
    folder.write("secret", "x");
    EXPECT_EQ(refusal(folder, ""), "\"\" names no file");
    EXPECT_EQ(refusal(folder, "../secret"), "\"../secret\" leads out of its folder");
    EXPECT_EQ(refusal(folder, "a/../../pack/a.png"),
              "\"a/../../pack/a.png\" leads out of its folder");
    EXPECT_EQ(refusal(folder, "/etc/passwd"), "\"/etc/passwd\" is absolute; paths are relative");
    EXPECT_EQ(refusal(folder, "\\\\host\\share"),
              "\"\\\\host\\share\" is absolute; paths are relative");
    EXPECT_EQ(refusal(folder, "C:/secret"),
              "\"C:/secret\" names a drive or a URL; paths are relative");
    EXPECT_EQ(refusal(folder, "https://example.org/a.png"),
              "\"https://example.org/a.png\" names a drive or a URL; paths are relative");
    EXPECT_NE(refusal(folder, std::string_view("a.png\0.txt", 10)).find("holds a NUL byte"),
              std::string::npos);
}

TEST(ResolveInside, FollowsLinksOnlyWithin) {
    const TemporaryFolder folder;
    folder.write("pack/real/a.png", "x");
    folder.write("outside/secret", "x");
    fs::create_symlink("real", folder / "pack/alias");
    fs::create_symlink("../outside", folder / "pack/leak");
    fs::create_symlink("loop", folder / "pack/loop");
    EXPECT_TRUE(resolve_inside(folder / "pack", "alias/a.png"));
    EXPECT_EQ(refusal(folder, "leak/secret"),
              "\"leak/secret\" leads out of its folder through a link");
    EXPECT_EQ(refusal(folder, "leak/not there"),
              "\"leak/not there\" leads out of its folder through a link");
    EXPECT_EQ(refusal(folder, "loop/a"), "\"loop/a\" leads out of its folder through a link");
}

TEST(ResolveInside, PercentSignsAreLetters) {
    const TemporaryFolder folder;
    EXPECT_EQ(*resolve_inside(folder.path(), "%2e%2e/secret"), folder / "%2e%2e/secret");
}

// A scene named without a folder, in the folder where one stands.
TEST(ResolveInside, AnEmptyRootIsTheCurrentFolder) {
    const TemporaryFolder folder;
    folder.write("a.png", "x");
    const ScopedCurrentFolder here(folder.path());
    EXPECT_EQ(*resolve_inside("", "a.png"), "a.png");
    EXPECT_EQ(*resolve_inside("", "not there.png"), "not there.png");
    EXPECT_FALSE(resolve_inside("", "../a.png"));
}

TEST(IsInside, ComparesFoldersNotLetters) {
    const TemporaryFolder folder;
    folder.write("pack/a", "x");
    folder.write("packed/a", "x");
    EXPECT_TRUE(is_inside(folder / "pack", folder / "pack"));
    EXPECT_TRUE(is_inside(folder / "pack", folder / "pack/a"));
    EXPECT_TRUE(is_inside(folder / "pack", folder / "packed/../pack/a"));
    EXPECT_FALSE(is_inside(folder / "pack", folder / "packed/a"));
    EXPECT_FALSE(is_inside(folder / "pack", folder.path()));
}

TEST(DataFolders, AreFoundWhereTheVariableSays) {
    const TemporaryFolder folder;
    for (const char* name : {"assets/x", "shaders/x", "config/x"}) folder.write(name, "");
    const ScopedVariable data("PLUMBLINE_DATA", folder.path().string());
    const auto found = find_data_folders();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->shaders, folder / "shaders");
}

TEST(DataFolders, ThatAreNamedAndAreNotThereAreAnError) {
    const TemporaryFolder folder;
    folder.write("assets/x", "");
    const ScopedVariable data("PLUMBLINE_DATA", folder.path().string());
    const auto found = find_data_folders();
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().message,
              "PLUMBLINE_DATA (or --data) names " + folder.path().string() +
                  ", which does not hold the program's data: assets, shaders and config");
}

TEST(DataFolders, AreFoundAboveTheProgramNotInTheCurrentFolder) {
    const TemporaryFolder elsewhere;
    for (const char* name : {"assets/x", "shaders/x", "config/x"}) elsewhere.write(name, "");
    const ScopedVariable data("PLUMBLINE_DATA", "relative/counts/as/unset");
    const ScopedCurrentFolder here(elsewhere.path());
    const auto found = find_data_folders();
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_TRUE(fs::equivalent(found->assets, fs::path(PL_SOURCE_DIR) / "assets"));
}

TEST(UserFolders, FollowTheDesktopsConvention) {
    const ScopedVariable home("HOME", "/somebody");
    {
        const ScopedVariable config("XDG_CONFIG_HOME", "/somebody/settings");
        const ScopedVariable data("XDG_DATA_HOME", "/somebody/data");
        EXPECT_EQ(user_config_folder(), "/somebody/settings/plumbline");
        EXPECT_EQ(user_data_folder(), "/somebody/data/plumbline");
    }
    for (const char* unset : {"", "relative/folder"}) {
        const ScopedVariable config("XDG_CONFIG_HOME", unset);
        const ScopedVariable data("XDG_DATA_HOME", unset);
        EXPECT_EQ(user_config_folder(), "/somebody/.config/plumbline");
        EXPECT_EQ(user_data_folder(), "/somebody/.local/share/plumbline");
        const ScopedVariable no_home("HOME", "");
        EXPECT_EQ(user_config_folder(), "");
    }
}

}  // namespace
}  // namespace plumbline
