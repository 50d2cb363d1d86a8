// Findings as a table for spreadsheets.
#include "engine/study/findings/findings_json.h"
#include "tests/engine/study/findings/a_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace plumbline::study {
namespace {

TEST(FindingsCsv, HasALineForEveryPointAndMetric) {
    const std::string csv = findings_to_csv(a_study());
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 * 2);
    EXPECT_NE(
        csv.find(
            "\nA20 e=0.5,\"apex, first\",1 m,T2 two integrators,small_step,240,4,16,1,"
            "float64,done,,1e-300,0.1,0.2,0.3,5,0.004,0.005,1234,0.006,0.007,0.008,9,10,0.09,\n"),
        std::string::npos)
        << csv;
    EXPECT_NE(csv.find(",crashed,signal 11,,"), std::string::npos) << csv;
}

// Two points of a scene may differ in nothing but the fidelity of its effects.
TEST(FindingsCsv, SaysWhichEffectsRunAtAnotherFidelity) {
    Findings findings = a_study();
    findings.subjects[0].points[0].setting.fidelity = {{"cloth", scene::Fidelity::Draft},
                                                       {"buoyancy", scene::Fidelity::Precise}};
    const std::string csv = findings_to_csv(findings);
    EXPECT_NE(csv.find(",0.09,\"cloth draft, buoyancy precise\"\n"), std::string::npos) << csv;
}

// RFC 4180: fields with commas, quotes or line ends stand in quotes, quotes twice.
TEST(FindingsCsv, QuotesWhatWouldEndAField) {
    Findings findings = a_study();
    Subject& subject = findings.subjects[0];
    subject.id = "a\nb";
    subject.metrics = {{"say \"so\"", "plain"}};
    subject.points.resize(1);
    subject.points[0].errors.clear();
    const std::string csv = findings_to_csv(findings);
    EXPECT_NE(csv.find("\n\"a\nb\",\"say \"\"so\"\"\",plain,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",float64,done,,,0.1,"), std::string::npos) << "no error, no number";
    findings.subjects.clear();
    EXPECT_EQ(std::ranges::count(findings_to_csv(findings), '\n'), 1) << "the heading";
}

}  // namespace
}  // namespace plumbline::study
