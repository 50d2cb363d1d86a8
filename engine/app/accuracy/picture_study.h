// What the levels of the image cost and how far off they are from where one looks, measured by
// `plumbline study --picture` in a process of low priority.
#pragma once

#include "engine/core/io/scratch_folder.h"
#include "engine/core/pose.h"
#include "engine/core/process/process.h"
#include "engine/study/findings/image_findings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

class PictureStudy {
public:
    /// Of the scene's file, 2 s after its start, from that camera. One that runs is stopped.
    void start(const std::filesystem::path& scene, const Pose& world_from_camera);
    void stop() { process_.reset(); }
    /// Once a frame.
    void take_answers();

    bool runs() const { return process_.has_value(); }
    /// "level high", "level medium" and "level low", of the latest that ended.
    const std::vector<study::ImageRow>& rows() const { return rows_; }
    /// Why the latest one came to nothing; empty: it did not.
    const std::string& failure() const { return failure_; }

private:
    void end();

    std::optional<ScratchFolder> folder_;
    std::optional<ChildProcess> process_;
    std::string printed_;
    std::vector<study::ImageRow> rows_;
    std::string failure_;
};

/// As --camera takes it: "x,y,z,yaw,pitch" in metres and degrees.
std::string camera_option(const Pose& world_from_camera);

}  // namespace plumbline::app
