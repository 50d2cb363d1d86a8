// A fuzz target is one source NAME_fuzz.cpp that defines the two functions below: it feeds a reader of
// files from strangers. The same source is driven by mutants_main.cpp (plain g++, part of ctest) and
// by libFuzzer (preset "fuzz").
//
// A format with a checksum is fuzzed behind it: the target computes the checksum of what it is given,
// as anybody can who writes such a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::fuzz {

/// Good files, small ones, that mutants are made from. The same ones on every call.
std::vector<std::string> seeds();

/// For a target to call when a file was good: mutants that are all refused at once try nothing.
void note_taken();

}  // namespace plumbline::fuzz

/// Reads the bytes, and uses what came of them as the program does. Returns 0; bad input is no
/// failure, a crash, a sanitizer's report or a hang is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
