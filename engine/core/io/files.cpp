#include "engine/core/io/files.h"

#include "engine/core/io/files_impl.h"
#include "engine/core/process/interrupt.h"
#include "engine/core/process/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace plumbline {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// How files begin that are being written. Short, so that any name that the system takes can be
/// saved under; nothing that a person would name a file.
constexpr std::string_view kTemporaryPrefix = ".plumbline-saving-";

/// Differs between processes, threads and times, so that two savers never share a file.
std::string temporary_name() {
    static std::atomic<unsigned> count{0};
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return fmt::format("{}{}-{}-{}", kTemporaryPrefix, ::getpid(), now.tv_nsec, count++);
}

/// Where a save goes, and what is there now.
struct Target {
    fs::path path;  ///< links followed: a link stays a link, what it points to is replaced
    bool exists{false};
    struct stat status {};
};

/// Refuses what a rename would destroy: folders, devices, FIFOs, and files that may not be written.
Result<Target> find_target(const fs::path& path) {
    Target target{.path = path};
    struct stat link {};
    if (::lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
        std::error_code failed;
        target.path = fs::weakly_canonical(path, failed);
        if (failed) errno = failed.value();
        if (failed) return system_error("cannot write", path);
    }
    target.exists = ::stat(path.c_str(), &target.status) == 0;
    if (!target.exists && errno != ENOENT) return system_error("cannot write", path);
    if (!target.exists) return target;
    if (S_ISDIR(target.status.st_mode)) errno = EISDIR;
    if (S_ISDIR(target.status.st_mode)) return system_error("cannot write", path);
    if (!S_ISREG(target.status.st_mode))
        return Error{.message = fmt::format("{} is not a regular file", path.string())};
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        return system_error("cannot write", path);
    return target;
}

/// Gives the new file the old one's owner, as far as the system lets us, and mode. A group that it
/// could not get is given no rights.
bool take_over_owner_and_mode(int file, const struct stat& old) {
    const bool owned = ::fchown(file, old.st_uid, old.st_gid) == 0 ||
                       ::fchown(file, static_cast<uid_t>(-1), old.st_gid) == 0;
    const mode_t mode = old.st_mode & (owned ? mode_t{07777} : mode_t{0707});
    return ::fchmod(file, mode) == 0;
}

/// A new empty file in the folder of `target`: its descriptor and its path.
int open_temporary(const Target& target, fs::path& temporary, const fs::path& ending = {}) {
    temporary = folder_of(target.path) / temporary_name();
    temporary += ending;
    const mode_t mode = target.exists ? 0600 : 0666;
    return file_calls().open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

/// Why the old file stands; the temporary one is gone.
Error give_up(std::string_view what, const fs::path& path, const fs::path& temporary) {
    Error error = system_error(what, path);
    ::unlink(temporary.c_str());
    return error;
}

/// Stores the temporary file and puts it in the target's place.
Result<Done> put_in_place(Descriptor& file,
                          const fs::path& temporary,
                          const Target& target,
                          const fs::path& path) {
    if (file_calls().sync(file.number()) != 0) return give_up("cannot store", path, temporary);
    if (!file.close_now()) return give_up("cannot finish", path, temporary);
    if (file_calls().rename(temporary.c_str(), target.path.c_str()) != 0)
        return give_up("cannot replace", path, temporary);
    // From here on the new file stands; whether the folder is stored now or later, it is whole.
    Descriptor folder(
        file_calls().open(folder_of(target.path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0));
    if (folder.open()) file_calls().sync(folder.number());
    return Done{};
}

/// Whether the process that named a temporary file still runs, as far as can be seen from here.
bool is_at_work(std::string_view temporary) {
    temporary.remove_prefix(kTemporaryPrefix.size());
    pid_t process = 0;
    std::from_chars(temporary.data(), temporary.data() + temporary.size(), process);
    return process_runs(process);
}

bool is_data_root(const fs::path& root) {
    std::error_code ignored;
    return fs::is_directory(root / "assets", ignored) &&
           fs::is_directory(root / "shaders", ignored) &&
           fs::is_directory(root / "config", ignored);
}

/// An absolute path from the environment; relative and empty values count as unset.
fs::path absolute_from_environment(const char* name) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value != '/') return {};
    return value;
}

