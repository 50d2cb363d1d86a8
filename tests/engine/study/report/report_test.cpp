#include "engine/study/report/report.h"

#include "tests/engine/study/report/sample_findings.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace plumbline::study {

namespace {

/// Puts another program in gnuplot's place while it lives.
class InPlaceOfGnuplot {
public:
    explicit InPlaceOfGnuplot(const std::string& program) {
        ::setenv("PLUMBLINE_GNUPLOT", program.c_str(), 1);
    }
    InPlaceOfGnuplot(const InPlaceOfGnuplot&) = delete;
    InPlaceOfGnuplot& operator=(const InPlaceOfGnuplot&) = delete;
    ~InPlaceOfGnuplot() { ::unsetenv("PLUMBLINE_GNUPLOT"); }
};

std::string page_of(const Findings& findings) {
    const test::TemporaryFolder folder;
    const auto written = write_report(findings, folder.path());
    EXPECT_TRUE(written) << written.error().message;
    EXPECT_EQ(folder.count(), 1U);
    return folder.read("report.html");
}

TEST(Report, WithoutGnuplotTheTablesComeAndOneLineSaysSo) {
    const InPlaceOfGnuplot nothing("no-such-drawer");
    const std::string page = page_of(test::sample_findings());
    EXPECT_TRUE(
        test::holds(page, "No diagrams: cannot start no-such-drawer: No such file or directory."));
    EXPECT_FALSE(test::holds(page, "<svg"));
    EXPECT_TRUE(test::holds(page, "All 36 runs"));
    EXPECT_TRUE(test::holds(page, "Cost to reach an error"));
}

TEST(Report, AnImageThatIsNoneIsSaidWhereItIsMissing) {
    const test::TemporaryFolder folder;
    const auto file = folder.write("drawer", "#!/bin/sh\ncat >/dev/null; echo nonsense\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    const InPlaceOfGnuplot nonsense(file.string());
    EXPECT_TRUE(
        test::holds(page_of(test::sample_findings()),
                    "This diagram is missing: gnuplot wrote something else than an image."));
}

TEST(Report, SaysWithWhatItWasMadeAndHowToRepeatIt) {
    const InPlaceOfGnuplot nothing("no-such-drawer");
    Findings findings = test::sample_findings();
    findings.command = "plumbline study --only 'A & B'";
    findings.complete = false;
    findings.clock_spread = 0.4;
    const std::string page = page_of(findings);
    EXPECT_TRUE(test::holds(page, "plumbline study --only &#39;A &amp; B&#39;"));
    EXPECT_TRUE(test::holds(page, "Interrupted"));
    EXPECT_TRUE(test::holds(page, "was noisy"));
    EXPECT_TRUE(test::holds(page, "href=\"findings.json\""));
    EXPECT_TRUE(test::holds(page, "2026-11-21"));
}

TEST(Report, NothingIsFetchedFromElsewhereAndNothingIsRun) {
    const std::string page = page_of(test::sample_findings());
    EXPECT_FALSE(test::holds(page, "<script"));
    EXPECT_FALSE(test::holds(page, "src="));
    EXPECT_FALSE(test::holds(page, "@import"));
    EXPECT_FALSE(test::holds(page, "<link"));
}

TEST(Report, NoSubjectsAndEmptySubjectsArePages) {
    const InPlaceOfGnuplot nothing("no-such-drawer");
    EXPECT_TRUE(test::holds(page_of({}), "No subject was studied."));
    Findings findings;
    findings.subjects.resize(1);
    const std::string page = page_of(findings);
    EXPECT_TRUE(test::holds(page, "No run was made."));
    EXPECT_TRUE(test::holds(page, "(no name)"));
}

TEST(Report, AFolderThatIsNotThereIsRefused) {
    const InPlaceOfGnuplot nothing("no-such-drawer");
    const test::TemporaryFolder folder;
    EXPECT_FALSE(write_report(test::sample_findings(), folder / "missing"));
}

}  // namespace

}  // namespace plumbline::study
