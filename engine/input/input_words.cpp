#include "engine/core/text/nearest_name.h"
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
    int direction{0};
};

using enum DeviceKind;

// GLFW's names and codes in lower case. Letters, digits, function keys and the keypad's digits are
// in the table too: one list serves parsing, printing and "nearest".
constexpr auto kWords = std::to_array<Word>({
    {"a", Key, 65},
    {"b", Key, 66},
    {"c", Key, 67},
    {"d", Key, 68},
    {"e", Key, 69},
    {"f", Key, 70},
    {"g", Key, 71},
    {"h", Key, 72},
    {"i", Key, 73},
    {"j", Key, 74},
    {"k", Key, 75},
    {"l", Key, 76},
    {"m", Key, 77},
    {"n", Key, 78},
    {"o", Key, 79},
    {"p", Key, 80},
    {"q", Key, 81},
    {"r", Key, 82},
    {"s", Key, 83},
    {"t", Key, 84},
    {"u", Key, 85},
    {"v", Key, 86},
    {"w", Key, 87},
    {"x", Key, 88},
    {"y", Key, 89},
    {"z", Key, 90},
    {"0", Key, 48},
    {"1", Key, 49},
    {"2", Key, 50},
    {"3", Key, 51},
    {"4", Key, 52},
    {"5", Key, 53},
    {"6", Key, 54},
    {"7", Key, 55},
    {"8", Key, 56},
    {"9", Key, 57},
    {"'", Key, 39},
    {",", Key, 44},
    {"-", Key, 45},
    {".", Key, 46},
    {"/", Key, 47},
    {";", Key, 59},
    {"=", Key, 61},
    {"[", Key, 91},
    {"\\", Key, 92},
    {"]", Key, 93},
    {"`", Key, 96},
    {"world_1", Key, 161},
    {"world_2", Key, 162},
    {"space", Key, 32},
    {"escape", Key, 256},
    {"enter", Key, 257},
    {"tab", Key, 258},
    {"backspace", Key, 259},
    {"insert", Key, 260},
    {"delete", Key, 261},
    {"right", Key, 262},
    {"left", Key, 263},
    {"down", Key, 264},
    {"up", Key, 265},
    {"page_up", Key, 266},
    {"page_down", Key, 267},
    {"home", Key, 268},
    {"end", Key, 269},
    {"caps_lock", Key, 280},
    {"scroll_lock", Key, 281},
    {"num_lock", Key, 282},
    {"print_screen", Key, 283},
    {"pause", Key, 284},
    {"f1", Key, 290},
    {"f2", Key, 291},
    {"f3", Key, 292},
    {"f4", Key, 293},
    {"f5", Key, 294},
    {"f6", Key, 295},
    {"f7", Key, 296},
    {"f8", Key, 297},
    {"f9", Key, 298},
    {"f10", Key, 299},
    {"f11", Key, 300},
    {"f12", Key, 301},
    {"f13", Key, 302},
    {"f14", Key, 303},
    {"f15", Key, 304},
    {"f16", Key, 305},
    {"f17", Key, 306},
    {"f18", Key, 307},
    {"f19", Key, 308},
    {"f20", Key, 309},
    {"f21", Key, 310},
    {"f22", Key, 311},
    {"f23", Key, 312},
    {"f24", Key, 313},
    {"f25", Key, 314},
    {"kp_0", Key, 320},
    {"kp_1", Key, 321},
    {"kp_2", Key, 322},
    {"kp_3", Key, 323},
    {"kp_4", Key, 324},
    {"kp_5", Key, 325},
    {"kp_6", Key, 326},
    {"kp_7", Key, 327},
    {"kp_8", Key, 328},
    {"kp_9", Key, 329},
    {"kp_decimal", Key, 330},
    {"kp_divide", Key, 331},
    {"kp_multiply", Key, 332},
    {"kp_subtract", Key, 333},
    {"kp_add", Key, 334},
    {"kp_enter", Key, 335},
    {"kp_equal", Key, 336},
    {"left_shift", Key, 340},
    {"left_control", Key, 341},
    {"left_alt", Key, 342},
    {"left_super", Key, 343},
    {"right_shift", Key, 344},
    {"right_control", Key, 345},
    {"right_alt", Key, 346},
    {"right_super", Key, 347},
    {"menu", Key, 348},
    {"mouse.left", MouseButton, 0},
    {"mouse.right", MouseButton, 1},
    {"mouse.middle", MouseButton, 2},
    {"mouse.4", MouseButton, 3},
    {"mouse.5", MouseButton, 4},
    {"mouse.6", MouseButton, 5},
    {"mouse.7", MouseButton, 6},
    {"mouse.8", MouseButton, 7},
    {"mouse.move", MouseMove, 0},
    {"wheel.up", Wheel, 0},
    {"wheel.down", Wheel, 1},
    {"wheel.left", Wheel, 2},
    {"wheel.right", Wheel, 3},
    {"pad.a", PadButton, 0},
    {"pad.b", PadButton, 1},
    {"pad.x", PadButton, 2},
    {"pad.y", PadButton, 3},
    {"pad.left_bumper", PadButton, 4},
    {"pad.right_bumper", PadButton, 5},
    {"pad.back", PadButton, 6},
    {"pad.start", PadButton, 7},
    {"pad.guide", PadButton, 8},
    {"pad.left_thumb", PadButton, 9},
    {"pad.right_thumb", PadButton, 10},
    {"pad.dpad_up", PadButton, 11},
    {"pad.dpad_right", PadButton, 12},
    {"pad.dpad_down", PadButton, 13},
    {"pad.dpad_left", PadButton, 14},
    {"pad.left_x-", PadAxis, 0, -1},
    {"pad.left_x+", PadAxis, 0, 1},
    {"pad.left_y-", PadAxis, 1, -1},
    {"pad.left_y+", PadAxis, 1, 1},
    {"pad.right_x-", PadAxis, 2, -1},
    {"pad.right_x+", PadAxis, 2, 1},
    {"pad.right_y-", PadAxis, 3, -1},
    {"pad.right_y+", PadAxis, 3, 1},
    {"pad.left_trigger", PadAxis, 4, 1},
    {"pad.right_trigger", PadAxis, 5, 1},
    {"pad.left_stick", PadStick, 0},
    {"pad.right_stick", PadStick, 1},
});

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
        words.reserve(kWords.size());
        for (const Word& word : kWords) words.push_back(word.word);
        return words;
    }();
    return kAll;
}

std::optional<Input> input_of(DeviceKind kind, int code, int direction, std::uint8_t modifiers) {
    const auto* const found = std::ranges::find_if(kWords, [&](const Word& word) {
        return word.kind == kind && word.code == code && word.direction == direction;
    });
    if (found == kWords.end()) return std::nullopt;
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
    const auto* const found = std::ranges::find(kWords, base, &Word::word);
    if (found == kWords.end()) return unknown_word(word, base);
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
