// What of a page is drawn: its colours, the frame round what is chosen, the bar beside what scrolls.
// That no page is cut is pages_layout_test.cpp's.
#include "engine/app/ui/canvas_impl.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::app::ui {
namespace {

constexpr ImU32 kChosenFrame = IM_COL32(255, 209, 115, 255);
constexpr ImU32 kPlainCell = IM_COL32(52, 56, 68, 255);
constexpr ImU32 kInForce = IM_COL32(38, 92, 138, 255);
constexpr ImU32 kFilledPart = IM_COL32(46, 104, 152, 255);
constexpr ImU32 kBar = IM_COL32(190, 192, 200, 255);

class MenuDraw : public testing::Test {
protected:
    MenuDraw() { canvas_.resize(640, 360, 1.0F, 0.0F); }

    void show(std::vector<Line> lines) {
        menu_.lay_out(640.0F, 360.0F, canvas_.font_px(), canvas_.text_size());
        menu_.start([lines] { return Page{.title = "", .lines = lines}; }, true);
        draw();
    }
    void draw() {
        canvas_.begin({});
        canvas_.draw(menu_);
        corners_.clear();
        for (const ImDrawVert& corner : ImGui::GetForegroundDrawList()->VtxBuffer)
            corners_.push_back(corner);
        canvas_.end();
    }
    /// The box round everything of that colour; of no width where there is nothing.
    Box box_of(ImU32 color) const {
        float left = 1e9F;
        float right = -1e9F;
        float top = 1e9F;
        float bottom = -1e9F;
        for (const ImDrawVert& corner : corners_) {
            if (corner.col != color) continue;
            left = std::min(left, corner.pos.x);
            right = std::max(right, corner.pos.x);
            top = std::min(top, corner.pos.y);
            bottom = std::max(bottom, corner.pos.y);
        }
        return left > right ? Box{} : Box{left, top, right - left, bottom - top};
    }
    const Box& placed(std::size_t cell) const { return menu_.layout().cells.at(cell).box; }

    Canvas canvas_;
    Menu menu_;
    std::vector<ImDrawVert> corners_;
};

TEST_F(MenuDraw, WhatIsInForceAndWhatIsChosenStandOut) {
    show({{.kind = LineKind::List, .cells = {{.text = ""}, {.text = "", .marked = true}}}});
    EXPECT_NEAR(box_of(kPlainCell).y, placed(0).y, 1.0F);
    EXPECT_NEAR(box_of(kPlainCell).bottom(), placed(0).bottom(), 1.0F);
    EXPECT_NEAR(box_of(kInForce).y, placed(1).y, 1.0F);
    EXPECT_NEAR(box_of(kChosenFrame).bottom(), placed(1).bottom(), 2.0F) << "chosen as it opens";
    menu_.press(MenuPress::Up);
    draw();
    EXPECT_NEAR(box_of(kChosenFrame).bottom(), placed(0).bottom(), 2.0F);
}

TEST_F(MenuDraw, ASliderIsFilledSoFar) {
    Cell quarter{.text = "", .fraction = 0.25F, .set_fraction = [](float) {}};
    show({{.kind = LineKind::Cells, .cells = {quarter}}});
    // Edges run through the middle of pixels: half of one is left out on each side.
    EXPECT_NEAR(box_of(kFilledPart).width, placed(0).width * 0.25F - 1.0F, 0.01F);
    quarter.fraction = 7.0F;
    show({{.kind = LineKind::Cells, .cells = {quarter}}});
    EXPECT_NEAR(box_of(kFilledPart).width, placed(0).width - 1.0F, 0.01F) << "never beyond its end";
}

TEST_F(MenuDraw, OnlyAPageThatIsHigherThanItsViewHasABar) {
    show({{.kind = LineKind::List, .cells = std::vector<Cell>(3)}});
    EXPECT_EQ(box_of(kBar).width, 0.0F);
    show({{.kind = LineKind::List, .cells = std::vector<Cell>(60)}});
    const MenuLayout& layout = menu_.layout();
    EXPECT_NEAR(
        box_of(kBar).height, layout.view.height * layout.view.height / layout.content_height, 1.5F);
    EXPECT_NEAR(box_of(kBar).y, layout.view.y, 1.0F);
    for (int i = 0; i < 59; ++i) menu_.press(MenuPress::Down);
    draw();
    EXPECT_NEAR(box_of(kBar).bottom(), layout.view.bottom(), 2.0F);
}

TEST_F(MenuDraw, AMenuThatIsClosedDrawsNothing) {
    canvas_.begin({});
    canvas_.draw(menu_);
    EXPECT_TRUE(ImGui::GetForegroundDrawList()->VtxBuffer.empty());
    canvas_.end();
}

}  // namespace
}  // namespace plumbline::app::ui
