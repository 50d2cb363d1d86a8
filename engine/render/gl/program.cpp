#include "engine/render/gl/program.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render::gl {
namespace {

Result<ShaderObject> compile(GLenum stage, const std::string& source) {
    ShaderObject shader{glCreateShader(stage)};
    const char* text = source.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint good = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    GLint length = 0;
    glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return Error{log, ExitCode::NoDisplay};
}

std::string link_log(unsigned int program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
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
    if (good != GL_TRUE) return Error{link_log(program.name()), ExitCode::NoDisplay};
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
