#include "engine/study/report/html_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {

namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

TEST(HtmlText, WhatMarksUpIsEscaped) {
    EXPECT_EQ(escape_html("a < b && \"c\" > 'd'"),
              "a &lt; b &amp;&amp; &quot;c&quot; &gt; &#39;d&#39;");
}

TEST(HtmlText, WellFormedUtf8Stays) {
    EXPECT_EQ(escape_html("µ √2 ≤ 𝛑"), "µ √2 ≤ 𝛑");
}

TEST(HtmlText, WhatXmlForbidsIsReplaced) {
    EXPECT_EQ(escape_html(std::string("a\x01"
                                      "b")),
              std::string("a") + kReplacement + "b");
    EXPECT_EQ(escape_html(std::string("a\0b", 3)), std::string("a") + kReplacement + "b");
    EXPECT_EQ(escape_html("a\xFFz"), std::string("a") + kReplacement + "z");
    // A character cut short, half a surrogate pair, too long a form, and U+FFFE.
    EXPECT_EQ(escape_html("\xE2\x82"), std::string(kReplacement) + kReplacement);
    for (const char* bad : {"\xED\xA0\x80", "\xE0\x80\x80", "\xEF\xBF\xBE"}) {
        EXPECT_EQ(escape_html(bad), std::string(kReplacement) + kReplacement + kReplacement);
    }
}

TEST(HtmlText, NumbersHaveThreeDigits) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.35149), "0.351");
    EXPECT_EQ(number_text(12.449), "12.4");
    EXPECT_EQ(number_text(999.6), "1000");
    EXPECT_EQ(number_text(123456.7), "123457");
    EXPECT_EQ(number_text(-2.5e-7), "-2.5e-07");
    EXPECT_EQ(number_text(3e9), "3.0e+09");
    EXPECT_EQ(number_text(std::nan("")), "not a number");
    EXPECT_EQ(number_text(-HUGE_VAL), "infinite");
}

TEST(HtmlText, ErrorsArePerCentUntilTheyAreTiny) {
    EXPECT_EQ(error_text(0.0123), "1.23 %");
    EXPECT_EQ(error_text(-0.5), "-50 %");
    EXPECT_EQ(error_text(3.1e-7), "3.1e-07");
    EXPECT_EQ(error_text(0), "0");
    EXPECT_EQ(error_text(std::nan("")), "not a number");
}

}  // namespace

}  // namespace plumbline::study
