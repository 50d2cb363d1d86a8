// The least OpenGL program that draws the peer scene's kind of frame: ground and instanced cubes
// sorted near to far, GGX shading, sun and flashlight each with a shadow map and 3 x 3 taps, a
// gradient sky. What it costs on a machine is the yardstick for the renderer's own figures.
//
//   minimal_frame [BOXES [FRAMES]]
#include "engine/core/math.h"
#include "engine/core/time/stopwatch.h"
#include "engine/platform/offscreen.h"
#include "tests/benchmarks/box_places.h"

#include <fmt/format.h>
#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace {

using namespace plumbline;

constexpr int kWidth_px = 1280;
constexpr int kHeight_px = 720;

const char* const kSceneVertex = R"(#version 330 core
layout(location = 0) in vec3 p; layout(location = 1) in vec3 n; layout(location = 2) in vec4 place;
uniform mat4 clip, sun, lamp; uniform vec3 scale;
out vec3 world, normal; out vec4 in_sun, in_lamp;
void main() {
    float c = cos(place.w), s = sin(place.w);
    mat3 turn = mat3(c, 0, -s, 0, 1, 0, s, 0, c);
    world = turn * (p * scale) + place.xyz; normal = turn * n;
    in_sun = sun * vec4(world + 0.05 * normal, 1); in_lamp = lamp * vec4(world + 0.02 * normal, 1);
    gl_Position = clip * vec4(world, 1);
})";

const char* const kSceneFragment = R"(#version 330 core
in vec3 world, normal; in vec4 in_sun, in_lamp;
uniform sampler2DShadow sun_map, lamp_map; uniform vec3 eye, to_sun, albedo; out vec4 color;
float lit(sampler2DShadow map, vec4 at, float texel) {
    vec3 q = at.xyz / at.w * 0.5 + 0.5; float sum = 0.0;
    for (int y = -1; y <= 1; ++y) for (int x = -1; x <= 1; ++x)
        sum += texture(map, q + vec3(vec2(x, y) * texel, -0.0005));
    return sum / 9.0;
}
vec3 shade(vec3 n, vec3 v, vec3 l) {
    vec3 h = normalize(v + l); float a2 = 0.4;
    float nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 0.001), nh = max(dot(n, h), 0.0);
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float f = 0.04 + 0.96 * pow(clamp(1.0 - dot(v, h), 0.0, 1.0), 5.0);
    return (albedo + a2 * f / (d * d * 4.0 * mix(2.0 * nl * nv, nl + nv, 0.64))) * nl;
}
void main() {
    vec3 n = normalize(normal), v = normalize(eye - world), l = eye - world;
    float d2 = dot(l, l); l = normalize(l);
    vec3 c = albedo * 0.1 + shade(n, v, to_sun) * lit(sun_map, in_sun, 1.0 / 2048.0);
    vec2 off = in_lamp.xy / in_lamp.w; float cone = clamp(1.2 - dot(off, off), 0.0, 1.0);
    c += shade(n, v, l) * (cone * 200.0 / d2) * lit(lamp_map, in_lamp, 1.0 / 1024.0);
    color = vec4(pow(min(c, 1.0), vec3(0.4545)), 1);
})";

const char* const kDepthVertex = R"(#version 330 core
layout(location = 0) in vec3 p; layout(location = 2) in vec4 place; uniform mat4 clip; uniform vec3 scale;
void main() {
    float c = cos(place.w), s = sin(place.w);
    gl_Position = clip * vec4(mat3(c, 0, -s, 0, 1, 0, s, 0, c) * (p * scale) + place.xyz, 1);
})";
const char* const kDepthFragment = "#version 330 core\nvoid main() {}\n";

const char* const kSkyVertex = R"(#version 330 core
out vec2 at;
void main() {
    at = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1); gl_Position = vec4(at, 1, 1);
})";
const char* const kSkyFragment = R"(#version 330 core
in vec2 at; out vec4 color;
void main() { color = vec4(mix(vec3(0.8, 0.85, 0.9), vec3(0.3, 0.5, 0.8), at.y * 0.5 + 0.5), 1); })";

GLuint link(const char* vertex, const char* fragment) {
    const GLuint program = glCreateProgram();
    for (const auto& [stage, text] :
         {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (good != GL_TRUE) fmt::print(stderr, "a shader of minimal_frame does not link\n");
    return program;
}

/// A framebuffer of its own; `color` false: a shadow map.
struct Target {
    GLuint framebuffer{0};
    GLuint depth{0};
    int width_px{0};
    int height_px{0};
};

Target make_target(int width_px, int height_px, bool color) {
    Target target{0, 0, width_px, height_px};
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glGenTextures(1, &target.depth);
    glBindTexture(GL_TEXTURE_2D, target.depth);
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 GL_DEPTH_COMPONENT24,
                 width_px,
                 height_px,
                 0,
                 GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth, 0);
    if (color) {
        GLuint image = 0;
        glGenRenderbuffers(1, &image);
        glBindRenderbuffer(GL_RENDERBUFFER, image);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_px, height_px);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image);
    } else {
        glDrawBuffer(GL_NONE);
    }
    return target;
}

std::vector<Vec3f> cube_vertices() {
    std::vector<Vec3f> vertices;  // position, normal, …
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-0.5F, 0.5F}) {
            Vec3f normal{0.0F};
            normal[axis] = side * 2.0F;
            Vec3f u{0.0F};
            u[(axis + 1) % 3] = 0.5F;
            const Vec3f v = glm::cross(normal, u);
            const Vec3f c = normal * 0.5F;
            for (const Vec3f& p :
                 {c - u - v, c + u - v, c + u + v, c - u - v, c + u + v, c - u + v}) {
                vertices.push_back(p);
                vertices.push_back(normal);
            }
        }
    }
    return vertices;
}

