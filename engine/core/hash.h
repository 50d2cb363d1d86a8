// 64-bit hashes of states and files (XXH3): the same bytes give the same hash on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace plumbline {

/// Feeds bytes, then asks for the digest. Order matters.
class Hasher {
public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;

    void add(const void* bytes, std::size_t size);
    std::uint64_t digest() const;

private:
    void* state_;  // XXH3_state_t, owned
};

/// 16 lower-case hexadecimal digits.
std::string hex_of(std::uint64_t hash);

}  // namespace plumbline
