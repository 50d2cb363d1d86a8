#include "engine/core/text/toml_prescan.h"

#include "engine/core/limits.h"
#include "engine/core/text/printable.h"

#include <fmt/format.h>

#include <array>

namespace plumbline {
namespace {

constexpr std::string_view kNotAscii =
    "a letter that is not ASCII; only texts and comments may hold them";

/// Walks the text once, by bytes, with a fixed amount of memory.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::optional<TextFault> scan() {
        if (is_utf16(text_)) refuse(std::string(kUtf16Fault));
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (starts_with(kByteOrderMark)) advance(kByteOrderMark.size());
        while (at_ < text_.size() && !fault_) {
            if (quote_ == '\0')
                plain();
            else
                quoted();
        }
        return fault_;
    }

private:
    bool starts_with(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

    void refuse(std::string message) {
        fault_ = TextFault{std::move(message), line_, static_cast<int>(at_ - line_start_) + 1};
    }

    void advance(std::size_t bytes) {
        for (; bytes > 0 && at_ < text_.size(); --bytes) {
            if (text_[at_] == '\n') {
                ++line_;
                line_start_ = at_ + 1;
            } else if (at_ - line_start_ >= limits::kLineBytes) {
                return refuse(
                    fmt::format("the line is longer than {} bytes; break it", limits::kLineBytes));
            }
            ++at_;
        }
    }

    void open_quote(char quote) {
        quote_ = quote;
        // Glued to what stands before it, it may be no text to the parser but part of a number.
        const char before = at_ > 0 ? text_[at_ - 1] : '\n';
        constexpr std::string_view kFree = " \t\n=,[{";
        is_glued_ = kFree.find(before) == kFree.npos;
        const std::string three(3, quote);
        is_long_ = starts_with(three);
        advance(is_long_ ? 3 : 1);
    }

    void quoted() {
        const char c = text_[at_];
        if (is_glued_ && is_beyond_ascii(at_)) return refuse(std::string(kNotAscii));
        if (c == '\\' && quote_ == '"') return escaped();
        // A broken one-line string ends here; the parser will say so.
        if (c == '\n' && !is_long_) {
            quote_ = '\0';
            line_begun_ = false;
            return advance(1);
        }
        if (c != quote_) return advance(1);
        if (is_long_ && !starts_with(std::string(3, quote_))) return advance(1);
        advance(is_long_ ? 3 : 1);
        // A long string may end in up to two quotes of its own.
        for (int own = 0; is_long_ && own < 2 && at_ < text_.size() && text_[at_] == quote_; ++own)
            advance(1);
        quote_ = '\0';
    }

    bool is_beyond_ascii(std::size_t at) const {
        return at < text_.size() && static_cast<unsigned char>(text_[at]) >= 0x80U;
    }

    void escaped() {
        std::size_t next = at_ + 1;
        // A backslash at the end of a line swallows the blanks and line ends that follow.
        constexpr std::string_view kBlanks = " \t\r\n";
        while (is_long_ && next < text_.size() && kBlanks.find(text_[next]) != kBlanks.npos) ++next;
        // toml++ 3.3 has undefined behaviour when it asks whether such a letter is a blank.
        if (is_beyond_ascii(next)) return refuse("a backslash before a letter that is not ASCII");
        advance(2);
    }

    /// `[` or `[[` at the start of a line must be followed by a name: toml++ 3.3 takes that for
    /// granted and has undefined behaviour otherwise.
    void header() {
        std::size_t next = at_ + 1;
        if (next < text_.size() && text_[next] == '[') ++next;
        while (next < text_.size() && (text_[next] == ' ' || text_[next] == '\t')) ++next;
        if (next >= text_.size()) return;
        const char c = text_[next];
        const bool named = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '"' || c == '\'';
        // The parser has good words for [] and for [ [.
        const bool is_double = text_[at_ + 1] == '[';
        if (named || c == ']' || (c == '[' && !is_double)) return;
        at_ = next;
        refuse("expected a table's name after [");
    }

    void plain() {
        const char c = text_[at_];
        if (is_beyond_ascii(at_)) {
            // TOML has no place for these, and toml++ 3.3 undefined behaviour for some of them.
            return refuse(std::string(kNotAscii));
        }
        if (c == '[' && depth_ == 0 && !line_begun_) {
            header();
            if (fault_) return;
        }
        if (c == '\n')
            line_begun_ = false;
        else if (c > ' ')
            line_begun_ = true;
        switch (c) {
            case '"':
            case '\'':
                return open_quote(c);
            case '#':
                while (at_ < text_.size() && text_[at_] != '\n' && !fault_) advance(1);
                return;
            case '[':
            case '{':
                if (depth_ == limits::kTextNesting) {
                    return refuse(fmt::format("nested deeper than {}", limits::kTextNesting));
                }
                open_[depth_++] = c;
                dots_ = 0;
                break;
            case ']':
            case '}':
                // Another trap of toml++ 3.3: [} .
                if (depth_ > 0 && open_[depth_ - 1] != (c == ']' ? '[' : '{'))
                    return refuse(fmt::format("{} does not close {}", c, open_[depth_ - 1]));
                if (depth_ > 0) --depth_;
                dots_ = 0;
                break;
            case '=':
            case ',':
            case '\n':
                dots_ = 0;
                break;
            case '.':
                if (++dots_ >= limits::kDottedKeyParts) {
                    return refuse(
                        fmt::format("a dotted key of more than {} parts", limits::kDottedKeyParts));
                }
                break;
            default:
                break;
        }
        advance(1);
    }

    std::string_view text_;
    std::size_t at_{0};
    std::size_t line_start_{0};
    int line_{1};
    std::size_t depth_{0};
    std::array<char, limits::kTextNesting> open_{};
    std::size_t dots_{0};
    char quote_{'\0'};
    bool is_long_{false};
    bool is_glued_{false};
    bool line_begun_{false};  ///< something other than blanks stands on the line already
    std::optional<TextFault> fault_;
};

}  // namespace

std::optional<TextFault> prescan_toml(std::string_view text) {
    return Scanner(text).scan();
}

}  // namespace plumbline
