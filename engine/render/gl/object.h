// Owners of OpenGL names. A name is held as unsigned int, so that no GL header is needed here.
#pragma once

#include <utility>

namespace plumbline::render::gl {

void delete_buffer(unsigned int name);
void delete_vertex_array(unsigned int name);
void delete_texture(unsigned int name);
void delete_framebuffer(unsigned int name);
void delete_program(unsigned int name);
void delete_shader(unsigned int name);
void delete_query(unsigned int name);
void delete_sampler(unsigned int name);

/// Owns one name and deletes it; moves, does not copy. 0 owns none.
/// Must not outlive the context that the name belongs to.
template <void (*destroy)(unsigned int)>
class Object {
public:
    Object() = default;
    explicit Object(unsigned int name) : name_(name) {}
    ~Object() { reset(); }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
    Object& operator=(Object&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0U);
        }
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    unsigned int name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    void reset() {
        if (name_ != 0) destroy(name_);
        name_ = 0;
    }

private:
    unsigned int name_{0};
};

using BufferObject = Object<delete_buffer>;
using VertexArrayObject = Object<delete_vertex_array>;
using TextureObject = Object<delete_texture>;
using FramebufferObject = Object<delete_framebuffer>;
using ProgramObject = Object<delete_program>;
using ShaderObject = Object<delete_shader>;
using QueryObject = Object<delete_query>;
using SamplerObject = Object<delete_sampler>;

VertexArrayObject new_vertex_array();  ///< bound
TextureObject new_texture();

}  // namespace plumbline::render::gl
