#include "engine/scene/toml_prescan.h"

#include "engine/core/limits.h"

#include <fmt/format.h>

namespace plumbline::scene {
namespace {

/// Walks the text once, by bytes, with a fixed amount of memory.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::optional<TextFault> scan() {
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
        const std::string three(3, quote);
        is_long_ = starts_with(three);
        advance(is_long_ ? 3 : 1);
    }

    void quoted() {
        const char c = text_[at_];
        if (c == '\\' && quote_ == '"') return advance(2);
        // A broken one-line string ends here; the parser will say so.
        if (c == '\n' && !is_long_) quote_ = '\0';
        if (c != quote_) return advance(1);
        if (is_long_ && !starts_with(std::string(3, quote_))) return advance(1);
        advance(is_long_ ? 3 : 1);
        // A long string may end in up to two quotes of its own.
        for (int own = 0; is_long_ && own < 2 && at_ < text_.size() && text_[at_] == quote_; ++own)
            advance(1);
        quote_ = '\0';
    }

    void plain() {
        const char c = text_[at_];
        switch (c) {
            case '"':
            case '\'':
                return open_quote(c);
            case '#':
                while (at_ < text_.size() && text_[at_] != '\n' && !fault_) advance(1);
                return;
            case '[':
            case '{':
                if (++depth_ > limits::kTextNesting) {
                    return refuse(fmt::format("nested deeper than {}", limits::kTextNesting));
                }
                dots_ = 0;
                break;
            case ']':
            case '}':
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
    std::size_t dots_{0};
    char quote_{'\0'};
    bool is_long_{false};
    std::optional<TextFault> fault_;
};

}  // namespace

std::optional<TextFault> prescan_toml(std::string_view text) {
    return Scanner(text).scan();
}

}  // namespace plumbline::scene
