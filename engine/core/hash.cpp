#include "engine/core/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace plumbline {

Hasher::Hasher() : state_(XXH3_createState()) {
    XXH3_64bits_reset(static_cast<XXH3_state_t*>(state_));
}

Hasher::~Hasher() {
    XXH3_freeState(static_cast<XXH3_state_t*>(state_));
}

void Hasher::add(const void* bytes, std::size_t size) {
    XXH3_64bits_update(static_cast<XXH3_state_t*>(state_), bytes, size);
}

std::uint64_t Hasher::digest() const {
    return XXH3_64bits_digest(static_cast<const XXH3_state_t*>(state_));
}

std::string hex_of(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

}  // namespace plumbline