fs::path user_folder(const char* variable, const char* below_home) {
    fs::path base = absolute_from_environment(variable);
    if (base.empty()) {
        const fs::path home = absolute_from_environment("HOME");
        if (home.empty()) return {};
        base = home / below_home;
    }
    return base / "plumbline";
}

}  // namespace

Error system_error(std::string_view what, const fs::path& path) {
    return {.message = fmt::format("{} {}: {}", what, path.string(), std::strerror(errno))};
}

bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = file_calls().write(file, bytes.data(), bytes.size());
        // A pipe that nobody reads keeps a program waiting; Ctrl-C ends that.
        if (written < 0 && errno == EINTR && !interrupted()) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

FileCalls& file_calls() {
    static FileCalls calls{
        .open = [](const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); },
        .read = ::read,
        .write = ::write,
        .sync = ::fsync,
        .close = ::close,
        .rename = std::rename};
    return calls;
}

Result<DataFolders> find_data_folders() {
    const auto folders_below = [](const fs::path& root) {
        return DataFolders{
            .assets = root / "assets", .shaders = root / "shaders", .config = root / "config"};
    };
    // Who names a folder means that one: another in its place would hide the mistake.
    const fs::path named = absolute_from_environment("PLUMBLINE_DATA");
    if (!named.empty()) {
        if (is_data_root(named)) return folders_below(named);
        return Error{.message = fmt::format(
                         "PLUMBLINE_DATA (or --data) names {}, which does not hold the program's "
                         "data: assets, shaders and config",
                         named.string())};
    }
    std::vector<fs::path> candidates;
    std::error_code failed;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
    if (!failed) {
        candidates.push_back(folder.parent_path() / "share" / "plumbline");  // installed
        for (fs::path above = folder; above.has_relative_path(); above = above.parent_path())
            candidates.push_back(above);  // in a build folder
    }
    std::string tried;
    for (const fs::path& root : candidates) {
        if (is_data_root(root)) return folders_below(root);
        tried += "\n  " + root.string();
    }
    return Error{.message = "the program's data (assets, shaders, config) is in none of:" + tried +
                            "\nname its folder with --data or PLUMBLINE_DATA"};
}

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
    // Non-blocking, so that opening a FIFO cannot hang.
    Descriptor file(file_calls().open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK, 0));
    if (!file.open()) return system_error("cannot open", path);
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) return system_error("cannot examine", path);
    if (!S_ISREG(status.st_mode)) {
        return Error{.message = fmt::format("{} is not a regular file", path.string())};
    }
    if (static_cast<std::size_t>(status.st_size) > max_bytes) {
        return Error{
            .message = fmt::format(
                "{} has {} bytes; at most {} are read", path.string(), status.st_size, max_bytes)};
    }
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got =
            file_calls().read(file.number(), bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return system_error("cannot read", path);
        if (got == 0) break;  // shortened while we read: what is there counts
        done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
}

Result<Done> write_file_atomically(const fs::path& path, std::string_view bytes) {
    const Result<Target> target = find_target(path);
    if (!target) return target.error();
    remove_stale_saves(folder_of(target->path));

    fs::path temporary;
    Descriptor file(open_temporary(*target, temporary));
    if (!file.open()) return system_error("cannot create a file beside", path);
    if (target->exists && !take_over_owner_and_mode(file.number(), target->status))
        return give_up("cannot keep the mode of", path, temporary);
    if (!write_all(file.number(), bytes)) return give_up("cannot write", path, temporary);
    return put_in_place(file, temporary, *target, path);
}

Result<fs::path> make_file_beside(const fs::path& path) {
    const Result<Target> target = find_target(path);
    if (!target) return target.error();
    remove_stale_saves(folder_of(target->path));
    fs::path temporary;
    const Descriptor file(open_temporary(*target, temporary, target->path.extension()));
    if (!file.open()) return system_error("cannot create a file beside", path);
    if (target->exists && !take_over_owner_and_mode(file.number(), target->status))
        return give_up("cannot keep the mode of", path, temporary);
    return temporary;
}

