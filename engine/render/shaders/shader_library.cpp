#include "engine/render/shaders/shader_library.h"

#include "engine/core/time/stopwatch.h"
#include "engine/render/shaders/shader_source.h"

#include <fmt/format.h>

#include <bit>
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
    if (found != programs_.end() && found->second.program) {
        return static_cast<const gl::Program*>(&*found->second.program);
    }
    auto program = build(key);
    std::optional<gl::Program>& slot = programs_[std::move(key)].program;
    slot.reset();
    if (!program) return program.error();
    slot = std::move(*program);
    return static_cast<const gl::Program*>(&*slot);
}

const gl::Program* ShaderLibrary::find(const ShaderPair& files, FeatureSet features) {
    const auto found = programs_.find(Key{files.vertex, files.fragment, features});
    if (found != programs_.end()) return found->second.program ? &*found->second.program : nullptr;
    const auto program = compile(files, features);
    if (program) return *program;
    if (fault_.empty()) fault_ = program.error().message;
    return nullptr;
}

void ShaderLibrary::allow_new(double seconds) {
    left_s_ = seconds;
    first_draw_from_s_.reset();
    new_count_ = 0;
    // Each holds a megabyte of the driver's, and comes back from its cache.
    if (++frame_ % (kKeptUnused / 4) != 0) return;
    std::erase_if(programs_, [&](const auto& program) {
        return program.second.drawn && program.second.used + kKeptUnused < frame_;
    });
}

const gl::Program* ShaderLibrary::most_similar(const Key& key,
                                               const Substitutes& substitutes) const {
    const gl::Program* best = nullptr;
    int least = std::numeric_limits<int>::max();
    for (const auto& [other, entry] : programs_) {
        if (!entry.drawn || !entry.program || other.vertex != key.vertex ||
            other.fragment != key.fragment)
            continue;
        const FeatureSet missing = key.features & ~other.features;
        const FeatureSet beside = other.features & ~key.features;
        if ((missing & substitutes.kept) != 0 || (beside & ~substitutes.harmless) != 0) continue;
        constexpr int kDear = 4;
        const int difference = std::popcount(missing | beside) +
                               (kDear - 1) * std::popcount(missing & substitutes.dear);
        if (difference >= least) continue;
        least = difference;
        best = &*entry.program;
    }
    return best;
}

const gl::Program* ShaderLibrary::find_or_similar(const ShaderPair& files,
                                                  FeatureSet features,
                                                  const Substitutes& substitutes) {
    if (first_draw_from_s_) left_s_ -= wall_s() - *std::exchange(first_draw_from_s_, {});
    const Key key{files.vertex, files.fragment, features};
    const auto found = programs_.find(key);
    if (found != programs_.end() && found->second.drawn) {
        found->second.used = frame_;
        return &*found->second.program;
    }
    if (left_s_ <= 0.0) {
        if (const gl::Program* similar = most_similar(key, substitutes)) return similar;
    }
    const double from_s = wall_s();
    const gl::Program* program = find(files, features);
    if (program == nullptr) return nullptr;
    Entry& entry = programs_.find(key)->second;
    entry.drawn = true;
    entry.used = frame_;
    first_draw_from_s_ = from_s;
    ++new_count_;
    return program;
}

Result<Done> ShaderLibrary::reload() {
    std::string failures;
    for (auto& [key, entry] : programs_) {
        auto program = build(key);
        if (program) {
            entry.program = std::move(*program);
        } else if (failures.find(program.error().message) == std::string::npos) {
            failures += (failures.empty() ? "" : "\n") + program.error().message;
        }
    }
    fault_ = failures;
    if (failures.empty()) return Done{};
    return Error{.message = failures, .exit_code = ExitCode::NoDisplay};
}

}  // namespace plumbline::render
