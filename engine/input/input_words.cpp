#include "engine/core/text/nearest_name.h"
#include "engine/core/text/split.h"
#include "engine/core/text/text_case.h"
#include "engine/input/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::input {
namespace {

struct Word {
    std::string_view word;
    DeviceKind kind;
    int code;
    int direction;
};

/// Words whose codes follow one another.
struct Row {
    DeviceKind kind;
    int first;
    std::string_view words;
    int direction{0};
};

using enum DeviceKind;

// GLFW's names and codes in lower case: one list serves parsing, printing and "nearest".
constexpr auto kRows = std::to_array<Row>({
    {Key, 65, "a b c d e f g h i j k l m n o p q r s t u v w x y z"},
    {Key, 48, "0 1 2 3 4 5 6 7 8 9"},
    {Key, 39, "'"},
    {Key, 44, ", - . /"},
    {Key, 59, ";"},
    {Key, 61, "="},
    {Key, 91, "[ \\ ]"},
    {Key, 96, "`"},
    {Key, 161, "world_1 world_2"},
    {Key, 32, "space"},
    {Key, 256, "escape enter tab backspace insert delete right left down up"},
    {Key, 266, "page_up page_down home end"},
    {Key, 280, "caps_lock scroll_lock num_lock print_screen pause"},
    {Key, 290, "f1 f2 f3 f4 f5 f6 f7 f8 f9 f10 f11 f12 f13"},
    {Key, 303, "f14 f15 f16 f17 f18 f19 f20 f21 f22 f23 f24 f25"},
    {Key, 320, "kp_0 kp_1 kp_2 kp_3 kp_4 kp_5 kp_6 kp_7 kp_8 kp_9"},
    {Key, 330, "kp_decimal kp_divide kp_multiply kp_subtract kp_add kp_enter kp_equal"},
    {Key, 340, "left_shift left_control left_alt left_super"},
    {Key, 344, "right_shift right_control right_alt right_super menu"},
    {MouseButton, 0, "mouse.left mouse.right mouse.middle mouse.4 mouse.5 mouse.6 mouse.7 mouse.8"},
    {MouseMove, 0, "mouse.move"},
    {Wheel, 0, "wheel.up wheel.down wheel.left wheel.right"},
    {PadButton, 0, "pad.a pad.b pad.x pad.y pad.left_bumper pad.right_bumper"},
    {PadButton, 6, "pad.back pad.start pad.guide pad.left_thumb pad.right_thumb"},
    {PadButton, 11, "pad.dpad_up pad.dpad_right pad.dpad_down pad.dpad_left"},
    {PadAxis, 0, "pad.left_x-", -1},
    {PadAxis, 0, "pad.left_x+", 1},
    {PadAxis, 1, "pad.left_y-", -1},
    {PadAxis, 1, "pad.left_y+", 1},
    {PadAxis, 2, "pad.right_x-", -1},
    {PadAxis, 2, "pad.right_x+", 1},
    {PadAxis, 3, "pad.right_y-", -1},
    {PadAxis, 3, "pad.right_y+", 1},
    {PadAxis, 4, "pad.left_trigger pad.right_trigger", 1},
    {PadStick, 0, "pad.left_stick pad.right_stick"},
});

const std::vector<Word>& all_words() {
    static const std::vector<Word> kAll = [] {
        std::vector<Word> all;
        for (const Row& row : kRows) {
            int code = row.first;
            for (std::string_view rest = row.words; !rest.empty(); ++code)
                all.push_back({cut_part(rest, ' '), row.kind, code, row.direction});
        }
        return all;
    }();
    return kAll;
}

struct Alias {
    std::string_view alias;
    std::string_view word;
};

// What Quake's family of games and GLFW's own constants call them.
constexpr auto kAliases = std::to_array<Alias>({
    {"shift", "left_shift"},
    {"ctrl", "left_control"},
    {"control", "left_control"},
    {"alt", "left_alt"},
    {"super", "left_super"},
    {"left_ctrl", "left_control"},
    {"right_ctrl", "right_control"},
    {"rshift", "right_shift"},
    {"rctrl", "right_control"},
    {"ralt", "right_alt"},
    {"mouse1", "mouse.left"},
    {"mouse2", "mouse.right"},
    {"mouse3", "mouse.middle"},
    {"mouse4", "mouse.4"},
    {"mouse5", "mouse.5"},
    {"mouse6", "mouse.6"},
    {"mouse7", "mouse.7"},
    {"mouse8", "mouse.8"},
    {"mwheelup", "wheel.up"},
    {"mwheeldown", "wheel.down"},
    {"uparrow", "up"},
    {"downarrow", "down"},
    {"leftarrow", "left"},
    {"rightarrow", "right"},
    {"pgup", "page_up"},
    {"pgdn", "page_down"},
    {"ins", "insert"},
    {"del", "delete"},
    {"esc", "escape"},
    {"return", "enter"},
    {"capslock", "caps_lock"},
    {"spacebar", "space"},
    {"semicolon", ";"},
    {"backquote", "`"},
    {"grave_accent", "`"},
    {"apostrophe", "'"},
    {"comma", ","},
    {"minus", "-"},
    {"period", "."},
    {"slash", "/"},
    {"equal", "="},
    {"backslash", "\\"},
    {"left_bracket", "["},
    {"right_bracket", "]"},
    {"kp_ins", "kp_0"},
    {"kp_end", "kp_1"},
    {"kp_downarrow", "kp_2"},
    {"kp_pgdn", "kp_3"},
    {"kp_leftarrow", "kp_4"},
    {"kp_rightarrow", "kp_6"},
    {"kp_home", "kp_7"},
    {"kp_uparrow", "kp_8"},
    {"kp_pgup", "kp_9"},
    {"kp_del", "kp_decimal"},
    {"kp_slash", "kp_divide"},
    {"kp_minus", "kp_subtract"},
    {"kp_plus", "kp_add"},
});

struct ModifierWord {
    std::string_view prefix;
    Modifier modifier;
};
// In the order in which canonical words name them.
constexpr auto kModifierWords = std::to_array<ModifierWord>({{"ctrl+", kCtrl},
                                                             {"shift+", kShift},
                                                             {"alt+", kAlt},
                                                             {"super+", kSuper},
                                                             {"control+", kCtrl}});

constexpr std::string_view kLabelPrefix = "label:";
constexpr std::size_t kLongestWord = 64;

std::uint8_t take_modifiers(std::string_view& word) {
    unsigned modifiers = 0;
    for (bool found = true; found;) {
        found = false;
        for (const ModifierWord& entry : kModifierWords) {
            if (!word.starts_with(entry.prefix) || word.size() == entry.prefix.size()) continue;
            modifiers |= entry.modifier;
            word.remove_prefix(entry.prefix.size());
            found = true;
        }
    }
    return static_cast<std::uint8_t>(modifiers);
}

std::string with_modifiers(std::uint8_t modifiers, std::string_view word) {
    std::string text;
    for (const ModifierWord& entry : kModifierWords) {
        if (entry.prefix == "control+" || (modifiers & entry.modifier) == 0) continue;
        text += entry.prefix;
    }
    return text.append(word);
}

Result<Input> parse_label(std::string_view label, std::uint8_t modifiers) {
    const bool prints = label.size() == 1 && label[0] > ' ' && label[0] < 0x7F;
    if (!prints)
        return Error{.message = fmt::format(
                         "\"label:{}\" needs one printed character, as in \"label:/\"", label)};
    const char printed = to_lower(label[0]);
    return Input{.kind = Label,
                 .modifiers = modifiers,
                 .label = printed,
                 .word = with_modifiers(modifiers, fmt::format("label:{}", printed)),
                 .origin = {}};
}

Error unknown_word(std::string_view word, std::string_view base) {
    std::string message = fmt::format("unknown input \"{}\"", word);
    if (const std::string_view nearest = nearest_name(base, input_words()); !nearest.empty())
        message += fmt::format(". Nearest: \"{}\"", nearest);
    return {.message = std::move(message)};
}

}  // namespace

