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

constexpr ShaderPair kMesh{"mesh.vert", "mesh.frag"};

TEST_F(ShaderBlocksGl, FrameLiesAsInCpp) {
    const FeatureSet all = feature::kSun | feature::kSunShadow | feature::kFlashlight |
                           feature::kFog | feature::kSkyLight;
    const Offsets offsets = reflected(program_of(kMesh, all), "Frame");
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
    };
    EXPECT_EQ(offsets, expected);
}

TEST_F(ShaderBlocksGl, MaterialLiesAsInCpp) {
    const Offsets offsets = reflected(program_of(kMesh, feature::kSun), "Material");
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
    const Offsets offsets = reflected(program_of(kMesh, feature::kLocalLights), "LocalLights");
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
    using namespace feature;
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
            kVertexColor | kBlend | kSkyReflection | kGlass,
            kBaseMap | kBlend | kSkyReflection | kGlass,
            kBaseMap | kNormalMap | kOrmMap | kParallax,
            kBaseMap | kNormalMap | kOrmMap | kVariation,
            kBaseMap | kBlend | kTwoSided};
}

TEST_F(ShaderBlocksGl, EveryVariantCompiles) {
    using namespace feature;
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
    const std::vector<FeatureSet> air{0, kFog, kSkyLight, kFog | kSkyLight, kSkyLight | kAerial};
    for (const FeatureSet material : material_variants()) {
        for (const FeatureSet light : lights) {
            for (const FeatureSet a : air) {
                program_of(kMesh, variant_of(material, light | a));
            }
        }
    }
    const FeatureSet whole = kSun | kSunShadow | kFlashlight | kFog | kSkyLight;
    for (const FeatureSet material : {kVertexColor | kTwoSided | kLeaf,
                                      kBaseMap | kNormalMap | kAlphaMask,
                                      kUnlit | kVertexColor}) {
        program_of(kMesh, variant_of(material, whole | kWind));
        program_of(kMesh, variant_of(material, whole | kOcclusion));
        program_of(kMesh, variant_of(material, whole | kOcclusion | kCoverage));
    }
    for (const FeatureSet f : {FeatureSet{0}, kSun, kSun | kFog | kFlashlight}) {
        program_of({"drop.vert", "drop.frag"}, f);
    }
    for (const FeatureSet f : {FeatureSet{0}, kFog, kFog | kSkyCodes}) {
        program_of({"fullscreen.vert", "sky.frag"}, f);
    }
    for (const FeatureSet f : {FeatureSet{0}, kFog, kClouds, kFog | kClouds}) {
        program_of({"sky_dome.vert", "sky_dome.frag"}, f);
        program_of({"sky_point.vert", "sky_point.frag"}, f);
    }
    for (const FeatureSet f : {FeatureSet{0}, kKeepDepth}) {
        program_of({"fullscreen.vert", "tone_map.frag"}, f);
        program_of({"fullscreen.vert", "tone_map.frag"}, f | kOcclusion);
        program_of({"fullscreen.vert", "tone_map.frag"}, f | kShafts);
        program_of({"fullscreen.vert", "tone_map.frag"}, f | kBloom | kToneMap | kFxaa);
        program_of({"fullscreen.vert", "smooth_edges.frag"}, f | kFxaa);
        program_of({"fullscreen.vert", "smooth_edges.frag"}, f | kFxaa | kSharpen);
        program_of({"fullscreen.vert", "scale_up.frag"}, f);
    }
    program_of({"fullscreen.vert", "exposure.frag"}, 0);
    program_of({"fullscreen.vert", "occlusion.frag"}, 0);
    program_of({"fullscreen.vert", "pair_blur.frag"}, 0);
    program_of({"fullscreen.vert", "focus_gather.frag"}, 0);
    for (const FeatureSet f : {FeatureSet{0}, kSunShadow, kSunShadow | kCascades})
        program_of({"fullscreen.vert", "shafts.frag"}, f);
    for (const FeatureSet f : {FeatureSet{0}, kOcclusion, kShafts, kOcclusion | kShafts}) {
        for (const char* shader : {"focus_down.frag", "focus_join.frag", "motion_blur.frag"})
            program_of({"fullscreen.vert", shader}, f);
    }
    program_of({"fullscreen.vert", "bloom_down.frag"}, 0);
    program_of({"fullscreen.vert", "bloom_up.frag"}, 0);
    program_of({"depth.vert", "depth.frag"}, 0);
    program_of({"depth.vert", "depth.frag"}, kAlphaMask);
    program_of({"line.vert", "line.frag"}, 0);
}

}  // namespace
}  // namespace plumbline::render
