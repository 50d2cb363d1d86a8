// What stands in for a program that is not compiled yet.
#include "engine/render/shaders/mesh_features.h"
#include "engine/render/shaders/shader_library.h"
#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {
namespace {

using namespace mesh_feature;

constexpr ShaderPair kMeshPair{"mesh.vert", "mesh.frag", mesh_feature::kAll};
constexpr FeatureSet kPlain = kVertexColor | kSun | kSkyLight;
constexpr Substitutes kAny{.kept = kAlphaMask, .harmless = kAerial, .dear = kSunShadow};

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
    const gl::Program* lit = find(kPlain | kFlashlight);
    ASSERT_NE(lit, nullptr);
    EXPECT_NE(lit, plain);
    EXPECT_EQ(shaders_.new_count(), 2U);
    EXPECT_EQ(find(kPlain), plain);
    EXPECT_EQ(shaders_.new_count(), 2U);
}

TEST_F(ShaderLibraryGl, ASubstituteLacksLeastAndReadsNothingThatNobodyAskedFor) {
    const gl::Program* plain = find(kPlain);
    const gl::Program* shadowed = find(kPlain | kSunShadow);
    const gl::Program* hazy = find(kPlain | kAerial);
    const gl::Program* lamps = find(kPlain | kLocalLights);
    shaders_.begin_frame(0.0);
    EXPECT_EQ(find(kPlain | kFlashlight), plain);
    // The shadow is missed more than the air; lamps would be read, which this frame has not.
    EXPECT_EQ(find(kPlain | kSunShadow | kAerial | kFlashlight), shadowed);
    EXPECT_EQ(find(kPlain | kAerial | kFlashlight), hazy);
    EXPECT_EQ(find(kPlain | kLocalLights | kFlashlight), lamps);
    EXPECT_EQ(shaders_.new_count(), 0U);
    EXPECT_EQ(shaders_.size(), 4U);
}

TEST_F(ShaderLibraryGl, WhatNothingCanStandInForIsCompiledAllTheSame) {
    const gl::Program* plain = find(kPlain);
    shaders_.begin_frame(0.0);
    const gl::Program* holes = find(kPlain | kAlphaMask);
    ASSERT_NE(holes, nullptr);
    EXPECT_NE(holes, plain);
    EXPECT_EQ(shaders_.new_count(), 1U);
}

TEST_F(ShaderLibraryGl, ALaterFrameHasTheProgramItself) {
    const gl::Program* plain = find(kPlain);
    shaders_.begin_frame(0.0);
    EXPECT_EQ(find(kPlain | kFlashlight), plain);
    shaders_.begin_frame(1e-9);  // so little that one uses it up
    const gl::Program* lit = find(kPlain | kFlashlight);
    EXPECT_NE(lit, plain);
    EXPECT_EQ(find(kPlain | kFlashlight | kAerial), lit);
    EXPECT_EQ(shaders_.new_count(), 1U);
    // Linked before does not help: it is the first draw that takes its time.
    ASSERT_NE(shaders_.find(kMeshPair, kPlain | kSunShadow), nullptr);
    shaders_.begin_frame(0.0);
    EXPECT_EQ(find(kPlain | kSunShadow), plain);
}

TEST_F(ShaderLibraryGl, AboveTheBoundTheProgramUsedLongestAgoGoesFirst) {
    ShaderLibrary small(PL_SOURCE_DIR "/shaders", 2 * kProgramBytes);
    const auto find_in = [&](FeatureSet features) {
        return small.find_or_similar(kMeshPair, features, kAny);
    };
    for (const FeatureSet features : {kPlain, kPlain | kFlashlight}) {
        small.begin_frame();
        find_in(features);
    }
    EXPECT_EQ(small.bytes(), 2 * kProgramBytes);
    small.begin_frame();
    find_in(kPlain);
    small.find(kMeshPair, kPlain | kLocalLights);
    EXPECT_EQ(small.size(), 3U) << "nothing goes while a frame is drawn";
    small.begin_frame();
    EXPECT_EQ(small.size(), 2U);
    find_in(kPlain);
    EXPECT_EQ(small.new_count(), 0U) << "used in the frame before";
    find_in(kPlain | kFlashlight);
    EXPECT_EQ(small.new_count(), 1U) << "this one went";
}

TEST_F(ShaderLibraryGl, AFrameThatNeedsMoreThanTheBoundKeepsWhatItNeeds) {
    ShaderLibrary small(PL_SOURCE_DIR "/shaders", kProgramBytes);
    for (int frame = 0; frame < 3; ++frame) {
        small.begin_frame();
        for (const FeatureSet features : {kPlain, kPlain | kFlashlight, kPlain | kLocalLights})
            ASSERT_NE(small.find_or_similar(kMeshPair, features, kAny), nullptr);
        EXPECT_EQ(small.new_count(), frame == 0 ? 3U : 0U);
    }
    small.begin_frame();
    small.begin_frame();
    EXPECT_EQ(small.size(), 1U) << "frames that use none leave the bound";
}

}  // namespace
}  // namespace plumbline::render
