// Private: the system calls that core/files makes, as a table, so that tests can let any one of
// them fail (tests/engine/core/files_faults_test.cpp). The program never changes the table.
#pragma once

#include <sys/types.h>

#include <cstddef>

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

}  // namespace plumbline
