// A variable of the environment that has a value, or none, as long as a test runs.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace plumbline::test {

/// What the variable was before comes back with its end.
class ScopedVariable {
public:
    /// Nothing: unset.
    ScopedVariable(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~ScopedVariable() { set(before_); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

private:
    void set(const std::optional<std::string>& value) {
        if (value)
            ::setenv(name_, value->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> before_;
};

}  // namespace plumbline::test
