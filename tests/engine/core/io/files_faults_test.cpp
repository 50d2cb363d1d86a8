// What happens to a save when the system fails it, call by call, and when the program is killed.

#include "engine/core/io/files.h"
#include "engine/core/io/files_impl.h"
#include "engine/core/io/output.h"
#include "engine/core/random.h"
#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

constexpr int kNever = -1;

/// Lets the n-th system call of core/files fail, and remembers which calls were made.
struct Faults {
    int fail_at{kNever};  ///< from 0
    int error{EIO};
    std::vector<std::string_view> calls;

    /// True when this call is the one to fail; sets errno.
    bool strikes(std::string_view call) {
        calls.push_back(call);
        if (static_cast<int>(calls.size()) - 1 != fail_at) return false;
        errno = error;
        return true;
    }
};

Faults faults;

/// The table that counts and fails, while it lives.
class FaultyCalls {
public:
    FaultyCalls(int fail_at, int error) : before_(file_calls()) {
        faults = {.fail_at = fail_at, .error = error, .calls = {}};
        file_calls() = {
            .open =
                [](const char* path, int flags, mode_t mode) {
                    return faults.strikes("open") ? -1 : ::open(path, flags, mode);
                },
            .read =
                [](int file, void* bytes, std::size_t count) {
                    return faults.strikes("read") ? ssize_t{-1} : ::read(file, bytes, count);
                },
            // Short writes, as a nearly full disk gives them: a save takes several.
            .write =
                [](int file, const void* bytes, std::size_t count) {
                    const std::size_t some = count > 2 ? count / 2 : count;
                    return faults.strikes("write") ? ssize_t{-1} : ::write(file, bytes, some);
                },
            .sync = [](int file) { return faults.strikes("sync") ? -1 : ::fsync(file); },
            .close =
                [](int file) {
                    const bool fails = faults.strikes("close");
                    const int closed = ::close(file);  // closed either way, as Linux does it
                    if (fails) errno = faults.error;
                    return fails ? -1 : closed;
                },
            .rename =
                [](const char* from, const char* to) {
                    return faults.strikes("rename") ? -1 : std::rename(from, to);
                }};
    }
    ~FaultyCalls() { file_calls() = before_; }
    FaultyCalls(const FaultyCalls&) = delete;
    FaultyCalls& operator=(const FaultyCalls&) = delete;

private:
    FileCalls before_;
};

std::vector<std::string_view> calls_of_a_good_save() {
    const TemporaryFolder folder;
    folder.write("save", "old");
    const FaultyCalls calls(kNever, 0);
    EXPECT_TRUE(write_file_atomically(folder / "save", "brand new"));
    return faults.calls;
}

TEST(SaveFaults, ASaveStoresTheFileBeforeItTakesTheOldOnesPlace) {
    EXPECT_EQ(calls_of_a_good_save(),
              (std::vector<std::string_view>{"open",
                                             "write",
                                             "write",
                                             "write",
                                             "write",
                                             "sync",
                                             "close",
                                             "rename",
                                             "open",
                                             "sync",
                                             "close"}));
}

TEST(SaveFaults, WhicheverCallFailsTheFileIsOldOrNewAndNothingIsLeftBeside) {
    const auto calls = calls_of_a_good_save();
    const TemporaryFolder folder;
    for (int n = 0; n < static_cast<int>(calls.size()); ++n) {
        for (const int error : {ENOSPC, EIO, EACCES}) {
            folder.write("save", "old");
            const FaultyCalls faulty(n, error);
            const auto saved = write_file_atomically(folder / "save", "brand new");
            const bool replaced = n > 7;  // behind the rename
            EXPECT_EQ(saved.ok(), replaced) << calls[static_cast<std::size_t>(n)] << " at " << n;
            EXPECT_EQ(folder.read("save"), replaced ? "brand new" : "old");
            EXPECT_EQ(folder.count(), 1U);
        }
    }
}