std::vector<Vec4f> places(int count, int frame) {
    std::vector<Vec4f> result;
    for (int i = 0; i < count; ++i) result.push_back(bench::box_place(i, frame));
    return result;
}

class MinimalFrame {
public:
    explicit MinimalFrame(int boxes) : boxes_(boxes) {
        glGenVertexArrays(1, &vertex_array_);
        glBindVertexArray(vertex_array_);
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        const std::vector<Vec3f> cube = cube_vertices();
        glBufferData(GL_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(cube.size() * sizeof(Vec3f)),
                     cube.data(),
                     GL_STATIC_DRAW);
        for (GLuint i = 0; i < 2; ++i) {
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i,
                                  3,
                                  GL_FLOAT,
                                  GL_FALSE,
                                  2 * sizeof(Vec3f),
                                  reinterpret_cast<const void*>(i * sizeof(Vec3f)));
        }
        glGenBuffers(1, &instances_);
        glBindBuffer(GL_ARRAY_BUFFER, instances_);
        glEnableVertexAttribArray(2);
        glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
        glVertexAttribDivisor(2, 1);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
    }

    void draw(int frame) {
        std::vector<Vec4f> boxes = places(boxes_, frame);
        std::ranges::sort(
            boxes, {}, [this](const Vec4f& p) { return glm::distance(Vec3f{p}, eye_); });
        glBindBuffer(GL_ARRAY_BUFFER, instances_);
        glBufferData(GL_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(boxes.size() * sizeof(Vec4f)),
                     boxes.data(),
                     GL_STREAM_DRAW);
        const Mat4f view = glm::lookAt(eye_, Vec3f{0.0F, 4.0F, 0.0F}, Vec3f{0.0F, 1.0F, 0.0F});
        const Mat4f clip =
            glm::perspective(radians_from_degrees(60.0F), 16.0F / 9.0F, 0.1F, 300.0F) * view;
        const Mat4f sun = glm::ortho(-52.0F, 52.0F, -52.0F, 52.0F, -60.0F, 60.0F) *
                          glm::lookAt(to_sun_, Vec3f{0.0F}, Vec3f{0.0F, 1.0F, 0.0F});
        const Mat4f lamp = glm::perspective(radians_from_degrees(44.0F), 1.0F, 0.5F, 60.0F) * view;
        draw_depth(sun_map_, sun);
        draw_depth(lamp_map_, lamp);
        begin(screen_, scene_program_);
        set_matrix(scene_program_, "clip", clip);
        set_matrix(scene_program_, "sun", sun);
        set_matrix(scene_program_, "lamp", lamp);
        set_vector(scene_program_, "eye", eye_);
        set_vector(scene_program_, "to_sun", to_sun_);
        glUniform1i(glGetUniformLocation(scene_program_, "lamp_map"), 1);
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, lamp_map_.depth);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, sun_map_.depth);
        set_vector(scene_program_, "albedo", {0.7F, 0.45F, 0.25F});
        draw_boxes(scene_program_);
        set_vector(scene_program_, "albedo", {0.35F, 0.4F, 0.3F});
        draw_ground(scene_program_);
        glUseProgram(sky_program_);
        glDepthFunc(GL_LEQUAL);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDepthFunc(GL_LESS);
        glFinish();
    }

private:
    static void set_matrix(GLuint program, const char* name, const Mat4f& value) {
        glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(value));
    }
    static void set_vector(GLuint program, const char* name, const Vec3f& value) {
        glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
    }
    void begin(const Target& target, GLuint program) const {
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        glViewport(0, 0, target.width_px, target.height_px);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program);
    }
    void draw_boxes(GLuint program) const {
        set_vector(program, "scale", Vec3f{1.0F});
        glEnableVertexAttribArray(2);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, boxes_);
    }
    void draw_ground(GLuint program) const {
        set_vector(program, "scale", {120.0F, 1.0F, 120.0F});
        glDisableVertexAttribArray(2);
        glVertexAttrib4f(2, 0.0F, -0.5F, 0.0F, 0.0F);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 1);
    }
    void draw_depth(const Target& target, const Mat4f& clip) const {
        begin(target, depth_program_);
        set_matrix(depth_program_, "clip", clip);
        draw_boxes(depth_program_);
        draw_ground(depth_program_);
    }

    int boxes_;
    Vec3f eye_{0.0F, 9.0F, 24.0F};
    Vec3f to_sun_{glm::normalize(Vec3f{16.0F, 40.0F, 12.0F})};
    GLuint vertex_array_{0};
    GLuint instances_{0};
    GLuint scene_program_{link(kSceneVertex, kSceneFragment)};
    GLuint depth_program_{link(kDepthVertex, kDepthFragment)};
    GLuint sky_program_{link(kSkyVertex, kSkyFragment)};
    Target sun_map_{make_target(2048, 2048, false)};
    Target lamp_map_{make_target(1024, 1024, false)};
    Target screen_{make_target(kWidth_px, kHeight_px, true)};
};

}  // namespace

int main(int argc, char** argv) {
    const int boxes = argc > 1 ? std::atoi(argv[1]) : 1000;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
    auto context = plumbline::platform::OffscreenContext::create();
    if (!context || gladLoadGL((*context)->gl_loader()) == 0) {
        fmt::print(stderr, "no off-screen OpenGL here\n");
        return 3;
    }
    MinimalFrame minimal(boxes);
    for (int i = 0; i < 3; ++i) minimal.draw(i);
    const double start_s = process_cpu_s();
    for (int i = 0; i < frames; ++i) minimal.draw(i);
    fmt::print(
        "{} boxes: {:.1f} CPU ms a frame\n", boxes, (process_cpu_s() - start_s) * 1e3 / frames);
    return 0;
}
