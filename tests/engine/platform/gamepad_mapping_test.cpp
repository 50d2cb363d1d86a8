#include "engine/platform/gamepad_mapping.h"

#include <gtest/gtest.h>

namespace plumbline::platform {
namespace {

const std::string kGuid = "030000005e0400008e02000010010000";
const std::string kGood =
    kGuid +
    ",Example Pad,a:b0,b:b1,dpup:h0.1,leftx:a0,lefty:a1~,+rightx:+a2,lefttrigger:a4,"
    "platform:Linux,";

TEST(GamepadMapping, TakesALineOfTheDatabase) {
    EXPECT_TRUE(check_gamepad_mapping(kGood).ok());
}

TEST(GamepadMapping, SaysWhatIsWrongWithOthers) {  // C8
    const auto fault = [](const std::string& line) {
        const Result<Done> checked = check_gamepad_mapping(line);
        return checked.ok() ? std::string{} : checked.error().message;
    };
    EXPECT_EQ(fault("garbage"), "does not begin with 32 hexadecimal digits and a comma");
    EXPECT_EQ(fault(kGuid + ",Pad,aa:b0"), "unknown element \"aa\"");
    EXPECT_EQ(fault(kGuid + ",Pad,a:q0"), "\"q0\" is no button, axis or hat (b0, a0, h0.1)");
    EXPECT_EQ(fault(kGuid + ",Pad,a:b99999"),
              "\"b99999\" is no button, axis or hat (b0, a0, h0.1)");
    EXPECT_EQ(fault(kGuid + ",Pad,dpup:h0.3"), "\"h0.3\" is no button, axis or hat (b0, a0, h0.1)");
    EXPECT_EQ(fault(kGuid + ",Pad,a"), "\"a\" is not element:source");
    EXPECT_EQ(fault(kGuid + ",Pad,"), "maps nothing");
    EXPECT_EQ(fault(kGuid + ",,a:b0"), "the name has 0 bytes, 1 to 127 expected");
    EXPECT_EQ(fault(kGuid + ",P\x01,a:b0"), "holds a control character");
    EXPECT_NE(fault(kGuid + "," + std::string(2'000, 'x') + ",a:b0"), "");
}

TEST(GamepadMapping, ABadLineCostsOnlyItself) {
    const GamepadMappings mappings =
        read_gamepad_mappings("# comment\r\n\n" + kGood + "\r\nnonsense\n" + kGuid +
                              ",Mac Pad,a:b0,platform:Mac OS X,\n" + kGood);
    EXPECT_EQ(mappings.accepted.size(), 2U);
    ASSERT_EQ(mappings.rejected.size(), 1U);
    EXPECT_TRUE(mappings.rejected[0].starts_with("4: "));
}

}  // namespace
}  // namespace plumbline::platform
