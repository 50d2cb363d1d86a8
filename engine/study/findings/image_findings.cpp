#include "engine/study/findings/image_findings.h"

#include "engine/study/findings/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

/// Errors so close to each other count as the same.
constexpr double kSameError = 0.02;

bool is_beaten(const ImageRow& row, const std::vector<ImageRow>& rows) {
    return std::ranges::any_of(rows, [&](const ImageRow& other) {
        return other.error.rms <= row.error.rms && other.cpu_ms <= row.cpu_ms &&
               (other.error.rms < row.error.rms || other.cpu_ms < row.cpu_ms);
    });
}

std::string error_words(const ImageError& error, const ImageError& high) {
    const double ratio = error.rms / std::max(high.rms, 1e-12);
    if (std::abs(ratio - 1.0) < kSameError) return "as near to the reference";
    return ratio < 1.0 ? fmt::format("{:.0f} % less error", 100.0 * (1.0 - ratio))
                       : fmt::format("{:.0f} % more error", 100.0 * (ratio - 1.0));
}

std::string cost_words(const Difference& more_ms) {
    if (!more_ms.is_significant()) return "no cost that could be told";
    return more_ms.mean < 0 ? fmt::format("saves {:.1f} ms", -more_ms.mean)
                            : fmt::format("costs {:.1f} ms more", more_ms.mean);
}

}  // namespace

void judge(ImageFindings& findings) {
    for (ImageRow& row : findings.rows) {
        row.unbeaten = !is_beaten(row, findings.rows);
        const bool is_base = &row == findings.rows.data();
        row.verdict = is_base ? std::string("what the others are compared to")
                              : fmt::format("{}, {}",
                                            error_words(row.error, findings.rows.front().error),
                                            cost_words(row.more_ms));
    }
}

std::string image_text(const ImageFindings& findings) {
    std::string text = fmt::format(
        "What the image's accuracy costs: {}\n"
        "{} x {} pixels against {} samples a pixel with exact rays to the sun; errors relative to "
        "the "
        "mean luminance, {:.3f} of white.\n"
        "* nothing else measured is both cheaper and nearer to the reference\n\n"
        "{:<38} {:>10} {:>10} {:>10}\n",
        findings.scene,
        findings.width_px,
        findings.height_px,
        findings.samples_per_pixel,
        findings.mean_luminance,
        "",
        "rms error",
        "mean error",
        "CPU ms");
    for (const ImageRow& row : findings.rows) {
        text += fmt::format("{} {:<36} {:>10} {:>10} {:>10.1f}   {}\n",
                            row.unbeaten ? '*' : ' ',
                            row.name,
                            error_text(row.error.rms),
                            error_text(row.error.mean),
                            row.cpu_ms,
                            row.verdict);
    }
    return text;
}

}  // namespace plumbline::study
