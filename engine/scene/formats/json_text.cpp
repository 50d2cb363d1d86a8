#include "engine/scene/formats/json_text.h"

#include "engine/core/text/printable.h"

#include <algorithm>

namespace plumbline::scene {

namespace {

/// Levels that get lines of their own in the readable layout.
constexpr int kOpenLevels = 2;

}  // namespace

void JsonText::break_line() {
    if (layout_ != JsonLayout::Readable || depth_ > kOpenLevels) return;
    text_ += '\n';
    text_.append(static_cast<std::size_t>(depth_) * 2, ' ');
}

void JsonText::separate() {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (!first_) {
        text_ += ',';
        if (layout_ == JsonLayout::Readable && depth_ > kOpenLevels) text_ += ' ';
    }
    if (depth_ > 0) break_line();
    first_ = false;
}

JsonText& JsonText::open(char bracket) {
    separate();
    text_ += bracket;
    ++depth_;
    first_ = true;
    return *this;
}

JsonText& JsonText::close(char bracket) {
    const bool was_empty = first_;
    const bool was_open = depth_ <= kOpenLevels;
    --depth_;
    if (was_open && !was_empty) break_line();
    text_ += bracket;
    first_ = false;
    return *this;
}

JsonText& JsonText::key(std::string_view name) {
    text(name);
    text_ += layout_ == JsonLayout::Readable ? ": " : ":";
    after_key_ = true;
    return *this;
}

JsonText& JsonText::text(std::string_view value) {
    separate();
    text_ += '"';
    for (std::size_t i = 0; i < value.size();) {
        const char c = value[i];
        const std::size_t length = utf8_length(value, i);
        if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            text_ += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else if (length == 0) {
            text_ += "\\ufffd";  // file names may be any bytes, JSON may not
        } else {
            text_ += value.substr(i, length);
        }
        i += std::max<std::size_t>(length, 1);
    }
    text_ += '"';
    return *this;
}

JsonText& JsonText::boolean(bool value) {
    return raw(value ? "true" : "false");
}

JsonText& JsonText::raw(std::string_view json) {
    separate();
    text_ += json;
    return *this;
}

}  // namespace plumbline::scene
