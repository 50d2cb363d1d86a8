// The outer shell of saved games: a file that says what it is, whether it is whole, and of what.
//
// Layout, numbers lowest byte first: 8 bytes "PLUMSAVE", u32 format, u64 size of the whole file, u64
// XXH3 of all that follows, then the content: an Archive's bytes.
#pragma once

#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline {

inline constexpr std::uint32_t kSavedFormat = 12;
inline constexpr std::size_t kSavedFileBytes = 512ULL * 1024 * 1024;

/// The content within its shell.
std::string shelled(std::string_view content);
/// The content of a file's bytes; it points into them. `file` is for the message, which says what was
/// expected: no saved game, another format, cut short, longer than it says, damaged (exit code 4).
Result<std::string_view> unshelled(std::string_view bytes, const std::filesystem::path& file);

}  // namespace plumbline
