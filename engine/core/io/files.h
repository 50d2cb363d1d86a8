// Finding, reading and writing files. Reading takes regular files only and looks at sizes first;
// writing is atomic: the old file or the new one, never half of either.
#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline {

/// Where the program's own files are.
struct DataFolders {
    std::filesystem::path assets;
    std::filesystem::path shaders;
    std::filesystem::path config;
};

/// PLUMBLINE_DATA where it is set (what --data does), else ../share/plumbline from the program, where
/// it is installed, else beside and above the program, in a build folder. Never the current folder.
/// The error names the folders tried.
Result<DataFolders> find_data_folders();

/// The whole file as bytes. Refuses folders, FIFOs and devices, and files over max_bytes.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Temporary file beside the target, fsync, rename, fsync of the folder. On any failure the old
/// file stands, the temporary one is gone and the error says what failed. Of two programs that save
/// at once the last one wins, whole. What a killed program left behind goes with a later save.
///
/// A new file has the mode that the umask gives. A replaced one keeps its mode, and its owner and
/// group as far as the system lets us set them; where not even the group can be kept, the new group
/// gets no rights. A link stays, what it points to is replaced; another name of the same file (a hard
/// link) keeps the old bytes.
Result<Done> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// With those above it, where they are missing.
Result<Done> make_folder(const std::filesystem::path& folder);
/// As write_file_atomically, in a folder that is made where it is missing.
Result<Done> write_file_and_folder(const std::filesystem::path& path, std::string_view bytes);
/// As write_file_atomically for what another program writes: a new empty file beside `path`, with its ending
/// and its mode, and what puts that file in the place of `path` once it is whole.
Result<std::filesystem::path> make_file_beside(const std::filesystem::path& path);
Result<Done> replace_by(const std::filesystem::path& path, const std::filesystem::path& temporary);
/// Removes what killed programs left of their saves in `folder`: files that no running process of this
/// machine named and nobody has written to for a minute. Should one be somebody's after all, only that
/// save fails.
void remove_stale_saves(const std::filesystem::path& folder);
/// ... and in all folders below it.
void remove_stale_saves_below(const std::filesystem::path& folder);

/// `reference`, as a file writes it, below `root`: relative, forward slashes, no way out of root,
/// links followed and still inside. The error says which rule it breaks.
Result<std::filesystem::path> resolve_inside(const std::filesystem::path& root,
                                             std::string_view reference);

/// True when `path`, links followed, is `root` or below it.
bool is_inside(const std::filesystem::path& root, const std::filesystem::path& path);

/// $XDG_CONFIG_HOME/plumbline, or ~/.config/plumbline; relative and empty values count as unset.
/// Empty when there is no home either.
std::filesystem::path user_config_folder();
/// $XDG_DATA_HOME/plumbline, or ~/.local/share/plumbline: images, recordings, saves.
std::filesystem::path user_data_folder();
/// $XDG_STATE_HOME/plumbline, or ~/.local/state/plumbline: what a crash leaves.
std::filesystem::path user_state_folder();
/// $XDG_CACHE_HOME/plumbline, or ~/.cache/plumbline: what can be made again.
std::filesystem::path user_cache_folder();

}  // namespace plumbline
