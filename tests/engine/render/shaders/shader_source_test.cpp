#include "engine/render/shaders/shader_source.h"

#include "engine/core/io/files.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace plumbline::render {
namespace {

class ShaderSourceTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("plumbline_shader_" +
                   std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        ASSERT_TRUE(write_file_atomically(folder_ / name, text).ok());
    }

    std::filesystem::path folder_;
};

TEST_F(ShaderSourceTest, ExpandsEachIncludeOnceAndSaysWhereLinesComeFrom) {
    write("a.glsl", "A\n");
    write("b.glsl", "#include \"a.glsl\"\nB\n");
    write("main.frag", "#include \"a.glsl\"\n#include \"b.glsl\"\nM\n");
    const std::string defines = defines_of(
        std::array{Feature{0, "PL_ONE"}, Feature{1, "PL_TWO"}, Feature{2, "PL_FOUR"}}, 6);
    const auto source = load_shader(folder_, "main.frag", defines);
    ASSERT_TRUE(source.ok()) << source.error().message;
    EXPECT_EQ(source->text,
              "#version 330 core\n#define PL_TWO 1\n#define PL_FOUR 1\n"
              "#line 1 0\n#line 1 1\nA\n#line 2 0\n#line 1 2\n#line 2 2\nB\n#line 3 0\nM\n");
    EXPECT_EQ(source->files, (std::vector<std::string>{"main.frag", "a.glsl", "b.glsl"}));
}

TEST_F(ShaderSourceTest, CountsLinesAfterAnIncludeThatWasSkipped) {
    write("a.glsl", "A\n");
    write("main.frag", "#if 0\n#include \"a.glsl\"\n  #else\nX\n#endif\nM\n");
    const auto source = load_shader(folder_, "main.frag");
    ASSERT_TRUE(source.ok()) << source.error().message;
    EXPECT_EQ(
        source->text,
        "#version 330 core\n#line 1 0\n#if 0\n#line 1 1\nA\n#line 3 0\n  #else\n#line 4 0\nX\n"
        "#endif\n#line 6 0\nM\n");
}

TEST_F(ShaderSourceTest, NamesTheLineOfAMissingInclude) {
    write("main.frag", "x\n#include \"gone.glsl\"\n");
    const auto source = load_shader(folder_, "main.frag");
    ASSERT_FALSE(source.ok());
    EXPECT_NE(source.error().message.find("main.frag:2: "), std::string::npos)
        << source.error().message;
    EXPECT_EQ(source.error().exit_code, ExitCode::NoDisplay);
}

TEST_F(ShaderSourceTest, RefusesIncludesOutsideTheFolder) {
    write("main.frag", "#include \"../../etc/passwd\"\n");
    EXPECT_FALSE(load_shader(folder_, "main.frag").ok());
}

TEST(WithFileNames, KnowsTheFormsOfThreeDrivers) {
    const std::vector<std::string> files{"mesh.frag", "include/fog.glsl"};
    EXPECT_EQ(with_file_names("0:12(5): error: syntax", files), "mesh.frag:12: error: syntax");
    EXPECT_EQ(with_file_names("1(7) : error C0000", files), "include/fog.glsl:7: error C0000");
    EXPECT_EQ(with_file_names("ERROR: 1:7: 'x'", files), "ERROR: include/fog.glsl:7: 'x'");
    EXPECT_EQ(with_file_names("9:7(1): error: far", files), "9:7(1): error: far");
    EXPECT_EQ(with_file_names("linking failed", files), "linking failed");
}

}  // namespace
}  // namespace plumbline::render
