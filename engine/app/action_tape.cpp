#include "engine/app/action_tape.h"

#include "engine/core/files.h"
#include "engine/core/hash.h"
#include "engine/core/output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace plumbline::app {
namespace {

using nlohmann::json;

constexpr int kFormat = 1;
constexpr std::size_t kTapeBytes = 256ULL * 1024 * 1024;

json to_json(const Actions& actions) {
    json line = json::object();
    json held = json::array();
    json pressed = json::object();
    json amount = json::object();
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const std::string name(action_name(static_cast<Action>(i)));
        if (actions.held[i]) held.push_back(name);
        if (actions.pressed[i] > 0) pressed[name] = actions.pressed[i];
        // A float survives the way through a double's shortest text unchanged.
        if (actions.amount[i] != 0.0F) amount[name] = static_cast<double>(actions.amount[i]);
    }
    if (!held.empty()) line["held"] = held;
    if (!pressed.empty()) line["pressed"] = pressed;
    if (!amount.empty()) line["amount"] = amount;
    if (actions.look_yaw_rad != 0.0F || actions.look_pitch_rad != 0.0F) {
        line["look"] = {static_cast<double>(actions.look_yaw_rad),
                        static_cast<double>(actions.look_pitch_rad)};
    }
    return line;
}

Actions actions_from(const json& line) {
    Actions actions;
    // Named, because a range over a member of a temporary would outlive it.
    const json held = line.value("held", json::array());
    const json pressed = line.value("pressed", json::object());
    const json amounts = line.value("amount", json::object());
    for (const json& name : held) {
        const auto action = action_from_name(name.get<std::string>());
        if (action) actions.held[static_cast<std::size_t>(*action)] = true;
    }
    for (const auto& [name, count] : pressed.items()) {
        const auto action = action_from_name(name);
        if (action) actions.pressed[static_cast<std::size_t>(*action)] = count.get<std::uint8_t>();
    }
    for (const auto& [name, amount] : amounts.items()) {
        const auto action = action_from_name(name);
        if (action) actions.amount[static_cast<std::size_t>(*action)] = amount.get<float>();
    }
    if (line.contains("look")) {
        actions.look_yaw_rad = line.at("look").at(0).get<float>();
        actions.look_pitch_rad = line.at("look").at(1).get<float>();
    }
    return actions;
}

TapeEntry entry_from(const json& line) {
    TapeEntry entry{.step = line.at("n").get<std::uint64_t>()};
    entry.reset = line.value("reset", false);
    entry.end = line.value("end", false);
    if (line.contains("hash"))
        entry.hash = std::stoull(line.at("hash").get<std::string>(), nullptr, 16);
    if (!entry.reset && !entry.hash) entry.actions = actions_from(line);
    return entry;
}

Error refused(const std::filesystem::path& file, const std::string& why) {
    return {.message = fmt::format("{}: {}", file.string(), why), .exit_code = ExitCode::Differs};
}

/// Empty when the two belong together.
std::string difference(const json& header, const TapeHeader& expected) {
    const auto compare =
        [&](const char* what, const std::string& recorded, const std::string& here) {
            if (recorded == here) return std::string();
            return fmt::format("recorded with {} {}, this run has {}", what, recorded, here);
        };
    if (header.value("format", 0) != kFormat) return "not a recording of format 1";
    const std::string scene = header.value("scene", "");
    if (header.value("scene_hash", "") != expected.scene_hash) {
        if (scene == expected.scene)
            return fmt::format("recorded in another version of the scene {}", scene);
        return fmt::format("recorded in the scene {}, this one is {}", scene, expected.scene);
    }
    for (const std::string& found :
         {compare("precision", header.value("precision", ""), expected.precision),
          compare("a step of",
                  fmt::format("{} s", header.value("step_s", 0.0)),
                  fmt::format("{} s", expected.step_s))}) {
        if (!found.empty()) return found;
    }
    return {};
}

}  // namespace

