// A fault that is planted, for the driver's own test: it must find it, name the mutant and keep it.
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <cstdlib>

namespace plumbline::fuzz {

std::vector<std::string> seeds() {
    return {std::string(40, 'a')};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (std::find(data, data + size, 0xff) != data + size) std::abort();
    plumbline::fuzz::note_taken();
    return 0;
}
