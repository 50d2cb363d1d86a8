#include "engine/study/findings/effect_findings.h"

#include <fmt/format.h>

namespace plumbline::study {
namespace {

std::string difference_text(const Difference& difference) {
    if (difference.pairs == 0) return "-";
    if (!difference.is_significant())
        return fmt::format("below the noise (+- {:.4f})", difference.standard_error);
    return fmt::format("{:+.4f} +- {:.4f}", difference.mean, difference.standard_error);
}

std::string fidelities_text(const EffectFindings& findings) {
    std::string text;
    for (const EffectCost& cost : findings.rows) {
        for (const FidelityCost& at : cost.fidelities)
            text += fmt::format("{:<22}{:<10}{:>11.4f}{:>14.3g}{:>14.3g}\n",
                                cost.name,
                                at.fidelity,
                                at.step_ms,
                                at.largest_m,
                                at.mean_m);
    }
    if (text.empty()) return text;
    return fmt::format(
        "\nAt each fidelity: ms of a step in all, and how far bodies end from where "
        "they do at precise\n{:<22}{:<10}{:>11}{:>14}{:>14}\n{}",
        "effect",
        "fidelity",
        "ms a step",
        "largest, m",
        "mean, m",
        text);
}

}  // namespace

std::string effects_text(const EffectFindings& findings) {
    std::string text = fmt::format(
        "{}: what switching an effect off saves. {:g} s of the scene with and without it, {} times "
        "in turns; mean\nand standard error; below the noise: within two of them. A scene without "
        "an effect may move otherwise.\n{:<22}{:<7}{:>28}{:>28}{:>9}{:>11}{:>12}  called for by\n",
        findings.scene,
        findings.seconds,
        findings.pairs,
        "effect",
        "of the",
        "ms a step",
        "ms a frame",
        "calls",
        "CPU bytes",
        "GPU bytes");
    for (const EffectCost& cost : findings.rows)
        text += fmt::format("{:<22}{:<7}{:>28}{:>28}{:>9}{:>11}{:>12}  {}\n",
                            cost.name,
                            cost.domain,
                            difference_text(cost.step_ms),
                            difference_text(cost.frame_ms),
                            cost.calls,
                            cost.bytes_cpu,
                            cost.bytes_gpu,
                            cost.caller);
    text += fidelities_text(findings);
    if (findings.rows.empty()) text += "No effect was measured.\n";
    if (findings.width_px > 0)
        text +=
            fmt::format("Images are {} x {}; what a GPU does beside the CPU is not in their ms.\n",
                        findings.width_px,
                        findings.height_px);
    return text;
}

}  // namespace plumbline::study
