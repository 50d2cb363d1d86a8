#include "engine/study/scenarios/scenario_text.h"

#include "tests/engine/study/findings/sample_findings.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline::study {
namespace {

TEST(ScenarioText, LinesOfPointsFloorsVerdictsAndNotes) {
    Subject subject = test::sample_subject("A01");
    subject.points.resize(1);
    subject.euler_floor.resize(1);
    subject.notes = {"a note"};
    Point crashed;
    crashed.status = RunStatus::Crashed;
    crashed.why = "signal 11";
    subject.points.push_back(crashed);
    const std::string text = subject_text(subject);
    EXPECT_TRUE(test::holds(text, "\nA01  a ball falls  [T1 closed form]\n"));
    EXPECT_TRUE(test::holds(text, "  e1: height at 2 s, relative to the way fallen, 19.62 m\n"));
    EXPECT_TRUE(test::holds(text, "4.00e-02")) << "twice the error at half of 60 Hz\n" << text;
    EXPECT_TRUE(test::holds(text, " crashed: signal 11\n")) << text;
    EXPECT_TRUE(test::holds(text, "  Euler floor of e1: 1.67e-02 at 30 Hz\n")) << text;
    EXPECT_TRUE(test::holds(text, "converges (order 1.00, theory 1, 5 halvings)\n")) << text;
    EXPECT_TRUE(test::holds(text, "  Note: a note\n"));
    subject.euler_floor.clear();
    subject.verdicts = {{.knob = "sub-steps"}};
    EXPECT_FALSE(test::holds(subject_text(subject), "Euler"));
    EXPECT_TRUE(test::holds(subject_text(subject), "(order -, 0 halvings)\n"));
}

}  // namespace
}  // namespace plumbline::study
