#include "engine/app/capture/screenshot.h"

#include "tests/support/temporary_folder.h"

#include <set>

namespace plumbline::app {
namespace {

// EXPERIENCE E13: what keeps names apart is no clock, which may stand still or go back.
TEST(UnusedFile, NamesStayUniqueWhateverTheClockSays) {
    const test::TemporaryFolder folder;
    std::set<std::filesystem::path> names;
    for (int i = 0; i < 20; ++i) {
        const std::filesystem::path file = unused_file(folder.path(), "garden", ".png");
        EXPECT_TRUE(names.insert(file).second) << file;
        EXPECT_TRUE(file.filename().string().starts_with("garden_"));
        folder.write(file.filename().string(), "an image");
    }
    // In one second, which is all of the name but its number, there were more than one.
    std::set<std::string> seconds;
    for (const std::filesystem::path& name : names) {
        const std::string stem = name.stem().string();
        seconds.insert(stem.substr(0, stem.rfind('_')));
    }
    EXPECT_LT(seconds.size(), names.size());
}

}  // namespace
}  // namespace plumbline::app
