#include "engine/scene/camera_path.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/printable.h"
#include "engine/scene/game.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

namespace plumbline::scene {
namespace {

constexpr std::string_view kFirstLine = "plumbline camera path ";
constexpr std::string_view kVersion = "1";
constexpr std::size_t kFileBytes = 256ULL * 1024 * 1024;
constexpr std::size_t kOwnNumbers = 8;     // time_s, position, quaternion w x y z
constexpr std::size_t kReportNumbers = 6;  // direction, position
constexpr std::size_t kShownLetters = 40;
constexpr double kLongest_s = 1e6;

/// The numbers of one line; how many there are, or nothing where something else is there.
std::optional<std::size_t> numbers_of(std::string_view line,
                                      std::array<double, kOwnNumbers>& numbers) {
    std::size_t count = 0;
    const char* at = line.data();
    const char* const end = at + line.size();
    for (;;) {
        while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
        if (at == end) return count;
        double number = 0;
        const auto read = std::from_chars(at, end, number);
        if (read.ec != std::errc{} || !std::isfinite(number)) return {};
        if (count < numbers.size()) numbers[count] = number;
        ++count;
        at = read.ptr;
        if (at != end && *at != ' ' && *at != '\t' && *at != '\r') return {};
    }
}

Vec3d vector_from(const std::array<double, kOwnNumbers>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

bool is_far_out(const Vec3d& position_m) {
    return glm::any(glm::greaterThan(glm::abs(position_m), Vec3d{limits::kPosition_m}));
}

/// Reads line after line.
class PathReader {
public:
    PathReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Result<CameraPath> read() {
        if (text_.starts_with(kFirstLine)) {
            std::string_view version = take_line();
            version.remove_prefix(std::min(kFirstLine.size(), version.size()));
            if (version.ends_with('\r')) version.remove_suffix(1);
            if (version != kVersion)
                return fault(fmt::format("is version {} of camera paths; this program reads {}",
                                         shortened(version),
                                         kVersion));
            is_own_ = true;
            if (!text_.empty() && text_.back() != '\n') {
                number_ = 1 + static_cast<std::size_t>(std::ranges::count(text_, '\n')) + 1;
                return fault("breaks off in the middle of the line");
            }
        }
        CameraPath path;
        while (!text_.empty()) {
            const std::string_view line = take_line();
            const std::size_t first = line.find_first_not_of(" \t\r");
            if (first == std::string_view::npos || line[first] == '#') continue;
            if (const Result<Done> taken = take(line, path); !taken) return taken.error();
        }
        if (path.empty()) {
            number_ = 0;
            return fault("holds no pose");
        }
        return path;
    }

private:
    std::string_view take_line() {
        ++number_;
        const std::size_t end = std::min(text_.find('\n'), text_.size());
        const std::string_view line = text_.substr(0, end);
        text_.remove_prefix(std::min(end + 1, text_.size()));
        return line;
    }

    Result<Done> take(std::string_view line, CameraPath& path) const {
        std::array<double, kOwnNumbers> numbers{};
        const std::size_t wanted = is_own_ ? kOwnNumbers : kReportNumbers;
        const std::optional<std::size_t> count = numbers_of(line, numbers);
        if (!count || *count != wanted) {
            return fault(fmt::format(
                "{}; expected {}",
                count ? fmt::format("{} numbers", *count) : "\"" + shortened(line) + "\"",
                is_own_ ? "8 numbers: time_s x y z qw qx qy qz"
                        : "6 numbers: a direction and a position"));
        }
        if (path.size() >= CameraPath::kMostPoses)
            return fault(fmt::format("one pose too many: at most {} are read", path.size()));
        return is_own_ ? take_own(numbers, path) : take_report(numbers, path);
    }

    Result<Done> take_own(const std::array<double, kOwnNumbers>& numbers, CameraPath& path) const {
        const Vec3d position_m = vector_from(numbers, 1);
        if (numbers[0] < 0 || numbers[0] > kLongest_s)
            return fault(
                fmt::format("{} s; expected a time from 0 to {} s", numbers[0], kLongest_s));
        const glm::dvec4 turn{numbers[5], numbers[6], numbers[7], numbers[4]};
        if (is_far_out(position_m)) return fault(too_far());
        if (!(glm::length(turn) > 1e-6)) return fault("an orientation of length 0");
        const glm::dvec4 unit = turn / glm::length(turn);
        const Pose pose{.position = Vec3(position_m),
                        .orientation = Quat(static_cast<Real>(unit.w),
                                            static_cast<Real>(unit.x),
                                            static_cast<Real>(unit.y),
                                            static_cast<Real>(unit.z))};
        if (!path.add(numbers[0], pose))
            return fault(fmt::format("{} s is not after the line before", numbers[0]));
        return Done{};
    }

    Result<Done> take_report(const std::array<double, kOwnNumbers>& numbers,
                             CameraPath& path) const {
        const Vec3d direction = vector_from(numbers, 0);
        const Vec3d position_m = vector_from(numbers, 3);
        if (is_far_out(position_m)) return fault(too_far());
        if (!(glm::length(direction) > 1e-6)) return fault("a direction of length 0");
        CameraDescription camera;
        camera.position_m = Vec3(position_m);
        camera.target_m = Vec3(position_m + glm::normalize(direction));
        path.add(static_cast<double>(path.size()) / CameraPath::kFramesPer_s, camera_pose(camera));
        return Done{};
    }

    static std::string too_far() {
        return fmt::format("a position beyond {:.0f} m", limits::kPosition_m);
    }
    static std::string shortened(std::string_view text) {
        return printable(std::string(text.substr(0, kShownLetters)));
    }
    Error fault(const std::string& what) const {
        if (number_ == 0)
            return {.message = fmt::format("{}: {}", name_, what), .exit_code = ExitCode::Refused};
        return {.message = fmt::format("{}:{}: {}", name_, number_, what),
                .exit_code = ExitCode::Refused};
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t number_{0};  ///< of the line at hand
    bool is_own_{false};
};

template <class T>
T hermite(const T& from, const T& from_slope, const T& to, const T& to_slope, Real s, Real span) {
    const Real s2 = s * s;
    const Real s3 = s2 * s;
    return from * (2 * s3 - 3 * s2 + 1) + from_slope * ((s3 - 2 * s2 + s) * span) +
           to * (3 * s2 - 2 * s3) + to_slope * ((s3 - s2) * span);
}

}  // namespace

Result<CameraPath> CameraPath::read(const std::filesystem::path& file) {
    const Result<std::string> text = read_file(file, kFileBytes);
    if (!text) return text.error();
    return parse(*text, file.string());
}

Result<CameraPath> CameraPath::parse(std::string_view text, const std::string& name) {
    return PathReader(text, name).read();
}

std::string CameraPath::text() const {
    std::string text = fmt::format("{}{}\n# time_s  x y z  qw qx qy qz\n", kFirstLine, kVersion);
    for (const Key& key : keys_) {
        fmt::format_to(std::back_inserter(text),
                       "{:.6f} {} {} {} {} {} {} {}\n",
                       key.time_s,
                       key.position_m.x,
                       key.position_m.y,
                       key.position_m.z,
                       key.turn.w,
                       key.turn.x,
                       key.turn.y,
                       key.turn.z);
    }
    return text;
}

bool CameraPath::add(double time_s, const Pose& world_from_camera) {
    if (keys_.size() >= kMostPoses || (!keys_.empty() && time_s <= keys_.back().time_s))
        return false;
    const Quat& q = world_from_camera.orientation;
    Vec4 turn{q.x, q.y, q.z, q.w};
    // q and -q are one orientation: between neighbours the way is the short one.
    if (!keys_.empty() && glm::dot(turn, keys_.back().turn) < 0) turn = -turn;
    keys_.push_back({.time_s = time_s, .position_m = world_from_camera.position, .turn = turn});
    return true;
}

double CameraPath::length_s() const {
    return keys_.empty() ? 0.0 : keys_.back().time_s - keys_.front().time_s;
}

Vec3 CameraPath::velocity_at(std::size_t key) const {
    const Key& before = keys_[key > 0 ? key - 1 : 0];
    const Key& after = keys_[std::min(key + 1, keys_.size() - 1)];
    return (after.position_m - before.position_m) / static_cast<Real>(after.time_s - before.time_s);
}

Vec4 CameraPath::turning_at(std::size_t key) const {
    const Key& before = keys_[key > 0 ? key - 1 : 0];
    const Key& after = keys_[std::min(key + 1, keys_.size() - 1)];
    return (after.turn - before.turn) / static_cast<Real>(after.time_s - before.time_s);
}

Pose CameraPath::at(double time_s) const {
    const double wanted_s = keys_.front().time_s + std::clamp(time_s, 0.0, length_s());
    const auto next = std::ranges::lower_bound(keys_, wanted_s, {}, &Key::time_s);
    const auto to = static_cast<std::size_t>(next - keys_.begin());
    const Key& there = keys_[std::min(to, keys_.size() - 1)];
    Vec3 position_m = there.position_m;
    Vec4 turn = there.turn;
    if (to > 0 && there.time_s > wanted_s) {
        const Key& here = keys_[to - 1];
        const double span_s = there.time_s - here.time_s;
        const auto s = static_cast<Real>((wanted_s - here.time_s) / span_s);
        const auto span = static_cast<Real>(span_s);
        position_m = hermite(
            here.position_m, velocity_at(to - 1), there.position_m, velocity_at(to), s, span);
        turn = hermite(here.turn, turning_at(to - 1), there.turn, turning_at(to), s, span);
    }
    turn = glm::normalize(turn);
    return {.position = position_m, .orientation = Quat(turn.w, turn.x, turn.y, turn.z)};
}

}  // namespace plumbline::scene