TapeRecorder::TapeRecorder(const TapeHeader& header) {
    const json line = {{"format", kFormat},
                       {"scene", header.scene},
                       {"scene_hash", header.scene_hash},
                       {"precision", header.precision},
                       {"step_s", header.step_s},
                       {"seed", header.seed}};
    // A file's name may be any bytes.
    text_ = line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

void TapeRecorder::add_step(std::uint64_t step, const Actions& actions) {
    json line = to_json(actions);
    if (line.empty()) return;
    line["n"] = step;
    text_ += line.dump() + "\n";
}

void TapeRecorder::add_reset(std::uint64_t step) {
    text_ += json{{"n", step}, {"reset", true}}.dump() + "\n";
}

void TapeRecorder::add_hash(std::uint64_t step, std::uint64_t hash) {
    text_ += json{{"n", step}, {"hash", hex_of(hash)}}.dump() + "\n";
}

Result<Done> TapeRecorder::save(const std::filesystem::path& file,
                                std::uint64_t steps,
                                std::uint64_t hash) const {
    const json last = {{"n", steps}, {"end", true}, {"hash", hex_of(hash)}};
    return write_output(file, text_ + last.dump() + "\n");
}

Result<TapePlayer> TapePlayer::open(const std::filesystem::path& file, const TapeHeader& expected) {
    const Result<std::string> text = read_file(file, kTapeBytes);
    if (!text) return text.error();
    TapePlayer player;
    std::istringstream lines(*text);
    std::string line;
    int number = 0;
    try {
        while (std::getline(lines, line)) {
            ++number;
            const json parsed = json::parse(line);
            if (number == 1) {
                const std::string wrong = difference(parsed, expected);
                if (!wrong.empty()) return refused(file, wrong);
                player.seed_ = parsed.value("seed", std::uint64_t{0});
                continue;
            }
            player.entries_.push_back(entry_from(parsed));
            if (player.entries_.back().end) player.steps_ = player.entries_.back().step;
        }
    } catch (const std::exception& fault) {
        return refused(
            file, fmt::format("line {} is not a line of a recording ({})", number, fault.what()));
    }
    if (player.entries_.empty() || !player.entries_.back().end) {
        return refused(file, "the recording breaks off: its last line is missing");
    }
    return player;
}

Actions TapePlayer::actions_of(std::uint64_t step) {
    while (next_ < entries_.size() && entries_[next_].step < step) ++next_;
    for (std::size_t i = next_; i < entries_.size() && entries_[i].step == step; ++i) {
        if (entries_[i].actions) return *entries_[i].actions;
    }
    return {};
}

bool TapePlayer::reset_before(std::uint64_t step) {
    for (std::size_t i = next_; i < entries_.size() && entries_[i].step <= step; ++i) {
        if (entries_[i].step == step && entries_[i].reset) return true;
    }
    return false;
}

std::optional<std::uint64_t> TapePlayer::hash_after(std::uint64_t steps) const {
    for (std::size_t i = next_; i < entries_.size() && entries_[i].step <= steps; ++i) {
        if (entries_[i].step == steps && entries_[i].hash) return entries_[i].hash;
    }
    return std::nullopt;
}

Actions RandomActions::next() {
    for (std::uint8_t& presses : now_.pressed) presses = 0;
    now_.look_yaw_rad = random_.below(4) == 0 ? random_.uniform(-0.2F, 0.2F) : 0.0F;
    now_.look_pitch_rad = random_.below(4) == 0 ? random_.uniform(-0.1F, 0.1F) : 0.0F;
    for (int change = 0; change < 2; ++change) {
        const std::size_t index = random_.below(static_cast<std::uint32_t>(kActionCount));
        const bool down = !now_.held[index];
        now_.held[index] = down;
        now_.amount[index] = down ? 1.0F : 0.0F;
        if (down) now_.pressed[index] = 1;
    }
    return now_;
}

}  // namespace plumbline::app
