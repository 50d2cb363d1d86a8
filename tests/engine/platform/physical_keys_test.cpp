// Without a window system there is nobody to ask what is down; window_test.cpp asks an X server.
#include "engine/platform/physical_keys.h"

#include <gtest/gtest.h>

namespace plumbline::platform {
namespace {

TEST(PhysicalKeys, AreUnknownWhereGlfwDoesNotRun) {
    EXPECT_FALSE(read_physical_keys().has_value());
    EXPECT_FALSE(read_physical_keys().has_value()) << "asked again";
}

}  // namespace
}  // namespace plumbline::platform
