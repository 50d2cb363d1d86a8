#include "game/offscreen/contact_sheet.h"

#include "game/command_line/camera_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::game {
namespace {

constexpr std::uint32_t kColumns = 3;
constexpr std::uint32_t kShrink = 3;
constexpr std::uint32_t kGap_px = 6;

/// The mean of the kShrink x kShrink pixels whose corner is (x, y).
std::array<std::uint8_t, 3> mean_at(const assets::ImageData& image,
                                    std::uint32_t x,
                                    std::uint32_t y) {
    std::array<std::uint32_t, 3> sum{};
    for (std::uint32_t dy = 0; dy < kShrink; ++dy) {
        for (std::uint32_t dx = 0; dx < kShrink; ++dx) {
            const std::size_t at = (static_cast<std::size_t>(y + dy) * image.width + x + dx) * 3;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += image.bytes[at + c];
        }
    }
    std::array<std::uint8_t, 3> mean{};
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] = static_cast<std::uint8_t>(sum[c] / (kShrink * kShrink));
    return mean;
}

}  // namespace

assets::ImageData contact_sheet(const std::vector<assets::ImageData>& images) {
    assets::ImageData sheet{
        .width = 1, .height = 1, .format = assets::PixelFormat::Rgb8, .bytes = {}};
    const std::uint32_t width = images.empty() ? 0 : images.front().width / kShrink;
    const std::uint32_t height = images.empty() ? 0 : images.front().height / kShrink;
    const auto count = static_cast<std::uint32_t>(images.size());
    const std::uint32_t columns = std::clamp(count, 1U, kColumns);
    const std::uint32_t rows = std::max(1U, (count + columns - 1) / columns);
    sheet.width = columns * (width + kGap_px) + kGap_px;
    sheet.height = rows * (height + kGap_px) + kGap_px;
    sheet.bytes.assign(static_cast<std::size_t>(sheet.width) * sheet.height * 3, 24);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t left = kGap_px + (i % columns) * (width + kGap_px);
        const std::uint32_t top = kGap_px + (i / columns) * (height + kGap_px);
        for (std::uint32_t y = 0; y < height; ++y) {
            for (std::uint32_t x = 0; x < width; ++x) {
                const auto mean = mean_at(images[i], x * kShrink, y * kShrink);
                const std::size_t to =
                    (static_cast<std::size_t>(top + y) * sheet.width + left + x) * 3;
                std::ranges::copy(mean, sheet.bytes.begin() + static_cast<std::ptrdiff_t>(to));
            }
        }
    }
    return sheet;
}

std::vector<scene::ViewDescription> tour_stops(const scene::SceneDescription& scene) {
    if (!scene.views.empty()) return scene.views;
    const scene::ViewPoint first = first_view(scene);
    const Vec3 eye = first.world_from_camera.position;
    Vec3 target = scene.camera.target_m;
    if (!scene.has_camera && scene.player)
        target = eye + first.world_from_camera.orientation * Vec3{0, 0, -6};
    std::vector<scene::ViewDescription> stops;
    constexpr int kStops = 6;
    for (int i = 0; i < kStops; ++i) {
        const Quat turn = glm::angleAxis(2 * kPi * static_cast<Real>(i) / kStops, Vec3{0, 1, 0});
        stops.push_back({.name = i == 0 ? "start" : fmt::format("round_{}", i),
                         .position_m = target + turn * (eye - target),
                         .target_m = target,
                         .wait_s = i == 0 ? Real{0} : 0.5_r});
    }
    return stops;
}

}  // namespace plumbline::game
