#include "engine/study/findings/findings_json.h"

#include "engine/study/findings/findings_json_impl.h"
#include "tests/engine/study/findings/a_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

// A part whose number was changed was merged without a word.
TEST(FindingsJson, ANumberThatWasChangedIsRefused) {
    std::string text = findings_to_json(a_study());
    const std::size_t at = text.find("1e-300");
    ASSERT_NE(at, std::string::npos);
    text[at] = '2';
    const Result<Findings> read = findings_from_json(text);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.find("something in it was changed"), std::string::npos)
        << read.error().message;
}

TEST(FindingsJson, ReadsBackWhatItWrote) {
    const std::string text = findings_to_json(a_study());
    const Result<Findings> read = findings_from_json(text);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(findings_to_json(*read), text);
    const Subject& subject = read->subjects.at(0);
    EXPECT_EQ(subject.points.at(0).setting, a_study().subjects[0].points[0].setting);
    EXPECT_EQ(subject.points.at(0).errors.at(0), 1e-300);
    EXPECT_EQ(subject.points.at(1).status, RunStatus::Crashed);
    EXPECT_TRUE(std::isnan(subject.points.at(2).errors.at(0)));
    EXPECT_EQ(read->images.at(0).rows.at(0).error.mean, 0.1 / 3);
    EXPECT_TRUE(read->images.at(0).rows.at(0).unbeaten);
    EXPECT_EQ(subject.verdicts.at(0).order, 1.01);
    EXPECT_EQ(subject.verdicts.at(1).order, std::nullopt);
    EXPECT_EQ(subject.euler_floor.at(0).error, 0.1 / 3);
    EXPECT_EQ(subject.points.at(0).cost.frame_ms_max, 0.008);
    EXPECT_EQ(subject.points.at(0).cost.peak_bytes, 10U);
    EXPECT_EQ(subject.threads.at(0).cost.clock_ms_per_s, 3.5);
    EXPECT_TRUE(subject.threads.at(0).same);
    EXPECT_EQ(subject.threads.at(1).status, RunStatus::Refused);
    EXPECT_EQ(subject.uncertainty, 0.1 / 7);
    EXPECT_EQ(read->effects.at(0).rows.at(0).step_ms.mean, 0.1 / 3);
    EXPECT_EQ(read->effects.at(0).rows.at(0).bytes_gpu, 5U);
    EXPECT_FALSE(read->complete);
}

TEST(FindingsJson, NamesWhatItDoesNotKnow) {
    const std::string good = Json(Setting{}).dump();
    const auto with = [&](const char* from, const char* to) {
        std::string text = good;
        return text.replace(text.find(from), std::string(from).size(), to);
    };
    const std::pair<std::string, const char*> bad[] = {
        {"[]", "array"},
        {with("small_step", "smallstep"), "smallstep"},
        {with("float32", "float16"), "float16"},
        {with("step_hz", "hz"), "step_hz"},
        {with("60", "\"60\""), "number"}};
    for (const auto& [text, part] : bad) {
        std::string said;
        try {
            Json::parse(text).get<Setting>();
        } catch (const std::exception& fault) {
            said = fault.what();
        }
        EXPECT_NE(said.find(part), std::string::npos) << text << ": " << said;
    }
    for (const char* text : {"", "[]"}) EXPECT_FALSE(findings_from_json(text).ok()) << text;
}

}  // namespace
}  // namespace plumbline::study
