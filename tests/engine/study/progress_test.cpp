#include "engine/study/progress.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

// The tests' standard error is no terminal: a line every five seconds, none in the first.
TEST(ProgressBar, WhereNobodyLooksIsAsGoodAsSilent) {
    for (const ProgressBar::Shown shown : {ProgressBar::Shown::Yes, ProgressBar::Shown::No}) {
        testing::internal::CaptureStderr();
        {
            ProgressBar bar(shown);
            for (const double share : {0.0, 0.5, 1.0}) bar.show(share, 10);
        }
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }
}

}  // namespace
}  // namespace plumbline::study
