// Belts, magnets and charges are within what their references allow; the order of fields, and the study's table.
#include "engine/study/fields/field_study.h"

#include "engine/effects/effect_table.h"
#include "tests/engine/study/fields/each_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace plumbline::study {
namespace {

using scene::Fidelity;

class BeltReference : public EachReference {};

TEST_P(BeltReference, IsKeptAtEveryFidelity) {
    expect_kept(belt_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         BeltReference,
                         testing::Range(std::size_t{0}, belt_references().size()),
                         [](const auto& tested) { return id_of(belt_references()[tested.param]); });

class MagnetReference : public EachReference {};

TEST_P(MagnetReference, IsKeptAtEveryFidelity) {
    expect_kept(magnet_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         MagnetReference,
                         testing::Range(std::size_t{0}, magnet_references().size()),
                         [](const auto& tested) {
                             return id_of(magnet_references()[tested.param]);
                         });

class BlastReference : public EachReference {};

TEST_P(BlastReference, IsKeptAtEveryFidelity) {
    expect_kept(blast_references()[GetParam()]);
}

INSTANTIATE_TEST_SUITE_P(Fields,
                         BlastReference,
                         testing::Range(std::size_t{0}, blast_references().size()),
                         [](const auto& tested) {
                             return id_of(blast_references()[tested.param]);
                         });

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
