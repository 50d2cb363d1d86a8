// The blocks as the driver lays them out, against the C++ structs that are copied into them; and
// every shader variant compiles.
#include "engine/render/passes/mesh_pass.h"
#include "engine/render/resources/gpu_materials.h"
#include "engine/render/shader_blocks.h"
#include "engine/render/shaders/shader_library.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

#include <map>

namespace plumbline::render {
namespace {

using Offsets = std::map<std::string, std::size_t>;

/// Offsets of the members of one block, and its size under the name "".
Offsets reflected(unsigned int program, const char* block) {
    Offsets offsets;
    const GLuint index = glGetUniformBlockIndex(program, block);
    if (index == GL_INVALID_INDEX) return offsets;
    GLint size = 0;
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    offsets[""] = static_cast<std::size_t>(size);
    GLint count = 0;
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &count);
    std::vector<GLint> members(static_cast<std::size_t>(count));
    glGetActiveUniformBlockiv(
        program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES, members.data());
    for (const GLint member : members) {
        const auto uniform = static_cast<GLuint>(member);
        std::array<char, 128> name{};
        glGetActiveUniformName(program, uniform, name.size(), nullptr, name.data());
        GLint offset = 0;
        glGetActiveUniformsiv(program, 1, &uniform, GL_UNIFORM_OFFSET, &offset);
        offsets[name.data()] = static_cast<std::size_t>(offset);
    }
    return offsets;
}

class ShaderBlocksGl : public GlTest {
protected:
    unsigned int program_of(const ShaderPair& files, FeatureSet features) {
        const auto program = shaders_.compile(files, features);
        EXPECT_TRUE(program.ok()) << program.error().message;
        return program.ok() ? (*program)->name() : 0U;
    }

