// A look at JSON before a parser sees it: reading, copying and dropping a value go as deep as it nests,
// and a file may not choose our stack.
#pragma once

#include <cstddef>
#include <string_view>

namespace plumbline {

/// How many objects and arrays lie within one another. A text that is not JSON is the parser's to
/// refuse.
std::size_t json_depth(std::string_view text);

}  // namespace plumbline
