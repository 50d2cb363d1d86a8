// Text and numbers as a page shows them.
#pragma once

#include <string>
#include <string_view>

namespace plumbline::study {

/// For the text of an element and for attributes in quotes, in HTML and XML alike: what has a meaning
/// there is escaped; control characters and broken UTF-8 become U+FFFD.
std::string escape_html(std::string_view text);

/// Three digits: "0.351", "12.4", "1.2e-07", "0"; "not a number" and "infinite" for those.
std::string number_text(double value);

/// A relative error as people say it: 0.0123 is "1.23 %", below 1e-5 "3.1e-07", zero "0".
std::string error_text(double error);

}  // namespace plumbline::study
