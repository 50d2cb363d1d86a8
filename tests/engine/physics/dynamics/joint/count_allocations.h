// How often this program asked for memory.
#pragma once

#include <cstddef>

namespace plumbline::physics {

std::size_t allocations();

}  // namespace plumbline::physics
