#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/input/bindings.h"
#include "engine/input/bindings_layer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

namespace plumbline::input {
namespace fs = std::filesystem;
namespace {

bool is_missing(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::not_found;
}

/// Adds a file as a layer; a missing one is no fault.
void add_file(BindingSources& sources,
              const fs::path& path,
              const std::string& name,
              Diagnostics& faults) {
    sources.watched.push_back(path);
    if (is_missing(path)) return;
    Result<std::string> text = read_file(path, limits::kConfigFileBytes);
    if (text) {
        sources.layers.push_back({name, std::move(*text)});
    } else {
        sources.left_out.push_back(name);
        faults.add_error(name, fmt::format("{}. The file is left out.", text.error().message));
    }
}

std::set<std::string> profiles_in(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ".toml") names.insert(it->path().stem().string());
    return names;
}

void add_profile(BindingSources& sources,
                 const fs::path& shipped_config_folder,
                 const std::string& profile,
                 Diagnostics& faults) {
    const fs::path folder = shipped_config_folder / "controls";
    const std::set<std::string> known = profiles_in(folder);
    // Only names that are there are opened: a profile cannot lead out of its folder.
    const std::string file = profile + ".toml";
    if (known.contains(profile))
        return add_file(sources, folder / file, "controls/" + file, faults);
    const std::vector<std::string_view> names(known.begin(), known.end());
    const std::string_view nearest = nearest_name(profile, names);
    faults.add_error("profile",
                     fmt::format("no profile \"{}\".{} There are: {}. None is used.",
                                 profile,
                                 nearest.empty() ? "" : fmt::format(" Nearest: \"{}\".", nearest),
                                 names.empty() ? std::string{"none"}
                                               : fmt::format("{}", fmt::join(names, ", "))));
}

/// What the user's file asks for; its faults are reported when the layer is loaded.
std::string profile_named_in(const std::vector<BindingLayer>& layers) {
    if (layers.empty()) return {};
    Tuning unused_tuning;
    Diagnostics unused_faults;
    const auto content = read_layer(layers.back(), unused_tuning, unused_faults);
    return content ? content->profile : std::string{};
}

}  // namespace

BindingSources find_binding_sources(const fs::path& shipped_config_folder,
                                    const fs::path& user_config_folder,
                                    const ProfileChoice& profile,
                                    Diagnostics& faults) {
    BindingSources user;
    std::string wanted{profile.asked};
    if (!user_config_folder.empty()) {
        add_file(user, user_config_folder / "bindings.toml", "bindings.toml", faults);
        if (wanted.empty()) wanted = profile_named_in(user.layers);
        add_file(user, user_config_folder / "bindings.ui.toml", "bindings.ui.toml", faults);
    }
    if (wanted.empty()) wanted = profile.usual;
    BindingSources sources;
    add_file(sources, shipped_config_folder / "bindings.toml", "config/bindings.toml", faults);
    if (!wanted.empty()) add_profile(sources, shipped_config_folder, wanted, faults);
    std::ranges::move(user.layers, std::back_inserter(sources.layers));
    std::ranges::move(user.watched, std::back_inserter(sources.watched));
    std::ranges::move(user.left_out, std::back_inserter(sources.left_out));
    return sources;
}

}  // namespace plumbline::input
