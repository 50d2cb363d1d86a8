// "Did you mean": the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumbline {

/// The known name with the smallest edit distance, the first of several; empty where none is close
/// enough to be what was meant: one edit and one more for each three letters of `word`.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known);

/// `; the nearest is "NAME"`, or nothing, to follow a message about a word that is not known.
std::string nearest_words(std::string_view word, std::span<const std::string_view> known);

/// Insertions, deletions, substitutions and swaps of neighbours that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace plumbline
