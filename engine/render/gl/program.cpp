#include "engine/render/gl/program.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render::gl {
namespace {

/// What glGetShaderInfoLog or glGetProgramInfoLog tells.
template <class GetNumber, class GetLog>
std::string log_of(unsigned int name, GetNumber get_number, GetLog get_log) {
    GLint length = 0;
    get_number(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    get_log(name, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

Result<ShaderObject> compile(GLenum stage, const std::string& source) {
    ShaderObject shader{glCreateShader(stage)};
    const char* text = source.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint good = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    return Error{log_of(shader.name(), glGetShaderiv, glGetShaderInfoLog), ExitCode::NoDisplay};
}

void assign_bindings(unsigned int program) {
    for (const auto& [name, binding] : kBlockBindings) {
        const GLuint index = glGetUniformBlockIndex(program, name);
        if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, binding);
    }
    glUseProgram(program);
    for (const auto& [name, unit] : kSamplerUnits) {
        const GLint location = glGetUniformLocation(program, name);
        if (location >= 0) glUniform1i(location, static_cast<GLint>(unit));
    }
}

}  // namespace

Result<Program> Program::link(const std::string& vertex_source,
                              const std::string& fragment_source) {
    auto vertex = compile(GL_VERTEX_SHADER, vertex_source);
    if (!vertex) return vertex.error();
    auto fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
    if (!fragment) return fragment.error();
    Program program;
    program.object_ = ProgramObject{glCreateProgram()};
    glAttachShader(program.name(), vertex->name());
    glAttachShader(program.name(), fragment->name());
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex->name());
    glDetachShader(program.name(), fragment->name());
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE)
        return Error{log_of(program.name(), glGetProgramiv, glGetProgramInfoLog),
                     ExitCode::NoDisplay};
    assign_bindings(program.name());
    return program;
}

void Program::use() const {
    glUseProgram(object_.name());
}

int Program::location(const char* uniform) const {
    return glGetUniformLocation(object_.name(), uniform);
}

}  // namespace plumbline::render::gl
