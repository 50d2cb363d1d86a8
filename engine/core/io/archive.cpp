#include "engine/core/io/archive.h"

namespace plumbline {
namespace {

constexpr std::string_view kEndsEarly = "its state ends early";

}  // namespace

std::string_view Archive::bytes(std::size_t size) {
    if (size > source_.size()) {
        fail(kEndsEarly);
        source_ = {};
        return {};
    }
    const std::string_view taken = source_.substr(0, size);
    source_.remove_prefix(size);
    return taken;
}

std::size_t Archive::count(std::size_t size) {
    std::uint64_t number = size;
    (*this)(number);
    if (reads_ && number > source_.size()) {
        fail(kEndsEarly);
        return 0;
    }
    return number;
}

void Archive::text(std::string& value) {
    const std::size_t size = count(value.size());
    if (reads_)
        value = bytes(size);
    else
        written_ += value;
}

}  // namespace plumbline
