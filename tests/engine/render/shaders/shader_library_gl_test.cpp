// What stands in for a program that is not compiled yet.
#include "engine/render/shaders/shader_library.h"
#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {
namespace {

constexpr ShaderPair kMeshPair{"mesh.vert", "mesh.frag"};
constexpr FeatureSet kPlain = feature::kVertexColor | feature::kSun | feature::kSkyLight;
constexpr Substitutes kAny{
    .kept = feature::kAlphaMask, .harmless = feature::kFog, .dear = feature::kSunShadow};

class ShaderLibraryGl : public GlTest {
protected:
    const gl::Program* find(FeatureSet features) {
        return shaders_.find_or_similar(kMeshPair, features, kAny);
    }

    ShaderLibrary shaders_{PL_SOURCE_DIR "/shaders"};
};

TEST_F(ShaderLibraryGl, CompilesAtOnceUnlessToldNotTo) {
    const gl::Program* plain = find(kPlain);
    ASSERT_NE(plain, nullptr);
    const gl::Program* lit = find(kPlain | feature::kFlashlight);
    ASSERT_NE(lit, nullptr);
    EXPECT_NE(lit, plain);
    EXPECT_EQ(shaders_.new_count(), 2U);
    EXPECT_EQ(find(kPlain), plain);
    EXPECT_EQ(shaders_.new_count(), 2U);
}

TEST_F(ShaderLibraryGl, ASubstituteLacksLeastAndReadsNothingThatNobodyAskedFor) {
    const gl::Program* plain = find(kPlain);
    const gl::Program* shadowed = find(kPlain | feature::kSunShadow);
    const gl::Program* foggy = find(kPlain | feature::kFog);
    const gl::Program* lamps = find(kPlain | feature::kLocalLights);
    shaders_.allow_new(0.0);
    EXPECT_EQ(find(kPlain | feature::kFlashlight), plain);
    // The shadow is missed more than the fog; lamps would be read, which this frame has not.
    EXPECT_EQ(find(kPlain | feature::kSunShadow | feature::kFog | feature::kFlashlight), shadowed);
    EXPECT_EQ(find(kPlain | feature::kFog | feature::kFlashlight), foggy);
    EXPECT_EQ(find(kPlain | feature::kLocalLights | feature::kFlashlight), lamps);
    EXPECT_EQ(shaders_.new_count(), 0U);
    EXPECT_EQ(shaders_.size(), 4U);
}

TEST_F(ShaderLibraryGl, WhatNothingCanStandInForIsCompiledAllTheSame) {
    const gl::Program* plain = find(kPlain);
    shaders_.allow_new(0.0);
    const gl::Program* holes = find(kPlain | feature::kAlphaMask);
    ASSERT_NE(holes, nullptr);
    EXPECT_NE(holes, plain);
    EXPECT_EQ(shaders_.new_count(), 1U);
}

TEST_F(ShaderLibraryGl, ALaterFrameHasTheProgramItself) {
    const gl::Program* plain = find(kPlain);
    shaders_.allow_new(0.0);
    EXPECT_EQ(find(kPlain | feature::kFlashlight), plain);
    shaders_.allow_new(1e-9);  // so little that one uses it up
    const gl::Program* lit = find(kPlain | feature::kFlashlight);
    EXPECT_NE(lit, plain);
    EXPECT_EQ(find(kPlain | feature::kFlashlight | feature::kFog), lit);
    EXPECT_EQ(shaders_.new_count(), 1U);
    // Linked before does not help: it is the first draw that takes its time.
    ASSERT_NE(shaders_.find(kMeshPair, kPlain | feature::kSunShadow), nullptr);
    shaders_.allow_new(0.0);
    EXPECT_EQ(find(kPlain | feature::kSunShadow), plain);
}

TEST_F(ShaderLibraryGl, WhatIsNotUsedForALongTimeIsDropped) {
    find(kPlain);
    find(kPlain | feature::kFlashlight);
    shaders_.find(kMeshPair, kPlain | feature::kFog);  // of passes that ask each time: it stays
    for (std::uint64_t frame = 0; frame < 2 * ShaderLibrary::kKeptUnused; ++frame) {
        shaders_.allow_new(1.0);
        find(kPlain);
        if (frame == ShaderLibrary::kKeptUnused - 1) {
            EXPECT_EQ(shaders_.size(), 3U);
        }
    }
    EXPECT_EQ(shaders_.size(), 2U);
    EXPECT_EQ(shaders_.new_count(), 0U);
    find(kPlain | feature::kFlashlight);
    EXPECT_EQ(shaders_.new_count(), 1U);
}

}  // namespace
}  // namespace plumbline::render
