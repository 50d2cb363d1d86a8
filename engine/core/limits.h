// Every limit on what comes from outside, in one place. Each has a test one below and one above.
#pragma once

#include <cstddef>
#include <cstdint>

namespace plumbline::limits {

inline constexpr std::size_t kConfigFileBytes = 256 * 1024;
inline constexpr std::size_t kSceneFileBytes = 8 * 1024 * 1024;
inline constexpr std::size_t kTextNesting = 32;
inline constexpr std::size_t kDottedKeyParts = 4;
inline constexpr std::size_t kLineBytes = 16 * 1024;

inline constexpr std::size_t kModelFileBytes = 256ULL * 1024 * 1024;
inline constexpr std::size_t kModelJsonBytes = 32ULL * 1024 * 1024;
inline constexpr std::size_t kModelJsonDepth = 64;
inline constexpr std::size_t kModelNodes = 65'536;
inline constexpr std::size_t kModelNodeDepth = 256;
inline constexpr std::size_t kModelMeshes = 16'384;
inline constexpr std::size_t kModelMaterials = 4'096;
inline constexpr std::size_t kModelAccessors = 65'536;
inline constexpr std::size_t kVertices = 10'000'000;
inline constexpr std::size_t kIndices = 30'000'000;
inline constexpr std::size_t kReferencedFiles = 1'024;

inline constexpr std::uint32_t kImageSide = 16'384;
inline constexpr std::size_t kImageBytes = 256ULL * 1024 * 1024;        // decoded
inline constexpr std::size_t kSceneImageBytes = 1024ULL * 1024 * 1024;  // of all of them
inline constexpr std::size_t kSoundBytes = 64ULL * 1024 * 1024;

inline constexpr std::size_t kBodiesWarn = 5'000;
inline constexpr std::size_t kBodies = 50'000;
inline constexpr double kPosition_m = 1e5;
inline constexpr double kSizeMin_m = 1e-3;
inline constexpr double kSizeMax_m = 1e4;
inline constexpr double kMassMin_kg = 1e-3;
inline constexpr double kMassMax_kg = 1e7;
inline constexpr double kSpeed_mps = 1e3;
inline constexpr double kGravity_mps2 = 1e3;
inline constexpr int kStepHzMin = 30;
inline constexpr int kStepHzMax = 1'000;
inline constexpr std::size_t kLights = 256;
inline constexpr std::size_t kInputsPerAction = 16;

}  // namespace plumbline::limits
