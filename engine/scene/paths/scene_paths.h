// Where the files lie that a scene names: below the folder of the file that names them, or below
// the assets folder, and nowhere else.
#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string_view>

namespace plumbline::scene {

/// A name that keeps the rules. `file` need not exist.
struct Reference {
    std::filesystem::path file;
    std::filesystem::path root;  ///< the folder that confines it and what it names in turn
    bool exists{false};          ///< as a file or a folder
};

/// `name` as `naming_file` writes it: first beside that file, then below the assets folder. `..` is
/// good as long as it stays inside the assets folder (or the naming file's own). The error says
/// which rule the name breaks.
Result<Reference> find_reference(const std::filesystem::path& naming_file,
                                 const std::filesystem::path& assets_folder,
                                 std::string_view name);

}  // namespace plumbline::scene
