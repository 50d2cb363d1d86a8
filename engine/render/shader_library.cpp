#include "engine/render/shader_library.h"

#include "engine/render/shader_source.h"

#include <fmt/format.h>

#include <utility>

namespace plumbline::render {

Result<gl::Program> ShaderLibrary::build(const Key& key) const {
    auto vertex = load_shader(folder_, key.vertex, key.features);
    if (!vertex) return vertex.error();
    auto fragment = load_shader(folder_, key.fragment, key.features, vertex->files.size());
    if (!fragment) return fragment.error();
    auto program = gl::Program::link(vertex->text, fragment->text);
    if (program) return program;
    std::vector<std::string> files = vertex->files;
    files.insert(files.end(), fragment->files.begin(), fragment->files.end());
    return Error{fmt::format("shader {} + {} does not compile:\n{}",
                             key.vertex,
                             key.fragment,
                             with_file_names(program.error().message, files)),
                 ExitCode::NoDisplay};
}

Result<Done> ShaderLibrary::check_files(const ShaderPair& files) const {
    for (const char* file : {files.vertex, files.fragment}) {
        const auto source = load_shader(folder_, file, 0);
        if (!source) return source.error();
    }
    return Done{};
}

Result<const gl::Program*> ShaderLibrary::compile(const ShaderPair& files, FeatureSet features) {
    Key key{files.vertex, files.fragment, features};
    const auto found = programs_.find(key);
    if (found != programs_.end() && found->second) {
        return static_cast<const gl::Program*>(&*found->second);
    }
    auto program = build(key);
    if (!program) {
        programs_[std::move(key)] = std::nullopt;
        return program.error();
    }
    std::optional<gl::Program>& slot = programs_[std::move(key)];
    slot = std::move(*program);
    return static_cast<const gl::Program*>(&*slot);
}

const gl::Program* ShaderLibrary::find(const ShaderPair& files, FeatureSet features) {
    const auto found = programs_.find(Key{files.vertex, files.fragment, features});
    if (found != programs_.end()) return found->second ? &*found->second : nullptr;
    const auto program = compile(files, features);
    if (program) return *program;
    if (fault_.empty()) fault_ = program.error().message;
    return nullptr;
}

Result<Done> ShaderLibrary::reload() {
    std::string failures;
    for (auto& [key, slot] : programs_) {
        auto program = build(key);
        if (program) {
            slot = std::move(*program);
        } else if (failures.find(program.error().message) == std::string::npos) {
            failures += (failures.empty() ? "" : "\n") + program.error().message;
        }
    }
    fault_ = failures;
    if (failures.empty()) return Done{};
    return Error{.message = failures, .exit_code = ExitCode::NoDisplay};
}

}  // namespace plumbline::render
