// Programs that link, and what the driver says of those that do not.
#include "engine/render/gl/program.h"
#include "engine/render/shader_blocks.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

class ProgramGl : public GlTest {};

const std::string kVertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";

std::string fragment(std::string_view body) {
    return "#version 330 core\nout vec4 color;\n" + std::string{body};
}

TEST_F(ProgramGl, SamplersAndBlocksGetTheirPlacesByName) {
    const auto& [sampler, unit] = *std::begin(kSamplerUnits);
    const auto program =
        gl::Program::link(kVertex,
                          fragment("uniform sampler2D " + std::string{sampler} +
                                   ";\nuniform float own;\nvoid main() { color = own * texture(" +
                                   std::string{sampler} + ", vec2(0.0)); }\n"));
    ASSERT_TRUE(program.ok()) << program.error().message;
    const int place = program->location(sampler);
    ASSERT_GE(place, 0);
    GLint found = -1;
    glGetUniformiv(program->name(), place, &found);
    EXPECT_EQ(found, static_cast<GLint>(unit));
    EXPECT_GE(program->location("own"), 0);
    EXPECT_EQ(program->location("none"), -1);
    program->use();
    GLint in_use = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &in_use);
    EXPECT_EQ(static_cast<unsigned int>(in_use), program->name());
    glUseProgram(0);
}

TEST_F(ProgramGl, AFaultOfEitherStageOrBetweenThemIsTheDriversText) {
    const auto error_of = [](const std::string& vertex, const std::string& other) {
        const auto program = gl::Program::link(vertex, other);
        EXPECT_FALSE(program.ok());
        if (program.ok()) return std::string{};
        EXPECT_EQ(program.error().exit_code, ExitCode::NoDisplay);
        return program.error().message;
    };
    const std::string good = fragment("void main() { color = vec4(1.0); }\n");
    EXPECT_NE(
        error_of("#version 330 core\nvoid main() { wrong_vertex(); }\n", good).find("wrong_vertex"),
        std::string::npos);
    EXPECT_NE(
        error_of(kVertex, fragment("void main() { color = wrong_color; }\n")).find("wrong_color"),
        std::string::npos);
    // The stages disagree about what one hands to the other.
    EXPECT_NE(error_of("#version 330 core\nout vec3 handed_on;\nvoid main() {\n"
                       "    handed_on = vec3(1.0);\n    gl_Position = vec4(0.0);\n}\n",
                       fragment("in vec2 handed_on;\n"
                                "void main() { color = vec4(handed_on, 0.0, 1.0); }\n"))
                  .find("handed_on"),
              std::string::npos);
}

}  // namespace
}  // namespace plumbline::render
