// What a person names on the command line to be written: a file, a device, a pipe, or "-" for the
// standard output. Files are replaced atomically; the others are written straight through.
#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace plumbline {

/// "-", or another name of the standard output.
bool is_standard_output(const std::filesystem::path& path);

/// Whether write_output can be expected to work, for before the work whose result it keeps. Changes
/// nothing, and opens no device and no pipe. An empty path is fine: nothing will be written.
Result<Done> check_output(const std::filesystem::path& path);

/// Whether `path` names a file that is replaced, or made: no device, no pipe, not the standard output.
bool is_replaced(const std::filesystem::path& path);

/// Makes `folder`, and checks that files of these names can be written there.
Result<Done> make_output_folder(const std::filesystem::path& folder,
                                std::initializer_list<const char*> names);

/// Waits for a reader where `path` is a FIFO; Ctrl-C ends that.
Result<Done> write_output(const std::filesystem::path& path, std::string_view bytes);

/// An output that grows as its bytes come: a log, good up to wherever the program ends. What is there is
/// written over in place, with its mode and its links.
class GrowingOutput {
public:
    GrowingOutput() = default;
    ~GrowingOutput();
    GrowingOutput(const GrowingOutput&) = delete;
    GrowingOutput& operator=(const GrowingOutput&) = delete;

    /// Waits for a reader where `path` is a FIFO; Ctrl-C ends that.
    Result<Done> open(const std::filesystem::path& path);
    /// Out at once. Nothing where nothing was opened.
    Result<Done> write(std::string_view bytes);
    /// Closing may be where a write fails.
    Result<Done> close();

private:
    std::filesystem::path path_;
    int descriptor_{-1};
    bool is_own_{false};  ///< opened here, so closed here
};

/// What std::cout still holds, out. The error when anything of it was lost, also earlier.
Result<Done> flush_standard_output();

}  // namespace plumbline
