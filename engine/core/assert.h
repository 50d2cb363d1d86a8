// Checks of our own mistakes. On in Debug and RelWithDebInfo alike; bad input from outside is
// never an assert: see result.h.
#pragma once

#include <string_view>

namespace plumbline {

/// Prints the failed expectation with its place and aborts.
[[noreturn]] void assertion_failed(std::string_view condition,
                                   std::string_view expected,
                                   std::string_view file,
                                   int line);

}  // namespace plumbline

// A macro, because clang 14 has no std::source_location and the condition's text is wanted.
#define PL_ASSERT(condition, expected)  \
    ((condition) ? static_cast<void>(0) \
                 : ::plumbline::assertion_failed(#condition, expected, __FILE__, __LINE__))
