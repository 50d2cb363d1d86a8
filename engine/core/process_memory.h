#pragma once

#include <cstddef>

namespace plumbline {

/// The most memory this process has had resident, in bytes; 0 where the system does not tell.
std::size_t peak_resident_bytes();

}  // namespace plumbline