Result<Done> replace_by(const fs::path& path, const fs::path& temporary) {
    const Result<Target> target = find_target(path);
    if (!target) return target.error();
    Descriptor file(file_calls().open(temporary.c_str(), O_RDONLY | O_CLOEXEC, 0));
    if (!file.open()) return give_up("cannot open", path, temporary);
    return put_in_place(file, temporary, *target, path);
}

Result<Done> make_folder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (!failed) return Done{};
    return Error{
        .message = fmt::format("cannot make the folder {}: {}", folder.string(), failed.message())};
}

Result<Done> write_file_and_folder(const fs::path& path, std::string_view bytes) {
    if (const Result<Done> made = make_folder(folder_of(path)); !made) return made;
    return write_file_atomically(path, bytes);
}

Result<Done> check_writable(const fs::path& path) {
    const Result<Target> target = find_target(path);
    if (!target) return target.error();
    fs::path temporary;
    const Descriptor file(open_temporary(*target, temporary));
    if (!file.open()) return system_error("cannot create a file beside", path);
    ::unlink(temporary.c_str());
    return Done{};
}

void remove_stale_saves(const fs::path& folder) {
    constexpr std::time_t kLongestSave_s = 60;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(kTemporaryPrefix) || is_at_work(name)) continue;
        struct stat status {};
        if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
        if (std::time(nullptr) - status.st_mtime > kLongestSave_s) ::unlink(entry->path().c_str());
    }
}

void remove_stale_saves_below(const fs::path& folder) {
    remove_stale_saves(folder);
    std::error_code failed;
    for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        std::error_code ignored;
        if (entry->is_directory(ignored) && !entry->is_symlink(ignored))
            remove_stale_saves(entry->path());
    }
}

bool is_inside(const fs::path& root, const fs::path& path) {
    std::error_code failed;
    // Made absolute first: a relative path to nothing would stay relative, and an empty one means
    // the current folder.
    const fs::path here = fs::current_path(failed);
    if (failed) return false;
    const fs::path real_root = fs::weakly_canonical(here / root, failed);
    if (failed) return false;
    const fs::path real_path = fs::weakly_canonical(here / path, failed);
    if (failed) return false;
    const fs::path relative = real_path.lexically_relative(real_root);
    return !relative.empty() && *relative.begin() != "..";
}

Result<fs::path> resolve_inside(const fs::path& root, std::string_view reference) {
    const auto refuse = [&](std::string_view why) {
        return Error{.message = fmt::format("\"{}\" {}", reference, why),
                     .exit_code = ExitCode::Refused};
    };
    if (reference.empty()) return refuse("names no file");
    if (reference.find('\0') != std::string_view::npos) return refuse("holds a NUL byte");
    if (reference.front() == '/' || reference.front() == '\\') {
        return refuse("is absolute; paths are relative");
    }
    const std::size_t colon = reference.find(':');
    if (colon != std::string_view::npos)
        return refuse("names a drive or a URL; paths are relative");
    const fs::path relative{std::string(reference)};
    int depth = 0;
    for (const fs::path& part : relative) {
        if (part == "..")
            --depth;
        else if (part != "." && !part.empty())
            ++depth;
        if (depth < 0) return refuse("leads out of its folder");
    }
    const fs::path full = root / relative.lexically_normal();
    if (!is_inside(root, full)) return refuse("leads out of its folder through a link");
    return full;
}

fs::path user_config_folder() {
    return user_folder("XDG_CONFIG_HOME", ".config");
}

fs::path user_data_folder() {
    return user_folder("XDG_DATA_HOME", ".local/share");
}

fs::path user_state_folder() {
    return user_folder("XDG_STATE_HOME", ".local/state");
}

fs::path user_cache_folder() {
    return user_folder("XDG_CACHE_HOME", ".cache");
}

}  // namespace plumbline
