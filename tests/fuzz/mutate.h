// Mutants of files: damaged in one to eight places, the same for the same number on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plumbline::fuzz {

/// Number `number` of the endless row of mutants of these seeds. At least one seed.
std::string mutant(std::span<const std::string> seeds, std::uint64_t number);

}  // namespace plumbline::fuzz