TEST(SaveFaults, TheMessageSaysWhatFailedAndWhy) {
    const TemporaryFolder folder;
    const std::string file = (folder / "save").string();
    const auto message_when = [&](int n, int error) {
        const FaultyCalls faulty(n, error);
        const auto saved = write_file_atomically(file, "brand new");
        return saved ? "saved" : saved.error().message;
    };
    EXPECT_EQ(message_when(0, EACCES),
              "cannot create a file beside " + file + ": Permission denied");
    EXPECT_EQ(message_when(2, ENOSPC), "cannot write " + file + ": No space left on device");
    EXPECT_EQ(message_when(5, EIO), "cannot store " + file + ": Input/output error");
    EXPECT_EQ(message_when(6, EDQUOT), "cannot finish " + file + ": Disk quota exceeded");
    EXPECT_EQ(message_when(7, EXDEV), "cannot replace " + file + ": Invalid cross-device link");
}

TEST(SaveFaults, AnInterruptedWriteGoesOn) {
    const TemporaryFolder folder;
    const FaultyCalls faulty(2, EINTR);
    EXPECT_TRUE(write_file_atomically(folder / "save", "brand new"));
    EXPECT_EQ(folder.read("save"), "brand new");
}

TEST(SaveFaults, ReadingReportsWhatFails) {
    const TemporaryFolder folder;
    const std::string file = folder.write("save", "old").string();
    {
        const FaultyCalls faulty(1, EIO);
        const auto read = read_file(file, 100);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().message, "cannot read " + file + ": Input/output error");
    }
    const FaultyCalls faulty(1, EINTR);
    EXPECT_EQ(*read_file(file, 100), "old");
}

/// Runs `work` in a child process; gives what waitpid() says of it.
template <class Work>
int status_of_child(Work work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        std::_Exit(0);
    }
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

