// Drives a fuzz target with deterministic mutants of its seeds, in a process of its own, so that each
// crash and each hang is named by its number and kept as a file, and the others go on.
//
//     plumbline_fuzz_NAME COUNT [FIRST]     mutants FIRST (0) to FIRST + COUNT - 1
//     plumbline_fuzz_NAME FILE              that file alone, in this process
//
// PLUMBLINE_MUTANTS stands over COUNT.
#include "engine/core/log.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutate.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>

namespace plumbline::fuzz {
namespace {

constexpr unsigned kLongest_s = 20;  // of one mutant
constexpr int kMostFailures = 10;

int feed(const std::string& bytes) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    return LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                  bytes.size());
}

/// Seen by parent and child.
struct Progress {
    std::atomic<std::uint64_t> number{0};  ///< of the mutant that is being read
    std::atomic<std::uint64_t> taken{0};   ///< of the files so far
};
Progress* progress = nullptr;

void share_progress() {
    void* memory =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    progress = new (memory) Progress;
}

std::string ending_of(int status) {
    if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
    return fmt::format("exit code {}", WEXITSTATUS(status));
}

int run(std::uint64_t first, std::uint64_t count, const std::string& name) {
    const std::vector<std::string> files = seeds();
    share_progress();
    for (const std::string& file : files) feed(file);
    if (progress->taken != files.size()) {
        fmt::print("{} of {} seeds of {} are good\n", progress->taken.load(), files.size(), name);
        return 1;
    }
    progress->taken = 0;
    std::atomic<std::uint64_t>& number = progress->number;
    number = first;
    int failures = 0;
    while (number < first + count && failures < kMostFailures) {
        const pid_t child = fork();
        if (child == 0) {
            for (; number < first + count; ++number) {
                alarm(kLongest_s);
                if (feed(mutant(files, number)) != 0) _exit(1);
            }
            std::exit(0);  // leaks are looked for
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child) return 1;
        if (status == 0) break;
        ++failures;
        const std::string kept = fmt::format("mutant-{}-{}", name, number.load());
        std::ofstream(kept, std::ios::binary) << mutant(files, number);
        fmt::print("mutant {} ended with {}: kept as {}\n", number.load(), ending_of(status), kept);
        ++number;
    }
    fmt::print("{} mutants of {} seeds of {}: {} taken as good, {} failures\n",
               number - first,
               files.size(),
               name,
               progress->taken.load(),
               failures);
    return failures == 0 ? 0 : 1;
}

int read_one(const char* file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        fmt::print("{}: cannot be read\n", file);
        return 1;
    }
    return feed({std::istreambuf_iterator<char>(stream), {}});
}

}  // namespace

void note_taken() {
    if (progress != nullptr) ++progress->taken;
}

}  // namespace plumbline::fuzz

int main(int argc, char** argv) {
    plumbline::set_log_level(plumbline::LogLevel::Error);
    const std::string argument = argc > 1 ? argv[1] : "1000";
    if (argument.find_first_not_of("0123456789") != std::string::npos)
        return plumbline::fuzz::read_one(argument.c_str());
    const char* wanted = std::getenv("PLUMBLINE_MUTANTS");
    const std::string path = argv[0];
    const std::string name = path.substr(path.rfind("fuzz_") + 5);
    return plumbline::fuzz::run(argc > 2 ? std::stoull(argv[2]) : 0,
                                std::stoull(wanted != nullptr ? wanted : argument),
                                name);
}
