#include "engine/study/auto_preset/study_cache.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/study/findings/findings_json_impl.h"
#include "engine/study/machine.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace plumbline::study {

template <>
inline constexpr std::array<std::string_view, 2> kWords<GridSize>{"full", "quick"};

void fields(const auto& field, Like<CachedStudy> auto& cached) {
    field("made_on", cached.made_on);
    field("grid", cached.grid);
    field("seconds", cached.study.seconds);
    field("from_s", cached.study.from_s);
    field("chaotic", cached.study.chaotic);
    field("subject", cached.study.subject);
}

namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;
constexpr std::size_t kProgramMost_bytes = std::size_t{1} << 30U;
constexpr std::size_t kStudyMost_bytes = std::size_t{16} << 20U;

std::uint64_t hash_of(const std::string& bytes) {
    Hasher hasher;
    hasher.add(bytes.data(), bytes.size());
    return hasher.digest();
}

/// What a study's file begins with.
Json head_of(const StudyKey& key) {
    return {{"format", kFormat},
            {"scene_hash", hex_of(key.scene)},
            {"program_hash", hex_of(key.program)},
            {"machine", key.machine}};
}

/// As the keys of [accuracy] are checked: the program is about to run at one of these.
void check(const Setting& setting) {
    const auto within = [](const char* key, int value, int least, int most) {
        if (value < least || value > most)
            throw std::runtime_error(fmt::format(
                "{} is {}; expected a whole number from {} to {}", key, value, least, most));
    };
    within("step_hz", setting.step_hz, limits::kStepHzMin, limits::kStepHzMax);
    within("substeps", setting.substeps, 0, scene::kMostSubsteps);
    within("substeps_max", setting.substeps_max, 1, scene::kMostSubsteps);
    within("iterations", setting.iterations, 1, scene::kMostIterations);
}

CachedStudy cached_from(const Json& json, const StudyKey& key) {
    const Json head = head_of(key);
    for (const auto& [name, value] : head.items()) {
        if (json.at(name) != value)
            throw std::runtime_error("it is of another scene, program or machine");
    }
    auto cached = json.get<CachedStudy>();
    if (cached.study.subject.points.empty()) throw std::runtime_error("it has no settings");
    for (const Point& point : cached.study.subject.points) check(point.setting);
    if (!std::isfinite(cached.study.seconds) || cached.study.seconds < 0 ||
        !std::isfinite(cached.study.from_s))
        throw std::runtime_error("its seconds are no time");
    return cached;
}

}  // namespace

StudyKey study_key(const scene::OpenedScene& scene) {
    StudyKey key{.scene = scene.motion_hash(), .machine = machine_text()};
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const Result<std::string> bytes = read_file(program, kProgramMost_bytes);
    if (bytes) key.program = hash_of(*bytes);
    return key;
}

fs::path study_cache_folder() {
    const fs::path folder = user_cache_folder();
    return folder.empty() ? fs::path{} : folder / "study";
}

fs::path study_file(const fs::path& folder, const StudyKey& key) {
    const std::string where = fmt::format("{} {}", hex_of(key.program), key.machine);
    return folder / fmt::format("{}-{}.json", hex_of(key.scene), hex_of(hash_of(where)));
}

std::optional<CachedStudy> find_study(const fs::path& folder, const StudyKey& key) {
    const fs::path file = study_file(folder, key);
    std::error_code error;
    if (folder.empty() || !fs::exists(file, error)) return {};
    const Result<std::string> text = read_file(file, kStudyMost_bytes);
    if (!text) {
        log_warning(
            "{}: the study kept there is not used: {}", file.string(), text.error().message);
        return {};
    }
    try {
        return cached_from(scene::read_json<Json>(*text), key);
    } catch (const std::exception& fault) {
        log_warning("{}: the study kept there is thrown away: {}", file.string(), fault.what());
        fs::remove(file, error);
        return {};
    }
}

Result<Done> keep_study(const fs::path& folder, const StudyKey& key, const CachedStudy& study) {
    if (folder.empty())
        return Error{.message = "neither XDG_CACHE_HOME nor HOME says where to keep studies"};
    if (study.grid == GridSize::Quick) {
        const std::optional<CachedStudy> there = find_study(folder, key);
        if (there && there->grid == GridSize::Full) return Done{};
    }
    Json json = head_of(key);
    json.update(Json(study));
    return write_file_and_folder(study_file(folder, key), text_of(json, 1) + "\n");
}

}  // namespace plumbline::study
