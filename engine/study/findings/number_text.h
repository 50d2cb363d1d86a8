// Numbers as tables for people show them.
#pragma once

#include <string>

namespace plumbline::study {

/// Three digits: "0.351", "12.4", "1.2e-07", "0"; "not a number" and "infinite" for those.
std::string number_text(double value);

/// A relative error: 0.0123 is "1.23 %", below 1e-5 "3.1e-07", zero "0".
std::string error_text(double error);

}  // namespace plumbline::study
