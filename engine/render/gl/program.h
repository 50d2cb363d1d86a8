// A linked shader program. Uniform blocks and samplers get their binding points from two tables
// after linking, because GLSL 3.30 cannot state them.
#pragma once

#include "engine/core/result.h"
#include "engine/render/gl/object.h"

#include <string>
#include <string_view>

namespace plumbline::render::gl {

class Program {
public:
    Program() = default;
    /// The error holds the driver's text as it is; shader_library puts file names to it.
    static Result<Program> link(const std::string& vertex_source,
                                const std::string& fragment_source);

    void use() const;
    /// -1 when the linked program has no such uniform.
    int location(const char* uniform) const;
    unsigned int name() const { return object_.name(); }

private:
    ProgramObject object_;
};

}  // namespace plumbline::render::gl
