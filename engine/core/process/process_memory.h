#pragma once

#include <cstddef>

namespace plumbline {

/// The memory that this process has resident now, in bytes; 0 where the system does not tell.
std::size_t resident_bytes();

/// The most memory this process has had resident, in bytes; 0 where the system does not tell.
std::size_t peak_resident_bytes();

/// Whether a limit on address space (ulimit -v) leaves so much. Nothing is taken.
bool may_still_map(std::size_t bytes);

/// Gives freed memory back and lets peak_resident_bytes() begin anew. Where the system does not allow
/// that, the peak stays that of the whole life of the process.
void reset_peak_resident_bytes();

/// Every block over 128 KiB goes back to the system when it is freed. Loading passes hundreds of
/// megabytes of pixels through the heap; by default glibc learns from that to keep such blocks,
/// which costs the garden 40 MiB of resident memory. Once, at the start of what draws; what only simulates is faster without.
void return_large_blocks_early();

}  // namespace plumbline
