#include "engine/study/fields/field_study.h"

#include "engine/core/process/interrupt.h"
#include "engine/study/fields/field_reference.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

constexpr std::array<std::string_view, 3> kFidelities{"draft", "balanced", "precise"};

}  // namespace

std::vector<FieldReference> field_references() {
    std::vector<FieldReference> all;
    for (const auto& family : {water_references(),
                               cloth_references(),
                               belt_references(),
                               air_references(),
                               blast_references(),
                               fracture_references(),
                               rope_references(),
                               soft_references(),
                               vehicle_references(),
                               magnet_references()})
        all.insert(all.end(), family.begin(), family.end());
    return all;
}

std::vector<EffectError> measure_references(const std::function<void(double share)>& shown) {
    const std::vector<FieldReference> references = field_references();
    std::vector<EffectError> errors;
    for (const FieldReference& reference : references) {
        for (std::size_t fidelity = 0; fidelity < kFidelities.size(); ++fidelity) {
            if (interrupted()) return errors;
            const FieldOutcome outcome = reference.run(static_cast<scene::Fidelity>(fidelity));
            errors.push_back({.effect = std::string(reference.effect),
                              .reference = std::string(reference.name),
                              .formula = std::string(reference.formula),
                              .fidelity = std::string(kFidelities[fidelity]),
                              .error = outcome.error,
                              .cpu_ms_per_s = outcome.cpu_ms_per_s,
                              .tolerance = reference.tolerance[fidelity]});
            if (shown)
                shown(static_cast<double>(errors.size()) /
                      static_cast<double>(references.size() * kFidelities.size()));
        }
    }
    return errors;
}

std::string references_text(const std::vector<EffectError>& errors) {
    std::string text = fmt::format("{:<11}{:<33}{:<10}{:>10}{:>10}{:>12}  held to\n",
                                   "effect",
                                   "reference",
                                   "fidelity",
                                   "error",
                                   "allowed",
                                   "ms for 1 s");
    for (const EffectError& each : errors)
        text += fmt::format("{:<11}{:<33}{:<10}{:>10.2g}{:>10.2g}{:>12.3f}  {}{}\n",
                            each.effect,
                            each.reference,
                            each.fidelity,
                            each.error,
                            each.tolerance,
                            each.cpu_ms_per_s,
                            each.formula,
                            each.is_within() ? "" : "  ABOVE");
    return text;
}

}  // namespace plumbline::study
