// libFuzzer is given a corpus of the target's seeds where the command line names none: a folder
// corpus-NAME in the working directory.
#include "engine/core/log.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace plumbline::fuzz {
void note_taken() {}
}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    namespace fs = std::filesystem;
    plumbline::set_log_level(plumbline::LogLevel::Error);
    const bool names_some =
        std::any_of(*argv + 1, *argv + *argc, [](const char* word) { return word[0] != '-'; });
    if (names_some) return 0;
    static std::string folder = "corpus-" + fs::path((*argv)[0]).filename().string();
    fs::create_directories(folder);
    int number = 0;
    for (const std::string& seed : plumbline::fuzz::seeds())
        std::ofstream(fs::path(folder) / ("seed-" + std::to_string(number++)), std::ios::binary)
            << seed;
    static std::vector<char*> words(*argv, *argv + *argc);
    words.push_back(folder.data());
    words.push_back(nullptr);
    *argv = words.data();
    ++*argc;
    return 0;
}
