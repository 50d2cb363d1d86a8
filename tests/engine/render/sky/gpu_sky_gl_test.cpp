// Faces of a sky on the GPU: made alike, made small, and what light they give.
#include "engine/render/sky/gpu_sky.h"
#include "tests/engine/render/sky/sky_fixture.h"

namespace plumbline::render {
namespace {

class GpuSkyGl : public SkyGl {
protected:
    void write_all(const Pixel& color) {
        for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"}) write_face(name, color);
    }
};

TEST_F(GpuSkyGl, FacesOfMixedSizesAndMissingOnesStillMakeASky) {
    write_face("px", {200, 0, 0}, 16);
    write_face("nx", {200, 0, 0}, 8);
    const auto image = draw(looking({1.0F, 0.0F, 0.0F}));
    EXPECT_GT(pixel_at(image, 48, 40).r, 0);
    EXPECT_GT(bytes_of("sky"), 0U);
}

TEST_F(GpuSkyGl, EightBitFacesAreShownAsTheyAreAndMixedOnesBecomeLight) {
    write_all({100, 100, 100});
    GpuSky sky(library_, 1024);
    const Sky wanted{folder_};
    sky.want(&wanted, {});
    EXPECT_TRUE(sky.ready());
    EXPECT_TRUE(sky.is_srgb());
    EXPECT_EQ(sky.exposure(), 1.0F);
    EXPECT_EQ(sky.background().width(), 8U);
    EXPECT_EQ(sky.computed(), nullptr);
    // The light of an average direction is 1: the first coefficient times the first harmonic.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(sky.light()[0][i] * 0.282095F, 1.0F, 1e-3F);
    sky.want(nullptr, {});
    EXPECT_FALSE(sky.ready());
    EXPECT_EQ(sky.bytes(), 0U);
    write_face("py", {100, 100, 100}, 16);
    GpuSky mixed(library_, 1024);
    mixed.want(&wanted, {});
    EXPECT_FALSE(mixed.is_srgb());
    EXPECT_EQ(mixed.background().width(), 16U) << "as large as the largest";
}

TEST_F(GpuSkyGl, FacesLargerThanTheDriverTakesAreHalvedUntilTheyFit) {
    write_all({0, 0, 200});
    GpuSky sky(library_, 4);
    const Sky wanted{folder_};
    sky.want(&wanted, {});
    EXPECT_EQ(sky.background().width(), 4U);
    EXPECT_TRUE(sky.is_srgb());
}

TEST_F(GpuSkyGl, CloudsThatAreNoneAreSaidOnceAndTheSkyIsComputedWithoutThem) {
    write_all({0, 0, 200});  // no alpha
    GpuSky sky(library_, 1024);
    const Sky wanted{.folder = folder_, .model = SkyModel{}};
    testing::internal::CaptureStderr();
    sky.want(&wanted, {});
    sky.want(&wanted, {});
    const std::string log = testing::internal::GetCapturedStderr();
    const std::string words = "clouds are six equal squares with alpha";
    EXPECT_NE(log.find(words), std::string::npos) << log;
    EXPECT_EQ(log.find(words, log.find(words) + 1), std::string::npos) << log;
    EXPECT_NE(sky.computed(), nullptr);
    EXPECT_FALSE(sky.background());
    EXPECT_TRUE(sky.ready());
    EXPECT_GT(sky.bytes(), 0U);
}

}  // namespace
}  // namespace plumbline::render
