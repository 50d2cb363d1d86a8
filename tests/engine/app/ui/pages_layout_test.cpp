// Every page at every size: nothing is cut, nothing overlaps.
#include "tests/engine/app/ui/pages_fixture.h"

namespace plumbline::app::ui {
namespace {

// Every page at the sizes people have: nothing cut, nothing over something else, all in the window.
class PagesAtSize : public PagesTest, public testing::WithParamInterface<std::pair<int, int>> {
protected:
    void look() {
        lay_out();
        const MenuLayout& layout = control_->menu().layout();
        const std::string& title = control_->menu().page().title;
        const Box window{0.0F, 0.0F, canvas_.width_px(), canvas_.height_px()};
        for (const Box& box : {layout.panel, layout.title, layout.view}) {
            EXPECT_GE(box.x, 0.0F) << title;
            EXPECT_GE(box.y, 0.0F) << title;
            EXPECT_LE(box.right(), window.right() + 0.01F) << title;
            EXPECT_LE(box.bottom(), window.bottom() + 0.01F) << title;
        }
        std::vector<Box> boxes = layout.labels;
        for (const PlacedCell& placed : layout.cells) boxes.push_back(placed.box);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_GE(boxes[i].x, layout.view.x - 0.01F) << title;
            EXPECT_LE(boxes[i].right(), layout.view.right() + 0.01F) << title;
            for (std::size_t j = i + 1; j < boxes.size(); ++j)
                EXPECT_FALSE(overlap(boxes[i], boxes[j])) << title << ": " << i << ", " << j;
        }
        for (int pages = 0; pages < 60; ++pages) {
            const float before = control_->menu().scroll_px();
            canvas_.begin({});
            canvas_.draw(control_->menu());
            canvas_.end();
            EXPECT_TRUE(canvas_.cut_texts().empty()) << title << ": " << canvas_.cut_texts()[0];
            keys({267});
            if (control_->menu().scroll_px() == before) break;
        }
    }
};

TEST_P(PagesAtSize, NothingIsCutAndNothingOverlaps) {
    resize(GetParam().first, GetParam().second);
    control_->show_start();
    look();
    choose("Hard cases");
    look();
    keys({kEscape});
    choose("Settings");
    for (const char* tab :
         {"Graphics", "Display", "Sound", "Mouse and pad", "Light and fog", "Accuracy"}) {
        choose(tab);
        look();
    }
    choose("Controls");
    look();
    choose("Q", "Drop the selected object");
    look();
    keys({'F'});
    look();
    keys({kEscape, kEscape, kEscape, kEscape});
    keys({'H'});
    look();
    keys({'H', kEscape});
    look();
}

INSTANTIATE_TEST_SUITE_P(Windows,
                         PagesAtSize,
                         testing::Values(std::pair{640, 360},
                                         std::pair{1280, 720},
                                         std::pair{3840, 2160},
                                         std::pair{480, 270},
                                         std::pair{720, 1280}));

}  // namespace
}  // namespace plumbline::app::ui
