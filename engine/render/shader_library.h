// Compiles shader programs on demand, one for each (files, features) that is asked for.
#pragma once

#include "engine/core/result.h"
#include "engine/render/gl/program.h"
#include "engine/render/shader_features.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::render {

/// A vertex and a fragment shader by file name, e.g. {"mesh.vert", "mesh.frag"}.
struct ShaderPair {
    const char* vertex;
    const char* fragment;
};

class ShaderLibrary {
public:
    explicit ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Compiles at the first call. Null if it does not compile: see fault(), not tried again until
    /// reload(). The pointer is good as long as the library; reload() swaps what is behind it.
    const gl::Program* find(const ShaderPair& files, FeatureSet features);
    /// Why a program that was asked for is not what its files say; empty when all are.
    const std::string& fault() const { return fault_; }
    /// As find(), with the reason. The message names file and line and holds the driver's text.
    Result<const gl::Program*> compile(const ShaderPair& files, FeatureSet features);
    /// Compiles all programs anew. One that fails keeps its old program; the error holds all texts.
    Result<Done> reload();
    /// That all files of the pair are there; the error names the one that is not.
    Result<Done> check_files(const ShaderPair& files) const;
    std::size_t size() const { return programs_.size(); }

private:
    struct Key {
        std::string vertex;
        std::string fragment;
        FeatureSet features{0};
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    Result<gl::Program> build(const Key& key) const;

    std::filesystem::path folder_;
    /// Empty: did not compile.
    std::map<Key, std::optional<gl::Program>> programs_;
    std::string fault_;
};

}  // namespace plumbline::render
