#include "engine/app/accuracy/picture_study.h"

#include "engine/core/io/files.h"
#include "engine/study/findings/findings_json.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::app {
namespace {

constexpr std::size_t kMost_bytes = std::size_t{16} << 20U;

}  // namespace

std::string camera_option(const Pose& world_from_camera) {
    const Vec3d eye_m(world_from_camera.position);
    const Vec3d sight(world_from_camera.orientation * Vec3{0, 0, -1});
    return fmt::format("{:.4f},{:.4f},{:.4f},{:.3f},{:.3f}",
                       eye_m.x,
                       eye_m.y,
                       eye_m.z,
                       glm::degrees(std::atan2(-sight.x, -sight.z)),
                       glm::degrees(std::asin(std::clamp(sight.y, -1.0, 1.0))));
}

void PictureStudy::start(const std::filesystem::path& scene, const Pose& world_from_camera) {
    process_.reset();
    failure_.clear();
    printed_.clear();
    Result<ScratchFolder> folder = ScratchFolder::make("picture");
    if (!folder) {
        failure_ = folder.error().message;
        return;
    }
    folder_ = std::move(*folder);
    Result<ChildProcess> process =
        ChildProcess::start({.program = study::sibling_programs().float32,
                             .arguments = {"--quiet",
                                           "study",
                                           scene.string(),
                                           "--picture",
                                           "--quick",
                                           "--camera=" + camera_option(world_from_camera),
                                           "--out",
                                           folder_->path().string()},
                             .own_group = true,
                             .tells_us = true,
                             .priority = Priority::Idle});
    if (process)
        process_.emplace(std::move(*process));
    else
        failure_ = process.error().message;
}

void PictureStudy::take_answers() {
    while (process_ && process_->has_output()) {
        if (!process_->receive(printed_)) end();
    }
}

void PictureStudy::end() {
    const ChildEnd end = process_->end(1);
    process_.reset();
    const Result<std::string> text = read_file(folder_->path() / "findings.json", kMost_bytes);
    folder_.reset();
    if (text) {
        Result<study::Findings> findings = study::findings_from_json(*text);
        if (findings && !findings->images.empty()) {
            rows_ = std::move(findings->images.front().rows);
            return;
        }
    }
    while (printed_.ends_with('\n')) printed_.pop_back();
    failure_ = fmt::format("it {}: {}", end.words, printed_.substr(printed_.rfind('\n') + 1));
}

}  // namespace plumbline::app
