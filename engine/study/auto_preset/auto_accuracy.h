// What preset = "auto" means for a scene on this machine: the setting that a study of it recommends.
#pragma once

#include "engine/scene/open_scene.h"
#include "engine/study/auto_preset/study_cache.h"
#include "engine/study/scenes/scene_text.h"

namespace plumbline::study {

/// The accuracy to build `scene` with. Another preset comes back as it is. "auto": from the study that is
/// kept, else from a short one of a few settings, made now in other processes (some 10 s, said on
/// stderr, and kept). What the file or the command line gives beside the preset stands; where that
/// leaves nothing to choose, no study is made. Never fails: where no study can be had the numbers of "balanced"
/// come back, and a warning says why. In float64 always: there the program studies nothing.
scene::Accuracy resolve_auto(const scene::OpenedScene& scene);

/// The setting that a study of it recommends, as "auto" takes it. The error says why there is none.
Result<scene::Accuracy> studied_accuracy(const scene::OpenedScene& scene);

/// The study's choice as a scene would give it, over what `asked` leaves open. None: the study has
/// no setting that agrees with what the file gives.
struct AutoChoice {
    scene::Accuracy accuracy;
    Point point;
    bool met{false};
};
std::optional<AutoChoice> auto_choice(const SceneStudy& study, const scene::Accuracy& asked);

}  // namespace plumbline::study
