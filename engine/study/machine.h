// The machine, the build and the date, as reports name them.
#pragma once

#include <string>

namespace plumbline::study {

/// "AMD EPYC 7B13, 2 cores"; "unknown processor" where the system does not tell.
std::string machine_text();
/// "g++ 12.2.0, optimised".
std::string build_text();
/// "2026-11-21", in UTC.
std::string today_text();

}  // namespace plumbline::study
