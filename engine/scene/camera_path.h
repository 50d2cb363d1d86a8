// Where a camera was, over time: recorded in play, played there and by `render`, kept as text.
#pragma once

#include "engine/core/pose.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

class CameraPath {
public:
    static constexpr std::size_t kMostPoses = 1'000'000;
    /// Of files without times, one pose a frame.
    static constexpr double kFramesPer_s = 60.0;

    /// The program's own format or the garden report's (docs/SCENE-FORMAT.md, "Camera paths"). The
    /// error names file and line.
    static Result<CameraPath> read(const std::filesystem::path& file);
    static Result<CameraPath> parse(std::string_view text, const std::string& name);
    /// In the program's own format.
    std::string text() const;

    /// Takes one more pose. Refused, with false: a time that is not after the last one's, or one pose
    /// too many.
    bool add(double time_s, const Pose& world_from_camera);

    /// At a time since the first pose: through every pose at its time, with steady speed between. The
    /// first and the last hold before and after. At least one pose.
    Pose at(double time_s) const;
    double length_s() const;
    std::size_t size() const { return keys_.size(); }
    bool empty() const { return keys_.empty(); }

private:
    struct Key {
        double time_s{0};
        Vec3 position_m{0, 0, 0};
        Vec4 turn{0, 0, 0, 1};  ///< quaternion x y z w, on the side of the one before
    };
    Vec3 velocity_at(std::size_t key) const;
    Vec4 turning_at(std::size_t key) const;

    std::vector<Key> keys_;
};

}  // namespace plumbline::scene
