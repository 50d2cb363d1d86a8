// Recordings: engine/app/controls/action_tape.h. The bytes are bodies of records, each behind its size
// in two bytes; the frame with its checksum is made anew.
#include "engine/app/controls/action_tape.h"
#include "engine/core/hash.h"
#include "tests/fuzz/fuzz_target.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace plumbline::fuzz {
namespace {

using namespace app;

constexpr std::size_t kStartBytes = 12;
constexpr std::size_t kHeadBytes = 16;

const TapeHeader kHeader{.scene = "a.toml",
                         .scene_hash = "0011",
                         .precision = "float32",
                         .step_s = 1.0 / 60.0,
                         .seed = 3};

std::string framed(std::string_view body) {
    Hasher hasher;
    hasher.add(body.data(), body.size());
    auto size = static_cast<std::uint32_t>(body.size());
    std::uint32_t turned = ~size;
    std::uint64_t sum = hasher.digest();
    Archive head;
    head(size, turned, sum);
    return head.take() + std::string(body);
}

/// "PLUMTAPE" and the format, then records.
std::string tape_of(std::string_view bodies) {
    std::string tape("PLUMTAPE\x03\0\0\0", kStartBytes);
    while (bodies.size() >= 2) {
        const auto low = static_cast<std::uint8_t>(bodies[0]);
        const auto high = static_cast<std::uint8_t>(bodies[1]);
        const std::string_view body = bodies.substr(2, low | static_cast<std::size_t>(high) << 8U);
        tape += framed(body);
        bodies.remove_prefix(2 + body.size());
    }
    return tape;
}

std::string bodies_of(std::string_view tape) {
    std::string bodies;
    for (tape.remove_prefix(kStartBytes); !tape.empty();) {
        std::uint32_t size = 0;
        Archive head(tape);
        head(size);
        bodies += static_cast<char>(size & 0xffU);
        bodies += static_cast<char>(size >> 8U);
        bodies += tape.substr(kHeadBytes, size);
        tape.remove_prefix(kHeadBytes + size);
    }
    return bodies;
}

}  // namespace

std::vector<std::string> seeds() {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("fuzz-" + std::to_string(getpid()));
    RandomActions random_input(4);
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 90; ++step) {
        if (step == 70) recorder.add_request(step, "another");
        if (step == 30) recorder.add_request(step, "a request");
        Actions actions = random_input.next();
        if (step > 20) actions.pointer = {0.5F, -0.25F};
        recorder.add_step(step, actions);
        if (step == 59) recorder.add_state(60, {.hash = 7, .steps = {1, 2}, .bodies = {3, 4, 5}});
    }
    if (!recorder.save(file, 90, 8)) std::abort();
    std::ifstream stream(file, std::ios::binary);
    const std::string tape{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove(file);
    return {bodies_of(tape)};
}

}  // namespace plumbline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace plumbline;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as libFuzzer gives them
    const std::string_view bodies(reinterpret_cast<const char*>(data), size);
    Result<app::TapePlayer> player =
        app::TapePlayer::from(fuzz::tape_of(bodies), "mutant.tape", fuzz::kHeader);
    if (!player) return player.error().exit_code == ExitCode::Differs ? 0 : 1;
    fuzz::note_taken();
    for (std::uint64_t step = 0; step < 200 && !player->ended(step); ++step) {
        const app::TapePlayer::Told told = player->step(step);
        for (const float amount : told.actions.amount) {
            if (!(amount >= -1e6F && amount <= 1e6F)) std::abort();
        }
        player->state_after(step + 1);
    }
    return 0;
}
