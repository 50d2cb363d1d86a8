// All that is drawn in one frame, as plain data: no GL, no entities, no physics. Whoever extracts
// it fills it; the renderer reads it. What is absent here costs nothing there: an empty optional
// means no pass, no target and no shader code for it.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/lines.h"
#include "engine/core/math.h"
#include "engine/render/quality.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace plumbline::render {

struct Camera {
    Vec3f position_world{0.0F};
    Quatf orientation{1.0F, 0.0F, 0.0F, 0.0F};  ///< world_from_camera; looks down -Z
    float fov_y_rad{1.0F};
    float near_m{0.05F};
    float far_m{500.0F};
};

/// One mesh with its materials at one place. Equal (mesh, materials) pairs become one instanced draw.
struct DrawItem {
    assets::MeshId mesh{};
    std::uint32_t first_material{0};  ///< in the frame's material_ids: one per sub-mesh material
    std::uint32_t material_count{0};
    Mat4f world_from_body{1.0F};
    Vec3f tint{1.0F};  ///< multiplies the base colour
    bool casts_shadow{true};
    bool is_static{false};  ///< cannot move: its shadow may be kept from frame to frame
};

struct DirectionalLight {
    Vec3f direction_world{0.0F, -1.0F, 0.0F};  ///< the way the light travels; unit
    Vec3f radiance{3.0F};                      ///< colour times intensity
};

struct SunShadow {
    std::uint32_t size_px{2048};
    /// From the camera; beyond it nothing is in shadow, unless Quality::far_shadows.
    float distance_m{80.0F};
    std::uint32_t cascades{1};  ///< 1…4 maps of size_px each, near to far
    /// Of the sun as seen from the ground. Above 0 edges are the softer the further off what casts
    /// them is; 0: as soft as the map's filter makes them.
    float angular_size_rad{0.0F};
};

/// Point and spot lights of the scene.
struct LocalLight {
    Vec3f position_world{0.0F};
    Vec3f intensity{1.0F};  ///< colour times intensity, candela-like: irradiance at 1 m
    float radius_m{8.0F};   ///< reaches zero there
    bool is_spot{false};
    Vec3f direction_world{0.0F, 0.0F, -1.0F};
    float inner_cos{1.0F};
    float outer_cos{0.0F};
    bool casts_shadow{false};  ///< where the frame has light_shadows
};

/// Shadows of local lights, for as many of those that ask as Quality::shadowed_lights.
struct LightShadows {
    std::uint32_t size_px{512};  ///< of each of the six maps round a light
};

/// The player's flashlight: a spot light with its own shadow map. The beam starts at the hand.
struct Flashlight {
    Vec3f position_world{0.0F};
    Vec3f direction_world{0.0F, 0.0F, -1.0F};  ///< unit
    Vec3f intensity{60.0F};
    float radius_m{30.0F};
    float inner_rad{0.21F};  ///< half angles
    float outer_rad{0.38F};
    std::uint32_t shadow_size_px{1024};
};

struct Fog {
    Vec3f color{0.5F};
    float density_per_m{0.02F};  ///< transmittance exp(-(density * distance)^2)
};

/// A sky that is computed: air, haze and clouds under the sun, or under moon and stars. The frame's
/// sun is the light outside the air; what reaches the ground, and the ambient light, follow from it.
struct SkyModel {
    Vec3f to_sun_world{0.0F, 1.0F, 0.0F};     ///< unit; below the horizon it is night
    Vec3f pole_world{0.0F, 0.643F, -0.766F};  ///< unit; the stars turn about it
    float haze{1.0F};                         ///< 1: a clear day's
    float clouds{0.5F};                       ///< 0: none; 1: as many as there are
    /// Where contrast has gone down to a fiftieth, m; 0: things keep their colours at any distance.
    float visibility_m{0.0F};
};

struct Sky {
    std::filesystem::path folder;  ///< six faces px nx py ny pz nz; with a model: the clouds' five
    float brightness{1.0F};        ///< 1: as the image is; below: dusk. Of the six faces
    std::optional<SkyModel> model{};
};

/// A mean, and waves of gusts that it carries along.
struct Wind {
    Vec2f mean_mps{0.0F};  ///< along x and z
    struct Wave {
        Vec2f number_radpm{0.0F};  ///< along x and z
        float phase_rad{0.0F};     ///< at the world's origin, now
        float speed_mps{0.0F};     ///< of the gust, across its number
    };
    std::array<Wave, 2> gusts{};
};

struct Post {
    float exposure{1.0F};
    float bloom{0.0F};   ///< 0: no bloom targets, no bloom passes
    bool adapts{false};  ///< times what the image's brightness asks for: more at night
};

/// The share of the ambient light that corners and narrow places do not get: what is in the image
/// hides the rest of the sky from its neighbours. Light of lamps and sun is not taken away.
struct AmbientOcclusion {
    float radius_m{
        0.6F};  ///< what is farther takes nothing away, what is nearer than half of it all
    float strength{1.0F};  ///< 0…1 of it
    std::uint32_t slices{
        2};                  ///< planes through the line of sight, a pixel: each finds two horizons
    std::uint32_t steps{2};  ///< from the pixel to each
};

