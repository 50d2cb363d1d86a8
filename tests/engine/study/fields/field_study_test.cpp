// Every effect that bodies feel is within what its references allow, at every fidelity.
#include "engine/study/fields/field_study.h"

#include "engine/effects/effect_table.h"
#include "engine/study/fields/field_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace plumbline::study {
namespace {

using scene::Fidelity;

std::string id_of(const FieldReference& reference) {
    std::string id = std::string(reference.effect) + "_" + std::string(reference.name);
    std::ranges::replace_if(
        id, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return id;
}

class EachReference : public testing::TestWithParam<FieldReference> {};

TEST_P(EachReference, IsKeptAtEveryFidelity) {
    const FieldReference& reference = GetParam();
    for (const Fidelity fidelity : {Fidelity::Draft, Fidelity::Balanced, Fidelity::Precise}) {
        const FieldOutcome outcome = reference.run(fidelity);
        EXPECT_LE(outcome.error, reference.tolerance[static_cast<std::size_t>(fidelity)])
            << reference.formula << ", fidelity " << static_cast<int>(fidelity);
        EXPECT_GT(outcome.cpu_ms_per_s, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         EachReference,
                         testing::ValuesIn(field_references()),
                         [](const auto& tested) { return id_of(tested.param); });

/// Twice and four times the sub-steps: the error falls with their square.
TEST(FieldOrder, EnergyOfAFreePairOfMagnetsIsOfSecondOrder) {
    const auto references = magnet_references();
    const auto energy =
        std::ranges::find(references, "energy of a free pair", &FieldReference::name);
    ASSERT_NE(energy, references.end());
    const double draft = energy->run(Fidelity::Draft).error;
    const double balanced = energy->run(Fidelity::Balanced).error;
    EXPECT_GE(std::log2(draft / balanced), 1.8) << draft << " " << balanced;
}

TEST(FieldReferences, AreOfRowsOfTheTable) {
    for (const FieldReference& reference : field_references()) {
        EXPECT_NE(
            std::ranges::find(effects::effect_table(), reference.effect, &effects::EffectRow::name),
            effects::effect_table().end())
            << reference.effect;
        EXPECT_GE(reference.tolerance[0], reference.tolerance[1]) << reference.name;
        EXPECT_GE(reference.tolerance[1], reference.tolerance[2]) << reference.name;
    }
}

TEST(ReferencesText, HasALineForEachAndMarksThoseAbove) {
    const std::string text = references_text({{.effect = "drag",
                                               .reference = "a fall",
                                               .formula = "tanh",
                                               .fidelity = "draft",
                                               .error = 0.02,
                                               .cpu_ms_per_s = 0.5,
                                               .tolerance = 0.05},
                                              {.effect = "drag",
                                               .reference = "a fall",
                                               .formula = "tanh",
                                               .fidelity = "precise",
                                               .error = 0.02,
                                               .cpu_ms_per_s = 0.5,
                                               .tolerance = 0.01}});
    EXPECT_EQ(std::ranges::count(text, '\n'), 3);
    const std::size_t above = text.find("ABOVE");
    ASSERT_NE(above, std::string::npos);
    EXPECT_GT(above, text.find("precise"));
    EXPECT_EQ(text.find("ABOVE", above + 1), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
