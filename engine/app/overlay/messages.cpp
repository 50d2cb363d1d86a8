#include "engine/app/overlay/messages.h"

#include <algorithm>
#include <utility>

namespace plumbline::app {
namespace {

constexpr double kShown_s = 4.0;
constexpr double kReading_s = 0.04;  // for each letter
constexpr double kFade_s = 1.0;
constexpr std::size_t kMost = 6;

/// What a line says before its first digit.
std::string_view stem_of(std::string_view text) {
    return text.substr(0, text.find_first_of("0123456789"));
}

}  // namespace

void Messages::say(std::string line) {
    const auto shown = std::ranges::find(messages_, line, &Message::text);
    if (shown != messages_.end()) {
        shown->until_s = 0;
        return;
    }
    messages_.push_back({.text = std::move(line)});
    if (messages_.size() > kMost) messages_.pop_front();
}

void Messages::say_latest(std::string line) {
    std::erase_if(messages_, [stem = stem_of(line)](const Message& shown) {
        return stem_of(shown.text) == stem;
    });
    say(std::move(line));
}

std::vector<ui::HudLine> Messages::lines(double now_s, bool reduce_motion) {
    std::vector<ui::HudLine> lines;
    for (Message& message : messages_) {
        if (message.until_s == 0)
            message.until_s =
                now_s + kShown_s + kReading_s * static_cast<double>(message.text.size());
    }
    std::erase_if(messages_, [&](const Message& message) { return message.until_s < now_s; });
    for (const Message& message : messages_) {
        const auto fade = static_cast<float>(std::clamp(message.until_s - now_s, 0.05, kFade_s));
        lines.push_back({.text = message.text, .alpha = reduce_motion ? 1.0F : fade});
    }
    return lines;
}

}  // namespace plumbline::app
