// Compiles shader programs on demand, one for each (files, features) that is asked for, and keeps those
// that were used last within a bound of memory.
#pragma once

#include "engine/core/result.h"
#include "engine/render/gl/program.h"
#include "engine/render/shaders/feature_set.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace plumbline::render {

/// What may stand in for a program that is not there yet.
struct Substitutes {
    FeatureSet kept{0};  ///< features that it must have where they are asked for
    FeatureSet harmless{
        0};              ///< features that it may have although nobody asked; of all others none
    FeatureSet dear{0};  ///< features that are missed more than others
};

/// Of a program in the driver's memory: on llvmpipe the median of what a mesh program adds to the
/// resident set, most of it machine code and its tables.
inline constexpr std::size_t kProgramBytes = 1250 * 1024;
/// Of all programs. The largest scene draws a frame with 48.
inline constexpr std::size_t kMostProgramBytes = 64 * kProgramBytes;

class ShaderLibrary {
public:
    explicit ShaderLibrary(std::filesystem::path folder, std::size_t most_bytes = kMostProgramBytes)
        : folder_(std::move(folder)), most_bytes_(most_bytes) {}

    /// Call once a frame, before its programs are asked for. `new_programs_s` is the time that the frame
    /// spends on programs of find_or_similar() that are new. Above the bound of memory, programs are
    /// dropped that were not used in the frame before, those first that were used longest ago.
    void begin_frame(double new_programs_s = std::numeric_limits<double>::infinity());
    /// Compiles at the first call. Null if it does not compile: see fault(), not tried again until
    /// reload(). The pointer is good until the next begin_frame() or clear(); reload() swaps what is
    /// behind it.
    const gl::Program* find(const ShaderPair& files, FeatureSet features);
    /// As find(); but once the frame's time for new programs is spent, a program that nothing was drawn
    /// with so far is left for a later frame, and the most similar one that was drawn with stands in.
    /// Without a substitute the program is compiled all the same. Draw with the program at once:
    /// drivers finish compiling with the first draw, and the time until the next call counts.
    const gl::Program* find_or_similar(const ShaderPair& files,
                                       FeatureSet features,
                                       const Substitutes& substitutes);
    /// Programs that were drawn with for the first time since begin_frame().
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
    /// An estimate: kProgramBytes each.
    std::size_t bytes() const { return programs_.size() * kProgramBytes; }
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
        std::span<const Feature> features;   ///< of the shader: the macros behind the key's bits
        std::optional<gl::Program> program;  ///< empty: did not compile
        bool drawn{false};                   ///< find_or_similar() gave it to be drawn with
        std::uint64_t used{0};               ///< the last frame that asked for it
    };
    Result<gl::Program> build(const Key& key, std::span<const Feature> features) const;
    const gl::Program* most_similar(const Key& key, const Substitutes& substitutes) const;
    void drop_unused();

    std::filesystem::path folder_;
    std::size_t most_bytes_;
    std::map<Key, Entry> programs_;
    std::string fault_;
    double left_s_{std::numeric_limits<double>::infinity()};
    std::optional<double> first_draw_from_s_;  ///< a new program is being drawn with
    std::uint32_t new_count_{0};
    std::uint64_t frame_{0};
};

}  // namespace plumbline::render
