#include "engine/core/files.h"

#include "engine/core/files_impl.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

namespace plumbline {
namespace fs = std::filesystem;
namespace {

Error system_error(std::string_view what, const fs::path& path) {
    return {.message = fmt::format("{} {}: {}", what, path.string(), std::strerror(errno))};
}

/// Closes its descriptor when it goes.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) file_calls().close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool open() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Closing may be where a write fails: true when it did not.
    bool close_now() {
        const int number = number_;
        number_ = -1;
        return file_calls().close(number) == 0;
    }

private:
    int number_;
};

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = file_calls().write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// A link stays a link: what it points to is replaced.
fs::path link_target(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) return path;
    const fs::path target = fs::weakly_canonical(path, failed);
    return failed ? path : target;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// How temporary files begin that become `target`: nothing that a person would name a file.
std::string temporary_prefix(const fs::path& target) {
    return "." + target.filename().string() + ".saving-";
}

/// Differs between processes, threads and times, so that two savers never share a file.
std::string unique_name(const std::string& prefix) {
    static std::atomic<unsigned> count{0};
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return fmt::format("{}{}-{}-{}", prefix, ::getpid(), now.tv_nsec, count++);
}

/// Removes what killed programs left of earlier saves. A save takes far less than a minute; older
/// ones are nobody's. Should one be somebody's after all, only that save fails, and says so.
void remove_stale(const fs::path& folder, const std::string& prefix) {
    constexpr std::time_t kLongestSave_s = 60;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().filename().string().rfind(prefix, 0) != 0) continue;
        struct stat status {};
        if (::lstat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
        if (std::time(nullptr) - status.st_mtime > kLongestSave_s) ::unlink(entry->path().c_str());
    }
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
    const fs::path target = link_target(path);
    const std::string prefix = temporary_prefix(target);
    remove_stale(folder_of(target), prefix);

    const fs::path temporary = folder_of(target) / unique_name(prefix);
    Descriptor file(
        file_calls().open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.open()) return system_error("cannot create a file beside", path);
    const auto give_up = [&](std::string_view what) {
        Error error = system_error(what, path);
        ::unlink(temporary.c_str());
        return error;
    };
    if (!write_all(file.number(), bytes)) return give_up("cannot write");
    if (file_calls().sync(file.number()) != 0) return give_up("cannot store");
    if (!file.close_now()) return give_up("cannot finish");
    if (file_calls().rename(temporary.c_str(), target.c_str()) != 0)
        return give_up("cannot replace");
    // From here on the new file stands; whether the folder is stored now or later, it is whole.
    Descriptor folder(
        file_calls().open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0));
    if (folder.open()) file_calls().sync(folder.number());
    return Done{};
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

fs::path user_cache_folder() {
    return user_folder("XDG_CACHE_HOME", ".cache");
}

}  // namespace plumbline
