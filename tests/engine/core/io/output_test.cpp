#include "engine/core/io/output.h"

#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <thread>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// All that a FIFO gives until its writer closes it.
std::string read_to_end(const fs::path& pipe) {
    const int file = ::open(pipe.c_str(), O_RDONLY | O_CLOEXEC);
    std::string text;
    char buffer[4096];
    for (ssize_t got = 0; (got = ::read(file, buffer, sizeof(buffer))) > 0;)
        text.append(buffer, static_cast<std::size_t>(got));
    ::close(file);
    return text;
}

TEST(Output, FilesAreReplacedAndLinksFollowed) {
    const TemporaryFolder folder;
    folder.write("real", "old");
    fs::create_symlink("real", folder / "link");
    ASSERT_TRUE(check_output(folder / "link"));
    ASSERT_TRUE(write_output(folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(folder.read("real"), "new");
}

TEST(Output, AGrowingOneIsThereAsItGrowsAndKeepsModeAndLinks) {
    const TemporaryFolder folder;
    ASSERT_EQ(::chmod(folder.write("real", "a longer text").c_str(), 0600), 0);
    fs::create_symlink("real", folder / "link");
    EXPECT_TRUE(is_replaced(folder / "link"));
    EXPECT_FALSE(is_replaced("/dev/null"));
    EXPECT_FALSE(is_replaced("-"));
    GrowingOutput out;
    EXPECT_TRUE(out.write("nothing was opened"));
    ASSERT_TRUE(out.open(folder / "link"));
    EXPECT_TRUE(out.write("one\n"));
    EXPECT_EQ(folder.read("real"), "one\n");
    EXPECT_TRUE(out.write("two\n"));
    EXPECT_EQ(folder.read("real"), "one\ntwo\n");
    EXPECT_TRUE(out.close());
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fs::status(folder / "real").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_FALSE(out.open(folder / "none" / "file"));
}

TEST(Output, AFifoHasAReaderAndStays) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    ASSERT_TRUE(check_output(pipe)) << "must not wait for the reader";
    const std::string text(200'000, 'x');  // more than a pipe holds
    std::string got;
    std::thread reader([&] { got = read_to_end(pipe); });
    EXPECT_TRUE(write_output(pipe, text));
    reader.join();
    EXPECT_EQ(got, text);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(Output, ADeviceStaysADevice) {
    const TemporaryFolder folder;
    // Through a link of our own: should this fail, the link is lost and not the machine's device.
    fs::create_symlink("/dev/null", folder / "null");
    ASSERT_TRUE(check_output(folder / "null"));
    EXPECT_TRUE(write_output(folder / "null", "x"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    fs::create_symlink("/dev/full", folder / "full");
    const auto full = write_output(folder / "full", "x");
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().message,
              "cannot write " + (folder / "full").string() + ": No space left on device");
}

TEST(Output, AnOpenDescriptorIsWrittenWhereItStands) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("log", "");
    const int number = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(::write(number, "before\n", 7), 7);
    const std::string name = "/dev/fd/" + std::to_string(number);
    EXPECT_TRUE(check_output(name));
    EXPECT_TRUE(write_output(name, "after\n"));
    ::close(number);
    EXPECT_EQ(folder.read("log"), "before\nafter\n");
    const auto closed = check_output(name);
    ASSERT_FALSE(closed);
    EXPECT_EQ(closed.error().message, "cannot write " + name + ": Bad file descriptor");
}

TEST(Output, NamesOfTheStandardOutput) {
    for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
        EXPECT_TRUE(is_standard_output(name)) << name;
    for (const char* name : {"", "./-", "--", "/dev/fd/", "/dev/fd/2", "/dev/fd/1x", "/dev/stderr"})
        EXPECT_FALSE(is_standard_output(name)) << name;
}

TEST(Output, WhatCannotBeWrittenIsFoundBefore) {
    const TemporaryFolder folder;
    EXPECT_TRUE(check_output("")) << "nothing is asked for";
    EXPECT_TRUE(check_output("-"));
    const fs::path nowhere = folder / "no folder" / "a";
    const auto missing = check_output(nowhere);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              "cannot create a file beside " + nowhere.string() + ": No such file or directory");
    EXPECT_FALSE(check_output(folder.path())) << "a folder";
    EXPECT_EQ(folder.count(), 0U);
}

}  // namespace
}  // namespace plumbline
