#include "engine/render/shaders/shader_library.h"

#include "engine/core/time/stopwatch.h"
#include "engine/render/shaders/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace plumbline::render {

Result<gl::Program> ShaderLibrary::build(const Key& key, std::span<const Feature> features) const {
    const std::string defines = defines_of(features, key.features);
    auto vertex = load_shader(folder_, key.vertex, defines);
    if (!vertex) return vertex.error();
    auto fragment = load_shader(folder_, key.fragment, defines, vertex->files.size());
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
        const auto source = load_shader(folder_, file);
        if (!source) return source.error();
    }
    return Done{};
}

Result<const gl::Program*> ShaderLibrary::compile(const ShaderPair& files, FeatureSet features) {
    Key key{files.vertex, files.fragment, features};
    const auto found = programs_.find(key);
    if (found != programs_.end() && found->second.program) {
        found->second.used = frame_;
        return static_cast<const gl::Program*>(&*found->second.program);
    }
    auto program = build(key, files.features);
    Entry& entry = programs_[std::move(key)];
    entry = {.features = files.features, .used = frame_};
    if (!program) return program.error();
    entry.program = std::move(*program);
    return static_cast<const gl::Program*>(&*entry.program);
}

const gl::Program* ShaderLibrary::find(const ShaderPair& files, FeatureSet features) {
    const auto found = programs_.find(Key{files.vertex, files.fragment, features});
    if (found != programs_.end() && !found->second.program) return nullptr;
    const auto program = compile(files, features);
    if (program) return *program;
    if (fault_.empty()) fault_ = program.error().message;
    return nullptr;
}

void ShaderLibrary::begin_frame(double new_programs_s) {
    left_s_ = new_programs_s;
    first_draw_from_s_.reset();
    new_count_ = 0;
    drop_unused();
    ++frame_;
}

void ShaderLibrary::drop_unused() {
    while (bytes() > most_bytes_) {
        const auto oldest = std::ranges::min_element(
            programs_, {}, [](const auto& one) { return one.second.used; });
        if (oldest->second.used == frame_) return;
        programs_.erase(oldest);
    }
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
    programs_.find(key)->second.drawn = true;
    first_draw_from_s_ = from_s;
    ++new_count_;
    return program;
}

Result<Done> ShaderLibrary::reload() {
    std::string failures;
    for (auto& [key, entry] : programs_) {
        auto program = build(key, entry.features);
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
