#include "engine/study/report/diagrams/gnuplot.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace plumbline::study {

namespace {

/// A program that does what `body` says, in shell.
std::string program(const test::TemporaryFolder& folder, const std::string& body) {
    const auto file = folder.write("drawer", "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    return file.string();
}

TEST(Gnuplot, TheScriptGoesInAndTheImageComesOut) {
    const test::TemporaryFolder folder;
    const std::string script(300'000, 'x');  // longer than any pipe
    const auto got = run_gnuplot(program(folder, "cat"), script, 20);
    ASSERT_TRUE(got) << got.error().message;
    EXPECT_EQ(*got, script);
}

TEST(Gnuplot, NobodysStartUpFileIsRead) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(*run_gnuplot(program(folder, "cat >/dev/null; echo \"$@\""), "", 20), "-d -\n");
}

TEST(Gnuplot, EachFailureIsSaid) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(run_gnuplot("no-such-drawer", "", 20).error().message,
              "cannot start no-such-drawer: No such file or directory");
    const std::string fails = program(folder, "exit 3");
    EXPECT_EQ(run_gnuplot(fails, "", 20).error().message, fails + " ended with exit code 3");
    const std::string silent = program(folder, "cat >/dev/null");
    EXPECT_EQ(run_gnuplot(silent, "plot", 20).error().message, silent + " drew nothing");
}

TEST(Gnuplot, OneThatReadsNothingEndsNobody) {
    const test::TemporaryFolder folder;
    const auto got =
        run_gnuplot(program(folder, "exec 0<&-; echo image"), std::string(300'000, 'x'), 20);
    ASSERT_TRUE(got) << got.error().message;
    EXPECT_EQ(*got, "image\n");
}

TEST(Gnuplot, OneThatHangsIsEnded) {
    const test::TemporaryFolder folder;
    const std::string hangs = program(folder, "exec sleep 1000");
    EXPECT_EQ(run_gnuplot(hangs, "", 0.2).error().message, hangs + " did not end within 0.2 s");
    const std::string closes = program(folder, "exec >&-; exec sleep 1000");
    EXPECT_FALSE(run_gnuplot(closes, "", 0.2));
}

TEST(InlineSvg, IdsAreItsOwnAndNamesAreEscaped) {
    const auto svg = inline_svg(
        "<?xml version='1.0'?>\n<svg width=\"7\" viewBox=\"0 0 7 "
        "7\">\n<title>Gnuplot</title><desc>x</desc>"
        "<path id='gp1'/><use href='#gp1'/><g id=\"b\"><title>plot_1</title></g></svg>\n",
        "s1",
        "a < b");
    ASSERT_TRUE(svg) << svg.error().message;
    EXPECT_EQ(*svg,
              "<svg role=\"img\" aria-label=\"a &lt; b\" viewBox=\"0 0 7 7\">\n"
              "<path id='s1-gp1'/><use href='#s1-gp1'/><g id=\"s1-b\"></g></svg>");
}

TEST(InlineSvg, SomethingElseIsRefused) {
    for (const char* text : {"", "gnuplot> plot\n", "<svg", "</svg><svg viewBox=\"\">"}) {
        EXPECT_FALSE(inline_svg(text, "s1", "")) << text;
    }
}

}  // namespace

}  // namespace plumbline::study
