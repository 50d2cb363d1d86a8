// What is the same on every page: style, and how to read it.
#pragma once

#include <string_view>

namespace plumbline::study {

/// A style sheet for light and dark.
std::string_view page_style();

/// For who has never seen a work-precision diagram.
std::string_view how_to_read();

}  // namespace plumbline::study
