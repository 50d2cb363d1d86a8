#include "engine/scene/paths/scene_paths.h"

#include "engine/core/io/files.h"

#include <string>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path& file) {
    const fs::path folder = file.parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/// `folder` as seen from the assets folder, "" when they are the same; false when it is outside.
bool relative_to_assets(const fs::path& folder, const fs::path& assets_folder, fs::path& relative) {
    if (assets_folder.empty() || !is_inside(assets_folder, folder)) return false;
    std::error_code failed;
    relative = fs::relative(folder, assets_folder, failed);
    if (failed) return false;
    if (relative == ".") relative.clear();
    return true;
}

Result<Reference> below(const fs::path& root, const std::string& name) {
    const Result<fs::path> file = resolve_inside(root, name);
    if (!file) return file.error();
    std::error_code failed;
    const bool exists = fs::exists(*file, failed) && !failed;
    return Reference{.file = *file, .root = root, .exists = exists};
}

}  // namespace

Result<Reference> find_reference(const fs::path& naming_file,
                                 const fs::path& assets_folder,
                                 std::string_view name) {
    const std::string wanted(name);
    const fs::path own_folder = folder_of(naming_file);
    // Joining would hide a leading slash: such names are judged, and refused, as they stand.
    if (wanted.empty() || wanted.front() == '/' || wanted.front() == '\\')
        return below(own_folder, wanted);
    fs::path own_in_assets;
    const bool in_assets = relative_to_assets(own_folder, assets_folder, own_in_assets);

    Result<Reference> beside = below(own_folder, wanted);
    if (in_assets) {
        // What lies beside a scene of ours may use all of the assets folder, also by "..".
        const bool plain = beside.ok();
        Result<Reference> wider = below(
            assets_folder, own_in_assets.empty() ? wanted : (own_in_assets / wanted).string());
        if (plain || wider.ok()) beside = wider;
    }
    if (beside.ok() && beside->exists) return beside;
    if (!assets_folder.empty()) {
        Result<Reference> shared = below(assets_folder, wanted);
        if (shared.ok() && shared->exists) return shared;
    }
    return beside;
}

}  // namespace plumbline::scene
