#include "engine/core/text/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace plumbline {

// Optimal string alignment distance (Damerau 1964, restricted form), row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> known) {
    constexpr std::size_t kLongestWord = 64;  // keeps hostile input from costing time
    if (word.size() > kLongestWord) return {};
    // A unit left out: "mass" means "mass_kg", however near another word is.
    const std::string with_unit = std::string(word) + '_';
    for (const std::string_view name : known) {
        if (!word.empty() && name.starts_with(with_unit)) return name;
    }
    std::string_view best;
    std::size_t best_distance = word.size() / 3 + 2;
    for (const std::string_view name : known) {
        const std::size_t distance = edit_distance(word, name);
        if (distance < best_distance) {
            best_distance = distance;
            best = name;
        }
    }
    return best;
}

std::string nearest_words(std::string_view word, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_name(word, known);
    return nearest.empty() ? std::string() : fmt::format("; the nearest is \"{}\"", nearest);
}

}  // namespace plumbline
