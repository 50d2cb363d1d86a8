#include "tests/engine/physics/dynamics/joint/count_allocations.h"

#include <cstdlib>
#include <new>

namespace {

std::size_t count = 0;

}  // namespace

// NOLINTNEXTLINE(misc-new-delete-overloads): all others call these
void* operator new(std::size_t size) {
    ++count;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace plumbline::physics {

std::size_t allocations() {
    return count;
}

}  // namespace plumbline::physics