// The kernel's own refusal, not a stand-in: the file-size limit stops a write half-way.
TEST(SaveFaults, AFileThatTheSystemCutsShortIsNoSave) {
    const TemporaryFolder folder;
    folder.write("save", "old");
    const int status = status_of_child([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{.rlim_cur = 4096, .rlim_max = 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const auto saved = write_file_atomically(folder / "save", std::string(10'000, 'x'));
        const bool as_expected =
            !saved && saved.error().message.find("File too large") != std::string::npos;
        std::_Exit(as_expected ? 7 : 1);
    });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(folder.read("save"), "old");
    EXPECT_EQ(folder.count(), 1U);
}

/// All of one letter, so that half of one and half of another would show.
std::string contents(int version) {
    return std::string(40'000, static_cast<char>('a' + version));
}

TEST(SaveFaults, KilledAtRandomTheFileIsAlwaysWhole) {
    constexpr int kRounds = 200;
    const TemporaryFolder folder;
    const fs::path file = folder.write("save", contents(0));
    Random random(11);
    int replaced = 0;
    for (int round = 0; round < kRounds; ++round) {
        const std::string before = folder.read("save");
        const pid_t child = ::fork();
        if (child == 0) {
            // A kill is no power cut: what was written is there, stored or not, and saves are quick.
            file_calls().sync = [](int) { return 0; };
            for (int version = 0;; version = (version + 1) % 26) {
                if (!write_file_atomically(file, contents(version))) std::_Exit(1);
            }
        }
        ::usleep(500 + random.below(4'000));
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "a save failed";
        const std::string after = folder.read("save");
        ASSERT_EQ(after, contents(after.empty() ? 0 : after.front() - 'a')) << "round " << round;
        if (after != before) ++replaced;
    }
    EXPECT_GT(replaced, 0) << "no save ever came to its end: the test tests nothing";
}

/// Makes a file look as if it was last written so long ago.
/// A second more than asked for is safe: time() may be a tick behind this clock, and so a second.
void make_older(const fs::path& file, long age_s) {
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    const timespec then{.tv_sec = now.tv_sec - age_s, .tv_nsec = 0};
    const timespec times[2] = {then, then};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
}

TEST(SaveFaults, WhatAKilledSaveLeftGoesWithALaterOne) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("save", "old");
    const int status = status_of_child([&] {
        file_calls().sync = [](int) { return ::raise(SIGKILL); };
        static_cast<void>(write_file_atomically(file, "never finished"));
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(folder.count(), 2U) << "the killed save left its temporary file";

    ASSERT_TRUE(write_file_atomically(file, "new"));
    EXPECT_EQ(folder.count(), 2U) << "young: it could still be somebody's";
    for (const auto& entry : fs::directory_iterator(folder.path())) make_older(entry.path(), 3600);
    ASSERT_TRUE(write_file_atomically(folder / "other", "newer")) << "whatever is saved there";
    EXPECT_EQ(folder.count(), 2U);
    EXPECT_EQ(folder.read("save"), "new");
}

constexpr int kNobody = 999'999'999;  // beyond every system's last process

/// As a save of a process names its file meanwhile.
std::string saving_by(int process, int number) {
    return ".plumbline-saving-" + std::to_string(process) + "-5-" + std::to_string(number);
}

// EXPERIENCE E2: at a start, without a save.
TEST(SaveFaults, WhatKilledSavesLeftCanBeSwept) {
    const TemporaryFolder folder;
    for (int i = 0; i < 32; ++i) make_older(folder.write(saving_by(kNobody, i), "half"), 62);
    folder.write(saving_by(kNobody, 32), "young");
    make_older(folder.write(saving_by(::getpid(), 1), "a film that waits for its next frame"), 600);
    remove_stale_saves(folder.path());
    EXPECT_EQ(folder.count(), 2U);
    remove_stale_saves(folder / "no such folder");
}

TEST(SaveFaults, WhatKilledSavesLeftCanBeSweptInAllFoldersBelow) {
    const TemporaryFolder folder;
    const TemporaryFolder elsewhere;
    fs::create_directories(folder / "saves/garden");
    fs::create_directory_symlink(elsewhere.path(), folder / "link");
    for (const char* below : {"", "saves/", "saves/garden/", "link/"})
        make_older(folder.write(below + saving_by(kNobody, 1), "half"), 62);
    folder.write("saves/garden/slot_1", "whole");
    remove_stale_saves_below(folder.path());
    EXPECT_EQ(folder.count(), 2U) << "saves and the link";
    EXPECT_FALSE(fs::exists(folder / ("saves/" + saving_by(kNobody, 1))));
    EXPECT_FALSE(fs::exists(folder / ("saves/garden/" + saving_by(kNobody, 1))));
    EXPECT_EQ(folder.read("saves/garden/slot_1"), "whole");
    EXPECT_EQ(elsewhere.count(), 1U) << "links lead to folders that may not be ours";
}

// What another program writes, as ffmpeg a film.
TEST(SaveFaults, AFileBesideTakesThePlaceWithModeAndEnding) {
    const TemporaryFolder folder;
    const fs::path film = folder.write("film.mp4", "earlier");
    fs::permissions(film, fs::perms::owner_read | fs::perms::owner_write);
    const Result<fs::path> beside = make_file_beside(film);
    ASSERT_TRUE(beside.ok());
    EXPECT_EQ(beside->extension(), ".mp4");
    EXPECT_EQ(folder.read("film.mp4"), "earlier");
    folder.write(beside->filename().string(), "later");
    ASSERT_TRUE(replace_by(film, *beside));
    EXPECT_EQ(folder.read("film.mp4"), "later");
    EXPECT_EQ(fs::status(film).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(folder.count(), 1U);
    EXPECT_FALSE(replace_by(film, folder / "no such file"));
    EXPECT_EQ(folder.read("film.mp4"), "later");
    EXPECT_FALSE(make_file_beside(folder / "no such folder/film.mp4"));
}

TEST(SaveFaults, OtherPeoplesFilesAreLeftAlone) {
    const TemporaryFolder folder;
    for (const char* name : {"save",
                             "save.backup",
                             "plumbline-saving-1",
                             ".save",
                             ".plumbline",
                             ".other.plumbline-saving-1-2-3"}) {
        make_older(folder.write(name, "x"), 3600);
    }
    fs::create_directory(folder / ".plumbline-saving-a folder");
    make_older(folder / ".plumbline-saving-a folder", 3600);
    ASSERT_TRUE(write_file_atomically(folder / "save", "new"));
    EXPECT_EQ(folder.count(), 7U);
}

}  // namespace
}  // namespace plumbline
