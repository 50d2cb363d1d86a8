// The study of the scene that one plays: the one that was kept, and the one that is made meanwhile.
#pragma once

#include "engine/app/session.h"
#include "engine/study/auto_preset/study_cache.h"
#include "engine/study/scenes/live_study.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

class StudyControl {
public:
    /// The session must outlive it. `folder`: where studies are kept.
    explicit StudyControl(Session& session,
                          std::filesystem::path folder = study::study_cache_folder())
        : session_(session), folder_(std::move(folder)) {}

    /// Reads the study of the scene that was kept, unless one is there already.
    void look_up();
    /// From the running world's present state, in processes of low priority. One that runs is stopped.
    void start();
    void stop();
    /// Once a frame: takes what was measured since, and keeps a study that has ended. What belongs to
    /// another scene is forgotten.
    void take_answers();

    /// As far as it is known. Null: none was made.
    const study::SceneStudy* study() const { return study_ ? &*study_ : nullptr; }
    bool runs() const { return live_ != nullptr; }
    study::StudyProgress progress() const;
    /// Other work, drawing for one, leaves it no time: nothing came for 10 s.
    bool waits_for_processor() const;
    /// Things that play made, which the study that was started last leaves out.
    std::size_t left_out() const { return left_out_; }
    /// Why the latest one came to nothing; empty: it did not.
    const std::string& failure() const { return failure_; }

private:
    void forget_other_scene();
    void end(const study::LiveStudy::State& state);

    Session& session_;
    std::filesystem::path folder_;
    std::unique_ptr<study::LiveStudy> live_;
    std::uint64_t revision_{0};  ///< of `live_`, taken last
    double heard_s_{0};          ///< wall time of its start, or of what it last said
    std::optional<study::SceneStudy> study_;
    study::StudyKey key_{};  ///< of the scene that both belong to
    std::uint64_t generation_{0};
    std::vector<scene::FileStamp> files_{};  ///< of that scene
    std::size_t left_out_{0};
    std::string failure_;
};

}  // namespace plumbline::app
