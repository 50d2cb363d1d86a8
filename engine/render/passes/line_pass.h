// Debug lines over the finished image: solid where they are in sight, faint where they are hidden.
#pragma once

#include "engine/core/lines.h"
#include "engine/render/gl/buffer.h"
#include "engine/render/gl/object.h"
#include "engine/render/passes/pass_context.h"

namespace plumbline::render {

class LinePass {
public:
    void render(const LineList& lines, PassContext context);

private:
    gl::VertexArrayObject vertex_array_;
    gl::Buffer vertices_;
};

}  // namespace plumbline::render
