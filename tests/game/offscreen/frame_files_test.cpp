// Where the frames of a film go.
#include "game/offscreen/frame_files.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

TEST(FrameFilesTest, MakeTheFolderThatWasNamed) {
    const test::TemporaryFolder folder;
    auto files = FrameFiles::open({.folder = folder / "new/frames"});
    ASSERT_TRUE(files.ok()) << files.error().message;
    EXPECT_TRUE(std::filesystem::is_directory(folder / "new/frames"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "new/frames"), {}), 0);
    EXPECT_TRUE(files->close().ok()) << "no film: nothing to wait for";
}

TEST(FrameFilesTest, APlaceThatCannotBeWrittenIsToldBeforeAnythingIsDrawn) {
    const test::TemporaryFolder folder;
    folder.write("file", "");
    EXPECT_FALSE(FrameFiles::open({.folder = folder / "file/frames"}).ok());
    std::filesystem::create_directories(folder / "frames/frame_00001.png");
    const auto files = FrameFiles::open({.folder = folder / "frames"});
    ASSERT_FALSE(files.ok());
    EXPECT_NE(files.error().message.find("frame_00001.png"), std::string::npos)
        << files.error().message;
}

TEST(FrameFilesTest, WithoutAPlaceThereIsNothingToDo) {
    auto files = FrameFiles::open({});
    ASSERT_TRUE(files.ok());
    EXPECT_TRUE(files->close().ok());
}

}  // namespace
}  // namespace plumbline::game
