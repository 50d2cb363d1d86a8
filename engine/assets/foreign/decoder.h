// Decoders that nobody has hardened (assimp, libpng, libjpeg-turbo, OpenEXR, libsndfile) in a confined
// process of their own, one a file. The program's hidden command `decoder` is that process: it takes a
// file's bytes from its standard input and answers on its standard output; it opens no file. What it
// answers is checked like any other input. Thread-safe.
#pragma once

#include "engine/assets/image/image_import.h"
#include "engine/assets/image_data.h"
#include "engine/assets/model/model_references.h"
#include "engine/assets/model_data.h"
#include "engine/assets/sound_data.h"
#include "engine/core/process/exit_code.h"
#include "engine/core/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// Which program decodes, and how long it may take.
struct Decoder {
    std::filesystem::path
        program{};  ///< empty: the plumbline beside this program, itself as a rule
    std::optional<double> limit_s{};  ///< of wall time; unset: by the file's size
};

/// As decode_image(), decode_sound() and import_model(). `name` is the file as messages call it. A crash, a
/// hang, a limit that is exceeded: an error that says so.
Result<ImageData> decode_image_apart(std::string_view bytes,
                                     const std::string& name,
                                     const ImageBytesAllowed& allowed,
                                     const Decoder& decoder = {});
Result<SoundData> decode_sound_apart(std::string_view bytes,
                                     const std::string& name,
                                     const Decoder& decoder = {});
/// Collada and FBX.
Result<ModelData> read_foreign_model(std::string_view bytes,
                                     const std::string& name,
                                     ModelReferences& references,
                                     const Decoder& decoder = {});

/// The side of the decoder: `kind` is "image", "sound" or "model"; so many bytes come over the standard
/// input.
ExitCode run_decoder(std::string_view kind, std::size_t file_bytes, const std::string& name);

}  // namespace plumbline::assets
