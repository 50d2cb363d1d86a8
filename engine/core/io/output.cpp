#include "engine/core/io/output.h"

#include "engine/core/io/files.h"
#include "engine/core/io/files_impl.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/process/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

namespace plumbline {
namespace fs = std::filesystem;
namespace {

/// The open descriptor that a name stands for. Opened anew by its name, a file behind it would be
/// written from its beginning.
std::optional<int> descriptor_named(const fs::path& path) {
    const std::string name = path.string();
    if (name == "-" || name == "/dev/stdout") return STDOUT_FILENO;
    if (name == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!name.starts_with(folder)) continue;
        const char* end = name.data() + name.size();
        int number = -1;
        const auto [stop, fault] = std::from_chars(name.data() + folder.size(), end, number);
        if (fault == std::errc{} && stop == end && number >= 0) return number;
    }
    return {};
}

/// Something that is there, links followed, and neither a regular file nor a folder.
bool is_written_through(const fs::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
           !S_ISDIR(status.st_mode);
}

int open_for_writing(const fs::path& path, int flags = 0) {
    constexpr mode_t kMode = 0666;
    while (true) {
        const int file =
            file_calls().open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | flags, kMode);
        if (file >= 0 || errno != EINTR || interrupted()) return file;
    }
}

}  // namespace

bool is_standard_output(const fs::path& path) {
    return descriptor_named(path) == STDOUT_FILENO;
}

bool is_replaced(const fs::path& path) {
    return !path.empty() && !descriptor_named(path) && !is_written_through(path);
}

Result<Done> check_output(const fs::path& path) {
    if (path.empty()) return Done{};
    if (const std::optional<int> number = descriptor_named(path)) {
        if (::fcntl(*number, F_GETFL) < 0) return system_error("cannot write", path);
        return Done{};
    }
    if (!is_written_through(path)) return check_writable(path);
    if (::access(path.c_str(), W_OK) != 0) return system_error("cannot write", path);
    return Done{};
}

Result<Done> make_output_folder(const fs::path& folder, std::initializer_list<const char*> names) {
    if (Result<Done> made = make_folder(folder); !made) return made;
    for (const char* name : names) {
        if (Result<Done> open = check_output(folder / name); !open) return open;
    }
    return Done{};
}

Result<Done> write_output(const fs::path& path, std::string_view bytes) {
    if (const std::optional<int> number = descriptor_named(path)) {
        if (*number == STDOUT_FILENO) {
            if (Result<Done> flushed = flush_standard_output(); !flushed) return flushed;
        }
        if (!write_all(*number, bytes)) return system_error("cannot write", path);
        return Done{};
    }
    if (!is_written_through(path)) return write_file_atomically(path, bytes);
    Descriptor file(open_for_writing(path));
    if (!file.open()) return system_error("cannot open", path);
    if (!write_all(file.number(), bytes)) return system_error("cannot write", path);
    if (!file.close_now()) return system_error("cannot finish", path);
    return Done{};
}

GrowingOutput::~GrowingOutput() {
    if (is_own_) file_calls().close(descriptor_);
}

Result<Done> GrowingOutput::open(const fs::path& path) {
    path_ = path;
    if (const std::optional<int> number = descriptor_named(path)) {
        descriptor_ = *number;
        return *number == STDOUT_FILENO ? flush_standard_output() : Done{};
    }
    descriptor_ = open_for_writing(path, is_written_through(path) ? 0 : O_CREAT | O_TRUNC);
    is_own_ = descriptor_ >= 0;
    if (!is_own_) return system_error("cannot open", path);
    return Done{};
}

Result<Done> GrowingOutput::write(std::string_view bytes) {
    if (descriptor_ < 0 || write_all(descriptor_, bytes)) return Done{};
    return system_error("cannot write", path_);
}

Result<Done> GrowingOutput::close() {
    const bool closes = std::exchange(is_own_, false);
    const int descriptor = std::exchange(descriptor_, -1);
    if (closes && file_calls().close(descriptor) != 0) return system_error("cannot finish", path_);
    return Done{};
}

Result<Done> flush_standard_output() {
    errno = 0;
    std::cout.flush();
    const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
    if (whole || reader_has_gone(STDOUT_FILENO)) return Done{};
    const char* why = errno != 0 ? std::strerror(errno) : "some of it was lost";
    return Error{.message = fmt::format("cannot write to the standard output: {}", why)};
}

}  // namespace plumbline