    ShaderLibrary shaders_{PL_SOURCE_DIR "/shaders"};
};

TEST_F(ShaderBlocksGl, FrameLiesAsInCpp) {
    const FeatureSet all = mesh_feature::kSun | mesh_feature::kSunShadow |
                           mesh_feature::kFlashlight | mesh_feature::kBlend |
                           mesh_feature::kSkyLight;
    const Offsets offsets = reflected(program_of(kMeshShader, all), "Frame");
    const Offsets expected{
        {"", sizeof(FrameBlock)},
        {"Frame.clip_from_world", offsetof(FrameBlock, clip_from_world)},
        {"Frame.world_from_ray", offsetof(FrameBlock, world_from_ray)},
        {"Frame.sun_shadow_from_world", offsetof(FrameBlock, sun_shadow_from_world)},
        {"Frame.flashlight_shadow_from_world", offsetof(FrameBlock, flashlight_shadow_from_world)},
        {"Frame.camera_world", offsetof(FrameBlock, camera_world)},
        {"Frame.to_sun_world", offsetof(FrameBlock, to_sun_world)},
        {"Frame.sun_radiance", offsetof(FrameBlock, sun_radiance)},
        {"Frame.ambient", offsetof(FrameBlock, ambient)},
        {"Frame.fog", offsetof(FrameBlock, fog)},
        {"Frame.flashlight_position", offsetof(FrameBlock, flashlight_position)},
        {"Frame.flashlight_direction", offsetof(FrameBlock, flashlight_direction)},
        {"Frame.flashlight_intensity", offsetof(FrameBlock, flashlight_intensity)},
        {"Frame.tone", offsetof(FrameBlock, tone)},
        {"Frame.clusters", offsetof(FrameBlock, clusters)},
        {"Frame.wind", offsetof(FrameBlock, wind)},
        {"Frame.gusts[0]", offsetof(FrameBlock, gusts)},
        {"Frame.cascade_ends", offsetof(FrameBlock, cascade_ends)},
        {"Frame.cascades[0]", offsetof(FrameBlock, cascades)},
        {"Frame.sky_light[0]", offsetof(FrameBlock, sky_light)},
        {"Frame.aerial[0]", offsetof(FrameBlock, aerial)},
        {"Frame.grid[0]", offsetof(FrameBlock, grid)},
    };
    EXPECT_EQ(offsets, expected);
}

TEST_F(ShaderBlocksGl, MaterialLiesAsInCpp) {
    const Offsets offsets = reflected(program_of(kMeshShader, mesh_feature::kSun), "Material");
    const Offsets expected{
        {"", sizeof(MaterialBlock)},
        {"Material.base_color", offsetof(MaterialBlock, base_color)},
        {"Material.emissive", offsetof(MaterialBlock, emissive)},
        {"Material.surface", offsetof(MaterialBlock, surface)},
        {"Material.relief", offsetof(MaterialBlock, relief)},
    };
    EXPECT_EQ(offsets, expected);
}

TEST_F(ShaderBlocksGl, LocalLightsLieAsInCpp) {
    const Offsets offsets =
        reflected(program_of(kMeshShader, mesh_feature::kLocalLights), "LocalLights");
    ASSERT_TRUE(offsets.contains(""));
    EXPECT_EQ(offsets.at(""), sizeof(LocalLightsBlock));
    EXPECT_EQ(offsets.at("local_lights[1].position_world"), sizeof(LocalLightEntry));
    EXPECT_EQ(offsets.at("local_lights[1].intensity"),
              sizeof(LocalLightEntry) + offsetof(LocalLightEntry, intensity));
    EXPECT_EQ(offsets.at("local_lights[1].direction_world"),
              sizeof(LocalLightEntry) + offsetof(LocalLightEntry, direction_world));
    EXPECT_EQ(offsets.at("local_lights[1].shadow"),
              sizeof(LocalLightEntry) + offsetof(LocalLightEntry, shadow));
}

/// Materials that between them use every feature a material can have.
std::vector<FeatureSet> material_variants() {
    using namespace mesh_feature;
    return {kVertexColor,
            kVertexColor | kFaceted,
            kUnlit | kVertexColor,
            kUnlit | kBaseMap,
            kUnlit | kBaseMap | kAlphaMask,
            kBlinnPhong | kVertexColor,
            kBlinnPhong | kBaseMap | kNormalMap,
            kBaseMap | kNormalMap | kOrmMap,
            kBaseMap | kNormalMap | kOrmMap | kMetal,
            kVertexColor | kMetal | kSkyReflection,
            kVertexColor | kEmissive,
            kBaseMap | kEmissive | kEmissiveMap,
            kBaseMap | kNormalMap | kAlphaMask | kTwoSided | kLeaf,
            kVertexColor | kTwoSided | kLeaf,
            kVertexColor | kBlend | kSkyReflection,
            kVertexColor | kBlend | kSkyReflection | kRipples,
            kVertexColor | kBlend | kSkyReflection | kRipples | kRefraction,
            kVertexColor | kBlend | kSkyReflection | kGlass,
            kBaseMap | kBlend | kSkyReflection | kGlass,
            kBaseMap | kNormalMap | kOrmMap | kParallax,
            kBaseMap | kNormalMap | kOrmMap | kVariation,
            kBaseMap | kBlend | kTwoSided};
}

TEST_F(ShaderBlocksGl, EveryMeshVariantCompiles) {
    using namespace mesh_feature;
    const std::vector<FeatureSet> lights{0,
                                         kSun,
                                         kSun | kSunShadow,
                                         kFlashlight,
                                         kFlashlight | kFlashlightAtEye,
                                         kSun | kSunShadow | kFlashlight | kFlashlightAtEye,
                                         kLocalLights,
                                         kSun | kSunShadow | kFlashlight | kLocalLights,
                                         kSun | kSunShadow | kFlashlight | kSoftShadows,
                                         kSun | kSunShadow | kFlashlight | kHardShadows,
                                         kSun | kSunShadow | kCascades | kLocalLights,
                                         kSun | kSunShadow | kContactHardening,
                                         kSun | kSunShadow | kCascades | kContactHardening,
                                         kLocalLights | kLightShadows,
                                         kLocalLights | kLightShadows | kHardShadows,
                                         kLocalLights | kLightShadows | kSoftShadows};
    const std::vector<FeatureSet> air{0, kSkyLight, kSkyLight | kAerial};
    // Air and light meet in one material or another.
    std::size_t turn = 0;
    for (const FeatureSet material : material_variants()) {
        for (const FeatureSet light : lights)
            program_of(kMeshShader, variant_of(material, light | air[turn++ % air.size()]));
    }
    const FeatureSet whole = kSun | kSunShadow | kFlashlight | kSkyLight;
    for (const FeatureSet material : {kVertexColor | kTwoSided | kLeaf,
                                      kBaseMap | kNormalMap | kAlphaMask,
                                      kUnlit | kVertexColor}) {
        program_of(kMeshShader, variant_of(material, whole | kSways));
        program_of(kMeshShader, variant_of(material, whole | kOcclusion));
        program_of(kMeshShader, variant_of(material, whole | kOcclusion | kCoverage));
        program_of(kMeshShader, variant_of(material, whole | kCodes));
    }
}

TEST_F(ShaderBlocksGl, EveryOtherVariantCompiles) {
    // Each feature of a shader by itself, and none.
    for (const ShaderPair& files : kShaderPairs) {
        if (files.fragment == kMeshShader.fragment) continue;
        program_of(files, 0);
        for (const Feature& feature : files.features) program_of(files, feature.bit);
    }
    for (const FeatureSet f : {FeatureSet{0}, FeatureSet{screen_feature::kKeepDepth}}) {
        using namespace screen_feature;
        program_of(kToneMapShader, f | kOcclusion | kShafts);
        program_of(kToneMapShader, f | kOcclusion | kFourSamples);
        program_of(kToneMapShader, f | kBloom | kToneMap | kFxaa);
        program_of(kSmoothEdgesShader, f | kFxaa | kSharpen);
    }
    for (const ShaderPair& files : {kFocusDownShader, kFocusJoinShader, kMotionBlurShader})
        program_of(files, screen_feature::kOcclusion | screen_feature::kShafts);
    program_of(kShaftsShader, shaft_feature::kSunShadow | shaft_feature::kCascades);
    program_of(kSkyShader, sky_feature::kSkyCodes | sky_feature::kCodes);
}

}  // namespace
}  // namespace plumbline::render
