// Failures that come from outside the program: missing files, bad input, refused devices.
// Nothing in the engine throws; parsers that may are caught where they are called.
#pragma once

#include "engine/core/assert.h"
#include "engine/core/process/exit_code.h"

#include <string>
#include <utility>
#include <variant>

namespace plumbline {

/// What went wrong, in one sentence a person can act on.
struct Error {
    std::string message;
    ExitCode exit_code{ExitCode::RunFailed};  ///< what the program returns if nobody handles it
};

/// A value, or the reason why there is none. Check before use: value() asserts.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }

    T& value() {
        PL_ASSERT(ok(), "a result that holds a value");
        return *std::get_if<T>(&content_);
    }
    const T& value() const {
        PL_ASSERT(ok(), "a result that holds a value");
        return *std::get_if<T>(&content_);
    }
    const Error& error() const {
        PL_ASSERT(!ok(), "a result that holds an error");
        return *std::get_if<Error>(&content_);
    }

    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, Error> content_;
};

/// For what can fail and returns nothing: `Result<Done>`, and `return Done{};` on success.
struct Done {};

}  // namespace plumbline
