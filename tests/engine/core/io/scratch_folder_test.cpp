#include "engine/core/io/scratch_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, GoesWithAllThatIsInIt) {
    fs::path path;
    {
        Result<ScratchFolder> folder = ScratchFolder::make("test");
        ASSERT_TRUE(folder.ok());
        path = folder->path();
        EXPECT_EQ(path.filename().string().rfind("plumbline-test-", 0), 0U);
        EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
        fs::create_directory(path / "inner");
        std::ofstream(path / "inner" / "file") << "text";
        const ScratchFolder moved = std::move(*folder);
        EXPECT_EQ(moved.path(), path);
        EXPECT_TRUE(fs::exists(path / "inner" / "file"));
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(ScratchFolder, RefusesWhereNoneCanBeMade) {
    const Result<ScratchFolder> folder = ScratchFolder::make("a/b");
    ASSERT_FALSE(folder.ok());
    EXPECT_NE(folder.error().message.find("plumbline-a/b-"), std::string::npos);
}

}  // namespace
}  // namespace plumbline
