// What another program prints, with limits on how much and how long.
#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

struct ChildOutput {
    std::string bytes;
    std::string end;  ///< empty: it ended well; else "ended with code 3", "was ended by signal 11"
};

/// Runs the program with nothing on its standard input and waits for its end. Its messages go where
/// ours go. The error is for one that cannot be started, prints more than `max_bytes` or takes more
/// than `limit_s`; it is killed then.
Result<ChildOutput> output_of(const std::filesystem::path& program,
                              const std::vector<std::string>& arguments,
                              std::size_t max_bytes,
                              double limit_s);

}  // namespace plumbline
