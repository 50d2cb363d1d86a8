// Small images: each within its square, none like another.
#include "engine/app/ui/canvas_impl.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace plumbline::app::ui {
namespace {

/// Corners of what the icon is drawn with.
std::vector<ImVec2> corners_of(Icon icon, ImVec2 middle, float size_px) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    draw_icon(list, icon, middle, size_px, IM_COL32_WHITE);
    std::vector<ImVec2> corners;
    for (const ImDrawVert& corner : list.VtxBuffer) corners.push_back(corner.pos);
    return corners;
}

TEST(Icons, StayWithinTheirSquareAtAnySize) {
    Canvas canvas;
    canvas.resize(640, 360, 1.0F, 0.0F);
    canvas.begin({});
    for (const float size_px : {8.0F, 64.0F}) {
        for (int i = 1; i <= static_cast<int>(Icon::Save); ++i) {
            const auto corners = corners_of(static_cast<Icon>(i), {100, 100}, size_px);
            EXPECT_FALSE(corners.empty()) << i;
            // Half a line's width and the fringe of its smoothed edge may stand out.
            const float most = size_px * (0.5F + 0.12F) + 1.5F;
            for (const ImVec2& corner : corners) {
                EXPECT_LE(std::abs(corner.x - 100.0F), most) << i;
                // The question mark is a letter, which is higher than wide.
                if (static_cast<Icon>(i) == Icon::Help) continue;
                EXPECT_LE(std::abs(corner.y - 100.0F), most) << i;
            }
        }
    }
    EXPECT_TRUE(corners_of(Icon::None, {100, 100}, 64.0F).empty());
    canvas.end();
}

TEST(Icons, DifferFromEachOther) {
    Canvas canvas;
    canvas.resize(640, 360, 1.0F, 0.0F);
    canvas.begin({});
    std::set<std::vector<std::pair<float, float>>> images;
    for (int i = 1; i <= static_cast<int>(Icon::Save); ++i) {
        std::vector<std::pair<float, float>> image;
        for (const ImVec2& corner : corners_of(static_cast<Icon>(i), {0, 0}, 32.0F))
            image.emplace_back(corner.x, corner.y);
        EXPECT_TRUE(images.insert(std::move(image)).second) << i;
    }
    canvas.end();
}

}  // namespace
}  // namespace plumbline::app::ui
