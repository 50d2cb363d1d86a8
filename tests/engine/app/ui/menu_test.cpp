#include "engine/app/ui/menu.h"

#include "engine/app/ui/menu_input.h"
#include "tests/engine/app/ui/square_text.h"

#include <gtest/gtest.h>

namespace plumbline::app::ui {
namespace {

class MenuTest : public testing::Test {
protected:
    void open(int buttons) {
        menu_.lay_out(1280.0F, 720.0F, 17.0F, text_);
        menu_.start(
            [this, buttons] {
                Page page{.title = "Title"};
                Line list{.kind = LineKind::List};
                for (int i = 0; i < buttons; ++i) {
                    list.cells.push_back({.text = "button " + std::to_string(i),
                                          .activate = [this, i] { chosen_.push_back(i); }});
                }
                Line row{.kind = LineKind::Cells, .label = "row"};
                row.cells.push_back({.text = "slider",
                                     .fraction = 0.5F,
                                     .adjust = [this](int by) { value_ += by; },
                                     .set_fraction = [this](float at) { fraction_ = at; },
                                     .remove = [this] { removed_ = true; }});
                row.cells.push_back({.text = "beside", .activate = [this] { beside_ = true; }});
                page.lines = {list, row};
                return page;
            },
            true);
    }

    void press(std::initializer_list<MenuPress> presses) {
        for (const MenuPress each : presses) menu_.press(each);
    }

    const Box& box_of(CellPlace place) const {
        for (const PlacedCell& cell : menu_.layout().cells)
            if (cell.place == place) return cell.box;
        static const Box kNone;
        return kNone;
    }

    TextSize text_{square_text(17.0F)};
    Menu menu_;
    std::vector<int> chosen_;
    int value_{0};
    float fraction_{-1.0F};
    bool removed_{false};
    bool beside_{false};
};

TEST_F(MenuTest, ArrowsMoveAndAcceptChooses) {
    using enum MenuPress;
    open(3);
    press({Down, Accept, Down, Accept});
    press({Up, Up, Up, Accept});  // nothing above the first
    EXPECT_EQ(chosen_, (std::vector<int>{1, 2, 0}));
}

TEST_F(MenuTest, LeftAndRightAdjustWhatCanBeAdjusted) {
    using enum MenuPress;
    open(1);
    press({Down, Right, Right, Left, Right});
    EXPECT_EQ(value_, 2);
    menu_.press(MenuPress::Remove);
    EXPECT_TRUE(removed_);
}

TEST_F(MenuTest, ThePointerChoosesWhatItIsOver) {
    open(3);
    const Box box = box_of({0, 2});
    menu_.point_at(box.x + 3.0F, box.y + 3.0F);
    EXPECT_EQ(menu_.focus(), (CellPlace{0, 2}));
    menu_.press(MenuPress::Click);
    EXPECT_EQ(chosen_, (std::vector<int>{2}));
    menu_.point_at(1.0F, 1.0F);  // beside the panel
    menu_.press(MenuPress::Click);
    EXPECT_EQ(chosen_.size(), 1U);
}

TEST_F(MenuTest, ADraggedSliderFollowsThePointerAlsoBesideIt) {
    open(1);
    const Box box = box_of({1, 0});
    menu_.point_at(box.x + box.width * 0.25F, box.y + 2.0F);
    menu_.press(MenuPress::Click);
    EXPECT_NEAR(fraction_, 0.25F, 1e-4F);
    menu_.point_at(box.right() + 500.0F, box.y + 90.0F);
    EXPECT_EQ(fraction_, 1.0F);
    menu_.release_drag();
    menu_.point_at(box.x, box.y + 2.0F);
    EXPECT_EQ(fraction_, 1.0F);
}

TEST_F(MenuTest, BackLeadsThroughThePagesAndOut) {
    open(2);
    menu_.push([] { return Page{.title = "Second"}; });
    EXPECT_EQ(menu_.page().title, "Second");
    menu_.press(MenuPress::Back);
    EXPECT_EQ(menu_.page().title, "Title");
    menu_.press(MenuPress::Back);
    EXPECT_FALSE(menu_.open());
}

TEST_F(MenuTest, ALongPageScrollsToWhatIsChosen) {
    open(60);
    ASSERT_GT(menu_.layout().content_height, menu_.layout().view.height);
    for (int i = 0; i < 59; ++i) menu_.press(MenuPress::Down);
    const Box last = box_of({0, 59});
    EXPECT_GE(last.y - menu_.scroll_px(), menu_.layout().view.y - 0.01F);
    EXPECT_LE(last.bottom() - menu_.scroll_px(), menu_.layout().view.bottom() + 0.01F);
    menu_.press(MenuPress::Accept);
    EXPECT_EQ(chosen_, (std::vector<int>{59}));
}

TEST_F(MenuTest, WhatIsChosenStaysWithinAPageThatBecomesShorter) {
    int cells = 5;
    menu_.lay_out(1280.0F, 720.0F, 17.0F, text_);
    menu_.start(
        [&cells] {
            Line list{.kind = LineKind::List};
            for (int i = 0; i < cells; ++i)
                list.cells.push_back({.text = "x", .activate = [&cells] { --cells; }});
            return Page{.title = "t", .lines = {list}};
        },
        true);
    for (int i = 0; i < 4; ++i) menu_.press(MenuPress::Down);
    for (int i = 0; i < 9; ++i) menu_.press(MenuPress::Accept);
    EXPECT_EQ(cells, 0);
}

DeviceEvent key(int code, bool pressed = true) {
    return {DeviceEventKind::Key, code, pressed};
}

TEST(MenuKeys, EnterSpaceAndThePadAccept) {
    const input::Bindings bindings = input::built_in_bindings();
    for (const DeviceEvent& event :
         {key(257), key(335), key(32), DeviceEvent{DeviceEventKind::PadButton, 0, true}}) {
        EXPECT_EQ(MenuKeys::press_of(event, bindings), std::vector{MenuPress::Accept});
    }
    EXPECT_TRUE(MenuKeys::press_of(key(257, false), bindings).empty());
    EXPECT_EQ(MenuKeys::press_of(key(259), bindings), std::vector{MenuPress::Back});  // back_out
}

TEST(MenuKeys, ArrowsThatAreKeptDownRepeatByTimeNotByFrames) {
    MenuKeys keys;
    InputSnapshot input;
    input.keys.set(264);
    EXPECT_TRUE(keys.repeats(input).empty());
    input.now_s = 0.39;
    EXPECT_TRUE(keys.repeats(input).empty());
    input.now_s = 0.76;  // one at 0.4 s and then one every 0.07 s, however late the frame
    EXPECT_EQ(keys.repeats(input), std::vector<MenuPress>(6, MenuPress::Down));
    input.keys.reset();
    input.now_s = 3.0;
    EXPECT_TRUE(keys.repeats(input).empty());
}

TEST(MenuKeys, AStickThatIsPushedOutCountsOnce) {
    MenuKeys keys;
    InputSnapshot input;
    input.pad_present = true;
    input.pad_axes[1] = 0.9F;
    EXPECT_EQ(keys.repeats(input), std::vector{MenuPress::Down});
    input.now_s = 0.2;
    EXPECT_TRUE(keys.repeats(input).empty());
    input.pad_axes[1] = 0.0F;
    EXPECT_TRUE(keys.repeats(input).empty());
    input.pad_axes[0] = -0.9F;
    EXPECT_EQ(keys.repeats(input), std::vector{MenuPress::Left});
}

}  // namespace
}  // namespace plumbline::app::ui
