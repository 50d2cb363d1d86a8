// Private to core/io/files and core/io/output: the system calls that they make, as a table, so that tests
// can let any one of them fail (tests/engine/core/io/files_faults_test.cpp), and what both are made of.
// The program never changes the table.
#pragma once

#include "engine/core/result.h"

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace plumbline {

/// Each behaves as the call of its name: -1 and errno on failure.
struct FileCalls {
    int (*open)(const char* path, int flags, mode_t mode);
    ssize_t (*read)(int file, void* bytes, std::size_t count);
    ssize_t (*write)(int file, const void* bytes, std::size_t count);
    int (*sync)(int file);
    int (*close)(int file);
    int (*rename)(const char* from, const char* to);
};

/// The table in use. Not thread-safe to change.
FileCalls& file_calls();

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

/// False, with errno, when not every byte could be written; EINTR after Ctrl-C.
bool write_all(int file, std::string_view bytes);

/// Whether write_file_atomically would work now, tried out. Leaves everything as it is.
Result<Done> check_writable(const std::filesystem::path& path);

/// "`what` /the/path: " and what errno means.
Error system_error(std::string_view what, const std::filesystem::path& path);

}  // namespace plumbline
