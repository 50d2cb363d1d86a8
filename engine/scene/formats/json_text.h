// JSON as text, field by field in the order of the calls. Numbers are the shortest that read back
// to the same bits at their own precision; what is not finite becomes null.
#pragma once

#include "engine/core/math.h"

#include <fmt/format.h>

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::scene {

enum class JsonLayout : std::uint8_t {
    OneLine,   ///< for traces: one object a line
    Readable,  ///< the outer two levels on lines of their own
};

/// Writes one value. Every begin needs its end; within an object every value needs its key first.
class JsonText {
public:
    explicit JsonText(JsonLayout layout) : layout_(layout) {}

    JsonText& begin_object() { return open('{'); }
    JsonText& end_object() { return close('}'); }
    JsonText& begin_array() { return open('['); }
    JsonText& end_array() { return close(']'); }
    JsonText& key(std::string_view name);

    JsonText& text(std::string_view value);
    JsonText& boolean(bool value);
    template <class T>
    requires std::integral<T> || std::floating_point<T> JsonText& number(T value) {
        if constexpr (std::floating_point<T>) {
            if (!std::isfinite(value)) return raw("null");
        }
        return raw(fmt::format("{}", value));
    }
    template <class T>
    JsonText& vector(const glm::vec<3, T>& v) {
        begin_array();
        number(v.x).number(v.y).number(v.z);
        return end_array();
    }
    /// Text that already is JSON.
    JsonText& raw(std::string_view json);

    const std::string& str() const { return text_; }

private:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    void separate();
    void break_line();

    JsonLayout layout_;
    std::string text_;
    int depth_{0};
    bool first_{true};
    bool after_key_{false};
};

}  // namespace plumbline::scene
