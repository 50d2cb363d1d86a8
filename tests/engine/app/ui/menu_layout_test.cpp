// Where the parts of a page stand, and which of them lies in a direction. Letters are 10 px high and
// 5 px wide; a cell is 17.5 px high with 7 px beside its text and 3.5 px to the next.
#include "engine/app/ui/menu_layout.h"

#include "tests/engine/app/ui/square_text.h"

#include <gtest/gtest.h>

namespace plumbline::app::ui {
namespace {

constexpr float kFont_px = 10.0F;

Cell named(std::string text) {
    return {.text = std::move(text)};
}

MenuLayout laid_out(std::vector<Line> lines, float width_px = 656.0F, float height_px = 400.0F) {
    return layout_of({.title = "T", .lines = std::move(lines)},
                     width_px,
                     height_px,
                     kFont_px,
                     square_text(kFont_px));
}

void expect_box(const Box& box, float x, float y, float width, float height) {
    EXPECT_FLOAT_EQ(box.x, x);
    EXPECT_FLOAT_EQ(box.y, y);
    EXPECT_FLOAT_EQ(box.width, width);
    EXPECT_FLOAT_EQ(box.height, height);
}

TEST(MenuLayoutOf, PutsAPageThatNeedsLessInTheMiddleOfTheWindow) {
    const MenuLayout layout =
        laid_out({{.kind = LineKind::List, .cells = {named("a"), named("b")}}});
    EXPECT_FLOAT_EQ(layout.panel.y + layout.panel.bottom(), 400.0F);
    EXPECT_FLOAT_EQ(layout.panel.x + layout.panel.right(), 656.0F);
    EXPECT_FLOAT_EQ(layout.panel.width, 640.0F) << "the margins are 8 px, and 64 letters fit";
    EXPECT_FLOAT_EQ(layout.content_height, 2 * (17.5F + 3.5F));
    EXPECT_FLOAT_EQ(layout.view.height, layout.content_height);
    ASSERT_EQ(layout.cells.size(), 2U);
    expect_box(layout.cells[0].box, layout.view.x, layout.view.y, layout.view.width, 17.5F);
    expect_box(layout.cells[1].box, layout.view.x, layout.view.y + 21.0F, layout.view.width, 17.5F);
    EXPECT_FLOAT_EQ(laid_out({}, 2000.0F).panel.width, 640.0F) << "no wider than its most";
}

TEST(MenuLayoutOf, WrapsCellsBehindTheirLabel) {
    // Cells of 80 letters are 414 px wide: two do not fit beside each other.
    Cell slider = named("s");
    slider.set_fraction = [](float) {};
    Cell icon = named("i");
    icon.icon = Icon::Help;
    const MenuLayout layout =
        laid_out({{.kind = LineKind::Cells,
                   .cells = {named(std::string(80, 'x')), named("y"), slider, icon}},
                  {.kind = LineKind::Cells, .label = "label", .cells = {named("z")}}});
    const float left = layout.view.x;
    ASSERT_EQ(layout.cells.size(), 5U);
    expect_box(layout.cells[0].box, left, layout.view.y, 414.0F, 17.5F);
    expect_box(layout.cells[1].box, left + 417.5F, layout.view.y, 19.0F, 17.5F);
    expect_box(layout.cells[2].box, left + 440.0F, layout.view.y, 110.0F, 17.5F);
    expect_box(layout.cells[3].box, left + 553.5F, layout.view.y, 33.0F, 17.5F);
    EXPECT_FLOAT_EQ(layout.cells[4].box.x, left + 170.0F) << "17 letters for the label";
    EXPECT_FLOAT_EQ(layout.cells[4].box.y, layout.view.y + 21.0F);

    const MenuLayout narrow = laid_out(
        {{.kind = LineKind::Cells, .cells = {named(std::string(80, 'x')), named("y")}}}, 400.0F);
    EXPECT_FLOAT_EQ(narrow.cells[0].box.width, narrow.view.width);
    EXPECT_FLOAT_EQ(narrow.cells[1].box.x, narrow.view.x);
    EXPECT_FLOAT_EQ(narrow.cells[1].box.y, narrow.view.y + 21.0F);
}

TEST(MenuLayoutOf, PutsAsManyCardsInARowAsFitAndMakesRowsAsHighAsTheHighest) {
    std::vector<Cell> cards(5, named("c"));
    cards[1].note = "a note";
    for (Cell& card : cards) card.thumbnail = "t";
    // 622 px take four cards of 145 px or more.
    const MenuLayout layout = laid_out({{.kind = LineKind::Cards, .cells = cards}});
    const float width = (layout.view.width - 3 * 3.5F) / 4;
    const float image = width * 9.0F / 16.0F;
    ASSERT_EQ(layout.cells.size(), 5U);
    expect_box(layout.cells[0].box, layout.view.x, layout.view.y, width, image + 10.0F + 7.0F);
    EXPECT_FLOAT_EQ(layout.cells[1].box.height, image + 20.0F + 7.0F);
    EXPECT_FLOAT_EQ(layout.cells[3].box.right(), layout.view.right());
    expect_box(layout.cells[4].box,
               layout.view.x,
               layout.view.y + image + 27.0F + 3.5F,
               width,
               image + 17.0F);
}

TEST(MenuLayoutOf, LetsKeysFlowOverColumns) {
    // 622 px are two columns of 260 px or more.
    const Line pair{.kind = LineKind::Keys, .label = "K", .value = "does"};
    const MenuLayout layout =
        laid_out({pair, pair, pair, {.kind = LineKind::Text, .label = "end"}});
    const float column = layout.view.width / 2;
    ASSERT_EQ(layout.labels.size(), 4U);
    expect_box(layout.labels[0], layout.view.x, layout.view.y, column / 2, 11.5F);
    expect_box(layout.labels[1], layout.view.x + column, layout.view.y, column / 2, 11.5F);
    expect_box(layout.labels[2], layout.view.x, layout.view.y + 11.5F, column / 2, 11.5F);
    expect_box(layout.labels[3], layout.view.x, layout.view.y + 23.0F, layout.view.width, 12.0F);
}

TEST(MenuLayoutOf, GoesToTheNextRowFirstAndInItToWhatStandsAboveOrBelow) {
    const MenuLayout layout =
        laid_out({{.kind = LineKind::Cells, .cells = {named("aaaaaaaaaa"), named("bbbbbbbbbb")}},
                  {.kind = LineKind::Cells, .cells = {named("c"), named("d"), named("eeeeeeeeee")}},
                  {.kind = LineKind::List, .cells = {named("f")}}});
    EXPECT_EQ(neighbour(layout, {0, 0}, 1, 0), (CellPlace{0, 1}));
    EXPECT_EQ(neighbour(layout, {0, 1}, 1, 0), (CellPlace{0, 1})) << "nothing on the right";
    EXPECT_EQ(neighbour(layout, {0, 1}, 0, 1), (CellPlace{1, 2}));
    EXPECT_EQ(neighbour(layout, {0, 0}, 0, 1), (CellPlace{1, 0}));
    EXPECT_EQ(neighbour(layout, {2, 0}, 0, -1), (CellPlace{1, 0}));
    EXPECT_EQ(neighbour(layout, {0, 0}, 0, -1), (CellPlace{0, 0}));
    EXPECT_EQ(neighbour(layout, {9, 9}, 0, 1), (CellPlace{0, 0})) << "it is gone: the first";
    EXPECT_EQ(neighbour(laid_out({}), {9, 9}, 0, 1), (CellPlace{9, 9}));
}

TEST(MenuLayoutOf, ScrollsNoFartherThanItMust) {
    const MenuLayout layout =
        laid_out({{.kind = LineKind::List, .cells = std::vector<Cell>(40, named("x"))}});
    const float most = 40 * 21.0F - layout.view.height;
    ASSERT_GT(most, 0.0F);
    EXPECT_FLOAT_EQ(clamp_scroll(layout, -5.0F), 0.0F);
    EXPECT_FLOAT_EQ(clamp_scroll(layout, 1e6F), most);
    EXPECT_FLOAT_EQ(scroll_to(layout, {0, 3}, 10.0F), 10.0F) << "it is seen already";
    EXPECT_FLOAT_EQ(scroll_to(layout, {0, 30}, 0.0F), 30 * 21.0F + 17.5F - layout.view.height);
    EXPECT_FLOAT_EQ(scroll_to(layout, {0, 5}, most), 5 * 21.0F);
    EXPECT_FLOAT_EQ(scroll_to(layout, {0, 0}, most), 0.0F);
    EXPECT_FLOAT_EQ(scroll_to(layout, {7, 0}, 1e6F), most) << "nothing there";
}

TEST(MenuLayoutOf, BoxesThatTouchDoNotOverlap) {
    EXPECT_TRUE(overlap({0, 0, 10, 10}, {9, 9, 10, 10}));
    EXPECT_FALSE(overlap({0, 0, 10, 10}, {10, 0, 10, 10}));
    EXPECT_FALSE(overlap({0, 0, 10, 10}, {0, 10, 10, 10}));
    EXPECT_TRUE(overlap({0, 0, 10, 10}, {2, 2, 1, 1})) << "inside";
}

}  // namespace
}  // namespace plumbline::app::ui
