// Compiles shader programs on demand, one for each (files, features) that is asked for.
#pragma once

#include "engine/core/result.h"
#include "engine/render/gl/program.h"
#include "engine/render/shaders/shader_features.h"

#include <cstdint>
#include <filesystem>
#include <limits>
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

/// What may stand in for a program that is not there yet.
struct Substitutes {
    FeatureSet kept{0};  ///< features that it must have where they are asked for
    FeatureSet harmless{
        0};              ///< features that it may have although nobody asked; of all others none
    FeatureSet dear{0};  ///< features that are missed more than others
};

class ShaderLibrary {
public:
    explicit ShaderLibrary(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Compiles at the first call. Null if it does not compile: see fault(), not tried again until
    /// reload(). The pointer is good until clear(); reload() swaps what is behind it.
    const gl::Program* find(const ShaderPair& files, FeatureSet features);
    /// As find(); but once allow_new()'s time is spent, a program that nothing was drawn with so far is
    /// left for a later frame, and the one most like it, of those that were, is given in its place.
    /// Where there is no substitute it is compiled all the same. For programs that are drawn with at
    /// once: drivers finish compiling with the first draw, and the time until the next call counts.
    const gl::Program* find_or_similar(const ShaderPair& files,
                                       FeatureSet features,
                                       const Substitutes& substitutes);
    /// For programs that are new in this frame; without a call there is no end to it. Once a frame:
    /// programs of find_or_similar() that nothing was drawn with for kKeptUnused frames are dropped.
    void allow_new(double seconds);
    static constexpr std::uint64_t kKeptUnused = 1800;
    /// Programs that were drawn with for the first time since allow_new().
    std::uint32_t new_count() const { return new_count_; }
    /// Why a program that was asked for is not what its files say; empty when all are.
    const std::string& fault() const { return fault_; }
    /// As find(), with the reason. The message names file and line and holds the driver's text.
    Result<const gl::Program*> compile(const ShaderPair& files, FeatureSet features);
    /// Compiles all programs anew. One that fails keeps its old program; the error holds all texts.
    Result<Done> reload();
    /// That all files of the pair are there; the error names the one that is not.
    Result<Done> check_files(const ShaderPair& files) const;
    std::size_t size() const { return programs_.size(); }
    /// Pointers to programs end here.
    void clear() { programs_.clear(); }

private:
    struct Key {
        std::string vertex;
        std::string fragment;
        FeatureSet features{0};
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    struct Entry {
        std::optional<gl::Program> program;  ///< empty: did not compile
        bool drawn{false};                   ///< with find_or_similar(),
        std::uint64_t used{0};               ///< in that frame at last
    };
    Result<gl::Program> build(const Key& key) const;
    const gl::Program* most_similar(const Key& key, const Substitutes& substitutes) const;

    std::filesystem::path folder_;
    std::map<Key, Entry> programs_;
    std::string fault_;
    double left_s_{std::numeric_limits<double>::infinity()};
    std::optional<double> first_draw_from_s_;  ///< a new program is being drawn with
    std::uint32_t new_count_{0};
    std::uint64_t frame_{0};
};

}  // namespace plumbline::render
