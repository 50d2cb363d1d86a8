// A page of the menu as plain data: lines of cells that can be chosen. Says nothing of where they
// are drawn or which device chose them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline::app::ui {

/// Small images that need no words.
enum class Icon : std::uint8_t {
    None,
    Play,
    Again,
    Scenes,
    Settings,
    Keys,
    Help,
    Quit,
    Back,
    Image,
    Screen,
    Sound,
    Mouse,
    Accuracy,
    On,
    Off,
    Light,
    Save
};

/// Something that can be chosen. Functions that are empty are not offered.
struct Cell {
    std::string text;
    std::string note{};       ///< cards: the line below
    std::string thumbnail{};  ///< cards: name of a thumbnail
    Icon icon{Icon::None};
    std::optional<float> fraction{};            ///< sliders: 0…1 of the way is filled
    std::function<void()> activate{};           ///< Enter, a click, the pad's accept
    std::function<void(int)> adjust{};          ///< left -1, right +1
    std::function<void(float)> set_fraction{};  ///< a click or drag at 0…1 of the width
    std::function<void()> remove{};             ///< Delete
    bool marked{false};                         ///< the one that is in force
};

enum class LineKind : std::uint8_t {
    Heading,
    Text,   ///< wrapped, not chosen
    Cells,  ///< cells side by side as wide as their text, wrapped; label before them, if any
    List,   ///< cells below each other over the whole width
    Cards,  ///< cells with images, as many beside each other as fit
    Keys,   ///< label and value in two columns, not chosen; as many such beside each other as fit
};

struct Line {
    LineKind kind{LineKind::Text};
    std::string label{};
    std::string value{};
    std::vector<Cell> cells{};
};

struct Page {
    std::string title;
    std::vector<Line> lines;
    float most_width{64.0F};  ///< of the panel, in letters' heights
    /// Tabs: the first line does not scroll, and the panel is as high as the window whatever is below.
    bool pins_first_line{false};

    void add_heading(std::string_view words) {
        lines.push_back({.kind = LineKind::Heading, .label = std::string(words)});
    }
    void add_text(std::string words) {
        lines.push_back({.kind = LineKind::Text, .label = std::move(words)});
    }
    void add_cells(std::vector<Cell> cells, std::string label = {}) {
        lines.push_back(
            {.kind = LineKind::Cells, .label = std::move(label), .cells = std::move(cells)});
    }
    void add_cards(std::vector<Cell> cells) {
        lines.push_back({.kind = LineKind::Cards, .cells = std::move(cells)});
    }
    void add_keys(std::string keys, std::string_view words) {
        lines.push_back(
            {.kind = LineKind::Keys, .label = std::move(keys), .value = std::string(words)});
    }
};

}  // namespace plumbline::app::ui
