// The six faces of a sky by their names.
#include "engine/assets/skybox_files.h"

#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

TEST(SkyboxFiles, stand_in_the_order_of_the_faces_with_exr_before_png_before_jpg) {
    const TempFolder folder;
    for (const char* name : {"px.jpg", "px.png", "px.exr", "nx.jpg", "nx.png", "pz.jpg", "nz.gif"})
        folder.write(name, "");
    fs::create_directory(folder.path() / "pz.png");  // no file
    const std::array<fs::path, 6> files = skybox_files(folder.path());
    EXPECT_EQ(files[0], folder.path() / "px.exr");
    EXPECT_EQ(files[1], folder.path() / "nx.png");
    EXPECT_EQ(files[2], fs::path());
    EXPECT_EQ(files[3], fs::path());
    EXPECT_EQ(files[4], folder.path() / "pz.jpg");
    EXPECT_EQ(files[5], fs::path()) << "a format that is not read";
}

TEST(SkyboxFiles, of_a_folder_that_is_not_there_are_none) {
    for (const fs::path& file : skybox_files("/nonexistent/sky")) EXPECT_TRUE(file.empty());
}

}  // namespace
}  // namespace plumbline::assets::test
