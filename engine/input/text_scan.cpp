#include "engine/input/text_scan.h"

#include "engine/core/limits.h"

#include <fmt/format.h>

namespace plumbline::input {
namespace {

/// Reads on, byte by byte; knows strings and comments just well enough to skip them. A string that
/// is never closed is left to the parser, which says so with its place.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    ScanFault run() {
        if (text_.size() > limits::kConfigFileBytes)
            return {0,
                    0,
                    fmt::format(
                        "{} bytes, at most {} are read", text_.size(), limits::kConfigFileBytes)};
        for (; at_ < text_.size() && fault_.message.empty(); ++at_) step();
        return fault_;
    }

private:
    void step() {
        const char c = text_[at_];
        if (c == '\n') {
            ++line_;
            line_start_ = at_ + 1;
            dots_ = 0;
            return;
        }
        if (at_ - line_start_ >= limits::kLineBytes)
            refuse("a line longer than the limit of bytes,", limits::kLineBytes);
        if (c == '#') {
            skip_to_line_end();
        } else if (c == '"' || c == '\'') {
            skip_string(c);
        } else if (c == '[' || c == '{') {
            if (++depth_ > limits::kTextNesting)
                refuse("brackets nested deeper than", limits::kTextNesting);
        } else if (c == ']' || c == '}') {
            if (depth_ > 0) --depth_;
        } else if (c == '=' || c == ',') {
            dots_ = 0;
        } else if (c == '.') {
            if (++dots_ >= limits::kDottedKeyParts)
                refuse("a dotted key with more parts than", limits::kDottedKeyParts);
        }
    }

    void skip_to_line_end() {
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
    }

    void skip_string(char quote) {
        const std::string_view three = text_.substr(at_, 3);
        const bool is_long = three.size() == 3 && three[1] == quote && three[2] == quote;
        if (is_long) at_ += 2;
        for (++at_; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\n') {
                if (!is_long) {
                    --at_;  // the main loop counts the line
                    return;
                }
                ++line_;
                line_start_ = at_ + 1;
            } else if (c == '\\' && quote == '"' && at_ + 1 < text_.size() &&
                       text_[at_ + 1] != '\n') {
                ++at_;
            } else if (c == quote && (!is_long || text_.substr(at_, 3) == three)) {
                if (is_long) at_ += 2;
                return;
            }
        }
    }

    /// `what` names the limit; the number stands behind it.
    void refuse(std::string_view what, std::size_t limit) {
        fault_.line = line_;
        fault_.column = static_cast<int>(at_ - line_start_) + 1;
        fault_.message = fmt::format("{} {}", what, limit);
    }

    std::string_view text_;
    std::size_t at_{0};
    std::size_t line_start_{0};
    std::size_t depth_{0};
    std::size_t dots_{0};
    int line_{1};
    ScanFault fault_;
};

}  // namespace

ScanFault scan_text(std::string_view text) {
    return Scanner(text).run();
}

}  // namespace plumbline::input
