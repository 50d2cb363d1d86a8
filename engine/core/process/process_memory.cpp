#include "engine/core/process/process_memory.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace plumbline {

std::size_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t total_pages = 0;
    std::size_t resident_pages = 0;
    statm >> total_pages >> resident_pages;
    const long page_bytes = ::sysconf(_SC_PAGESIZE);
    return resident_pages * static_cast<std::size_t>(page_bytes > 0 ? page_bytes : 0);
}

std::size_t peak_resident_bytes() {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

bool may_still_map(std::size_t bytes) {
    constexpr int kReserved = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
    void* space = mmap(nullptr, bytes, PROT_NONE, kReserved, -1, 0);
    if (space == MAP_FAILED) return false;
    munmap(space, bytes);
    return true;
}

void reset_peak_resident_bytes() {
    malloc_trim(0);
    // "5" sets the peak to what is resident now (proc(5), clear_refs).
    std::ofstream("/proc/self/clear_refs") << 5;
}

void return_large_blocks_early() {
    mallopt(M_MMAP_THRESHOLD, 128 * 1024);
    // What is smaller is used again soon: given back and taken anew it costs page faults.
    mallopt(M_TRIM_THRESHOLD, 64 * 1024 * 1024);
}

}  // namespace plumbline
