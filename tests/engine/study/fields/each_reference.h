// Holds references to what they allow, at every fidelity.
#pragma once

#include "engine/study/fields/field_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace plumbline::study {

inline std::string id_of(const FieldReference& reference) {
    std::string id = std::string(reference.effect) + "_" + std::string(reference.name);
    std::ranges::replace_if(
        id, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    return id;
}

class EachReference : public testing::TestWithParam<std::size_t> {
protected:
    /// The error and the cost at each fidelity.
    static void expect_kept(const FieldReference& reference) {
        for (const auto fidelity :
             {scene::Fidelity::Draft, scene::Fidelity::Balanced, scene::Fidelity::Precise}) {
            const FieldOutcome outcome = reference.run(fidelity);
            EXPECT_LE(outcome.error, reference.tolerance[static_cast<std::size_t>(fidelity)])
                << reference.name << ": " << reference.formula << ", fidelity "
                << static_cast<int>(fidelity);
            EXPECT_GT(outcome.cpu_ms_per_s, 0);
        }
    }
};

}  // namespace plumbline::study
