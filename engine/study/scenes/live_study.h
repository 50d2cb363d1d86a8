// A study of a scene beside the program that shows it: runs in other processes, looked after by a thread
// here. The thread opens files and waits for processes; it touches no simulation.
#pragma once

#include "engine/study/scenes/scene_study.h"

#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace plumbline::study {

class LiveStudy {
public:
    /// Begins at once. `options.tell`, `progress` and the token in `workers` are replaced.
    explicit LiveStudy(SceneStudyOptions options);
    /// Stops it, and waits for that: a twentieth of a second at most.
    ~LiveStudy() = default;
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;

    /// It ends soon, with the points that there are.
    void stop() { thread_.request_stop(); }

    struct State {
        SceneStudy study{};  ///< its points come one by one; `complete` counts once it has ended
        StudyProgress progress{};
        bool ended{false};
        std::string failure{};  ///< of one that ended without a study
    };
    State state() const;
    StudyProgress progress() const;  ///< of state(), without a copy of the study
    /// Another number where state() has changed in more than its progress.
    std::uint64_t revision() const;

private:
    void run(SceneStudyOptions options);

    mutable std::mutex mutex_;
    State state_;
    std::uint64_t revision_{0};
    std::jthread thread_;  // last: it uses the others
};

}  // namespace plumbline::study
