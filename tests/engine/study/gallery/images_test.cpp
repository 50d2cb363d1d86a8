// Images of end states.
#include "tests/engine/study/gallery/sample_table.h"

#include <cstddef>
#include <string>

namespace plumbline::study {
namespace {

std::size_t image_folders() {
    std::size_t count = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
        count += entry.path().filename().string().starts_with("plumbline-images-") ? 1U : 0U;
    return count;
}

// `plumbline` is not beside the tests: one line says so, and the table stays as it was.
TEST_F(StabilityTableTest, WithoutTheProgramThereAreNoImages) {
    const std::size_t before = image_folders();
    take_images(table, 2, 4, 4);
    EXPECT_FALSE(table.no_images.empty());
    for (const std::string& png : table.images) EXPECT_TRUE(png.empty());
    EXPECT_EQ(image_folders(), before) << "nothing is left behind";
}

TEST_F(StabilityTableTest, NoCasesNeedNoImages) {
    StabilityTable empty;
    take_images(empty, 1, 4, 4);
    EXPECT_EQ(empty.no_images, "");
}

}  // namespace
}  // namespace plumbline::study
