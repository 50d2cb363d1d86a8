#include "engine/core/process/process_memory.h"

#include <malloc.h>
#include <sys/resource.h>

namespace plumbline {

std::size_t peak_resident_bytes() {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

void return_large_blocks_early() {
    mallopt(M_MMAP_THRESHOLD, 128 * 1024);
    // What is smaller is used again soon: given back and taken anew it costs page faults.
    mallopt(M_TRIM_THRESHOLD, 64 * 1024 * 1024);
}

}  // namespace plumbline