/// A box, such as a house, whose ambient light is what comes in by its windows and goes from wall to
/// wall. Static items count; glass lets everything through.
struct IndirectLight {
    Vec3f min_world{0.0F};
    Vec3f max_world{0.0F};
    float spacing_m{0.5F};  ///< of the points at which it is computed
    float gain{1.0F};       ///< times that much: eyes adapt to a room, one exposure does not
};

/// Air that the sun lights up where it is not in shadow.
struct SunShafts {
    float density_per_m{0.003F};
    float distance_m{60.0F};  ///< from the eye
    std::uint32_t steps{16};  ///< along each line of sight
};

/// Water with an attenuation_m shows what lies below it bent, and dimmer by the way through it.
struct Refraction {
    bool caustics{false};  ///< the sun's light below gathers where the water's material has it so
};

/// A thin lens: a point at distance z is seen as a disc, aperture_m * |1/focus_m - 1/z| wide as an
/// angle.
struct DepthOfField {
    float focus_m{4.0F};  ///< along the line of sight
    float aperture_m{0.02F};
    std::uint32_t samples{24};  ///< of a disc
};

/// A thing of the frame that moved while the shutter was open.
struct MovedMesh {
    assets::MeshId mesh{};
    Mat4f world_from_body{1.0F};         ///< as it is drawn
    Mat4f world_from_body_before{1.0F};  ///< as the shutter opened
};

/// Where the camera was when the shutter opened; what its way since then takes across the image
/// is drawn as a streak, and so are things that moved. The camera of the frame is where it closes.
struct MotionBlur {
    Vec3f position_before_world{0.0F};
    Quatf orientation_before{1.0F, 0.0F, 0.0F, 0.0F};
    std::uint32_t samples{12};  ///< of a streak
    std::vector<MovedMesh> moved;
};

/// Water in the air, drawn as a soft streak.
struct DropStreak {
    Vec3f position_world{0.0F};
    float radius_m{0.003F};
    Vec3f trail_m{0.0F};  ///< the way that it moves while the image is taken
    float opacity{1.0F};
};

/// A ring that runs outwards on level water.
struct WaterRingMark {
    Vec3f center_world{0.0F};
    float radius_m{0.1F};
    float opacity{1.0F};
};

enum class FillMode : std::uint8_t { Filled, Wireframe, Points };

/// Against the depth that is there already. With any other than Less, what is drawn later decides:
/// opaque things are drawn in the frame's order.
enum class DepthTest : std::uint8_t { Less, Always, Never, Greater, Off };
constexpr std::string_view name_of(DepthTest test) {
    constexpr std::array<std::string_view, 5> kNames{"less", "always", "never", "greater", "off"};
    return kNames[static_cast<std::size_t>(test)];
}
/// In a ring.
constexpr DepthTest next(DepthTest test, int times) {
    return static_cast<DepthTest>((static_cast<int>(test) + times) % 5);
}

/// So many fields because each effect has its own, absent where nobody called for it.
struct RenderFrame {
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    Camera camera{};
    Vec3f clear_color{0.6F, 0.65F, 0.85F};  ///< linear; seen where there is no sky
    Vec3f ambient{0.1F};                    ///< radiance from everywhere
    std::vector<DrawItem> items;
    std::vector<assets::MaterialId> material_ids;  ///< of all items, one after the other
    std::optional<DirectionalLight> sun;
    bool sun_reaches_ground{true};        ///< false: it, or the moon, lights nothing but the sky
    std::optional<SunShadow> sun_shadow;  ///< needs sun
    std::optional<Flashlight> flashlight;
    std::vector<LocalLight> lights;
    std::optional<LightShadows> light_shadows;
    std::optional<Fog> fog;
    std::optional<Sky> sky;
    std::optional<Wind> wind;  ///< absent: nothing sways
    float time_s{0.0F};        ///< of what runs by itself: ripples, swaying
    std::optional<AmbientOcclusion> occlusion;
    std::optional<IndirectLight> indirect;  ///< needs sky
    std::optional<SunShafts> shafts;        ///< needs sun
    std::optional<Refraction> refraction;
    std::optional<DepthOfField> depth_of_field;
    std::optional<MotionBlur> motion_blur;
    std::optional<Post> post;  ///< absent: plain clamp and sRGB
    Quality quality;
    FillMode fill_mode{FillMode::Filled};
    DepthTest depth_test{DepthTest::Less};
    bool textures{true};                     ///< false: base colours without their maps
    std::optional<assets::Shading> shading;  ///< over every material's own (`render --shading`)
    std::vector<DropStreak> drops;           ///< over all else that is translucent
    std::vector<WaterRingMark> water_rings;  ///< below the drops
    LineList lines;                          ///< collision shapes, contacts
};

/// Appends the item with its materials; sets its first_material and material_count.
inline void add_item(RenderFrame& frame,
                     DrawItem item,
                     std::span<const assets::MaterialId> materials) {
    item.first_material = static_cast<std::uint32_t>(frame.material_ids.size());
    item.material_count = static_cast<std::uint32_t>(materials.size());
    frame.material_ids.insert(frame.material_ids.end(), materials.begin(), materials.end());
    frame.items.push_back(item);
}

/// Good until the frame's material_ids change.
inline std::span<const assets::MaterialId> materials_of(const RenderFrame& frame,
                                                        const DrawItem& item) {
    return std::span{frame.material_ids}.subspan(item.first_material, item.material_count);
}

}  // namespace plumbline::render