const std::vector<std::string_view>& input_words() {
    static const std::vector<std::string_view> kAll = [] {
        std::vector<std::string_view> words;
        for (const Word& word : all_words()) words.push_back(word.word);
        return words;
    }();
    return kAll;
}

std::optional<Input> input_of(DeviceKind kind, int code, int direction, std::uint8_t modifiers) {
    const auto found = std::ranges::find_if(all_words(), [&](const Word& word) {
        return word.kind == kind && word.code == code && word.direction == direction;
    });
    if (found == all_words().end()) return std::nullopt;
    Result<Input> input = parse_input(with_modifiers(modifiers, found->word));
    return input ? std::optional<Input>{*input} : std::nullopt;
}

Result<Input> parse_input(std::string_view word) {
    if (word.size() > kLongestWord)
        return Error{.message = fmt::format("unknown input of {} letters", word.size())};
    const std::string lower = to_lower(word);
    std::string_view base = lower;
    const std::uint8_t modifiers = take_modifiers(base);
    if (base.starts_with(kLabelPrefix))
        return parse_label(base.substr(kLabelPrefix.size()), modifiers);
    const auto* const alias = std::ranges::find(kAliases, base, &Alias::alias);
    if (alias != kAliases.end()) base = alias->word;
    const auto found = std::ranges::find(all_words(), base, &Word::word);
    if (found == all_words().end()) return unknown_word(word, base);
    const bool is_chordable =
        found->kind != MouseMove && found->kind != PadAxis && found->kind != PadStick;
    if (modifiers != 0 && !is_chordable)
        return Error{.message = fmt::format("\"{}\" cannot be part of a chord", found->word)};
    return Input{.kind = found->kind,
                 .code = found->code,
                 .direction = found->direction,
                 .modifiers = modifiers,
                 .word = with_modifiers(modifiers, found->word),
                 .origin = {}};
}

}  // namespace plumbline::input
