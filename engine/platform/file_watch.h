// Tells when files changed, by watching their folders (editors save by rename, which ends a watch
// on the file itself).
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

namespace plumbline::platform {

class FileWatch {
public:
    explicit FileWatch(const std::vector<std::filesystem::path>& files);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Files that changed and have been quiet for 150 ms since. Never blocks.
    std::vector<std::filesystem::path> take_changed(double now_s);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::platform
