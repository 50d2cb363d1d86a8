// Studies of scenes kept between runs: one file per scene, program and machine in
// $XDG_CACHE_HOME/plumbline/study. What is there can always be made again.
#pragma once

#include "engine/scene/open_scene.h"
#include "engine/study/scenes/scene_study.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace plumbline::study {

/// What a study depends on. Any change of the scene file, its includes, its models or the surfaces,
/// of the program's bytes or of the processor makes another key.
struct StudyKey {
    std::uint64_t scene{0};    ///< OpenedScene::motion_hash()
    std::uint64_t program{0};  ///< of the running program's file; 0: it cannot be read
    std::string machine{};
};
StudyKey study_key(const scene::OpenedScene& scene);

struct CachedStudy {
    SceneStudy study{};
    GridSize grid{GridSize::Full};
    std::string made_on;  ///< "2026-11-21"
};

/// Empty: neither XDG_CACHE_HOME nor HOME is set.
std::filesystem::path study_cache_folder();
std::filesystem::path study_file(const std::filesystem::path& folder, const StudyKey& key);

/// None: there is none, or it cannot be read; the latter is said in one line.
std::optional<CachedStudy> find_study(const std::filesystem::path& folder, const StudyKey& key);
/// Makes the folder. A quick study does not replace a full one of the same key.
Result<Done> keep_study(const std::filesystem::path& folder,
                        const StudyKey& key,
                        const CachedStudy& study);

}  // namespace plumbline::study
