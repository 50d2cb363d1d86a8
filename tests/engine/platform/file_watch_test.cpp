#include "engine/platform/file_watch.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace plumbline::platform {
namespace {
namespace fs = std::filesystem;

/// Time is what the test says; only the kernel's own news need a real moment.
class FileWatchTest : public testing::Test {
protected:
    std::vector<fs::path> after(double seconds) {
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
        now_s_ += seconds;
        return watch_.take_changed(now_s_);
    }

    test::TemporaryFolder folder_;
    fs::path file_ = folder_.write("bindings.toml", "a");
    FileWatch watch_{{file_, folder_ / "missing.toml"}};
    double now_s_{100.0};
};

TEST_F(FileWatchTest, NothingChangedIsNothing) {
    EXPECT_TRUE(after(0.0).empty());
    EXPECT_TRUE(after(10.0).empty());
}

TEST_F(FileWatchTest, AWriteIsToldOnceItHasSettled) {
    EXPECT_TRUE(after(0.0).empty());
    folder_.write("bindings.toml", "ab");
    EXPECT_TRUE(after(0.05).empty());  // seen now; 150 ms must pass
    EXPECT_TRUE(after(0.14).empty());
    EXPECT_EQ(after(0.02), std::vector<fs::path>{file_});
    EXPECT_TRUE(after(1.0).empty());
}

TEST_F(FileWatchTest, AHalfWrittenFileWaitsForTheRest) {  // D12
    folder_.write("bindings.toml", "");
    EXPECT_TRUE(after(0.1).empty());
    folder_.write("bindings.toml", "abc");
    EXPECT_TRUE(after(0.1).empty());
    EXPECT_TRUE(after(0.1).empty());
    EXPECT_EQ(after(0.06).size(), 1U);
}

TEST_F(FileWatchTest, SavingByRenameIsOneChangeEachTime) {  // D13
    for (int i = 0; i < 3; ++i) {
        const fs::path temporary =
            folder_.write("bindings.toml~", std::string(5, 'x') + char('a' + i));
        fs::rename(temporary, file_);
        EXPECT_TRUE(after(0.0).empty());
        EXPECT_EQ(after(0.2), std::vector<fs::path>{file_}) << i;
        EXPECT_TRUE(after(0.2).empty()) << i;
    }
}

TEST_F(FileWatchTest, DeletedReplacedByAFolderAndBack) {
    fs::remove(file_);
    EXPECT_TRUE(after(0.0).empty());
    EXPECT_EQ(after(0.2).size(), 1U);
    fs::create_directory(file_);
    EXPECT_TRUE(after(0.0).empty());
    EXPECT_EQ(after(0.2).size(), 1U);
    fs::remove(file_);
    folder_.write("bindings.toml", "back");
    EXPECT_TRUE(after(0.0).empty());
    EXPECT_EQ(after(0.2).size(), 1U);
}

TEST_F(FileWatchTest, FilesThatComeIntoBeingAreTold) {
    folder_.write("missing.toml", "x");
    folder_.write("other.toml", "x");
    EXPECT_TRUE(after(0.0).empty());
    EXPECT_EQ(after(0.2), std::vector<fs::path>{folder_ / "missing.toml"});
}

TEST(FileWatch, FoldersThatComeIntoBeingAreTold) {
    const test::TemporaryFolder folder;
    FileWatch watch({folder / "later/bindings.toml"});
    EXPECT_TRUE(watch.take_changed(0.0).empty());
    folder.write("later/bindings.toml", "x");
    EXPECT_TRUE(watch.take_changed(1.1).empty());  // looked for once a second
    EXPECT_EQ(watch.take_changed(1.3).size(), 1U);
}

TEST(FileWatch, TenThousandChangesOverflowNothing) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.write("a", "x");
    FileWatch watch({file});
    for (int i = 0; i < 20'000; ++i) {
        std::error_code ignored;
        fs::rename(folder / (i % 2 == 0 ? "a" : "b"), folder / (i % 2 == 0 ? "b" : "a"), ignored);
    }
    folder.write("a", "changed");
    EXPECT_TRUE(watch.take_changed(1.0).empty());
    EXPECT_EQ(watch.take_changed(1.2).size(), 1U);
}

}  // namespace
}  // namespace plumbline::platform
