// Edges and bars before a lens, and what a row of the image holds of them.
#pragma once

#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>
#include <vector>

namespace plumbline::render {

inline constexpr std::uint32_t kLensSide_px = 480;

class LensGl : public ImageGl {
protected:
    /// Black; a white board right of the middle, `distance_m` ahead.
    RenderFrame edge(float distance_m) {
        RenderFrame frame = empty_frame(kLensSide_px, kLensSide_px);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        const float size_m = 4.0F * distance_m;
        const auto black = unlit(Vec3f{0.0F});
        const auto white = unlit(Vec3f{1.0F});
        add_box(frame, {size_m, size_m, 0.02F}, {0.0F, 0.0F, -distance_m - 0.02F}, black);
        add_box(frame, {size_m, size_m, 0.02F}, {0.5F * size_m, 0.0F, -distance_m}, white);
        return frame;
    }
    static float pixels_at_1m() {
        return 0.5F * static_cast<float>(kLensSide_px) / std::tan(radians_from_degrees(30.0F));
    }
    static std::vector<float> middle_row(const assets::ImageData& image) {
        std::vector<float> row;
        for (std::uint32_t x = 0; x < image.width; ++x)
            row.push_back(linear_from_srgb(
                static_cast<float>(pixel_at(image, x, image.height / 2).g) / 255.0F));
        return row;
    }
    /// Where the row first gets above that light; pixels, between their middles.
    static float crossing(const std::vector<float>& row, float light) {
        for (std::size_t i = 1; i < row.size(); ++i) {
            if (row[i] >= light && row[i - 1] < light)
                return static_cast<float>(i) - (row[i] - light) / (row[i] - row[i - 1]);
        }
        ADD_FAILURE() << "never above " << light;
        return 0.0F;
    }
    /// Of a row that a disc has blurred across a straight edge: 80 % of its light lie within 1.374
    /// of its radius.
    static float blur_radius_px(const std::vector<float>& row) {
        return (crossing(row, 0.9F) - crossing(row, 0.1F)) / 1.374F;
    }
};

}  // namespace plumbline::render
