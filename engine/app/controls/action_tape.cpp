#include "engine/app/controls/action_tape.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/scene/formats/json_read.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace plumbline::app {
namespace {

using nlohmann::json;

constexpr int kFormat = 2;
constexpr int kWholeLines = 1;  // the format before
constexpr std::size_t kTapeBytes = 256ULL * 1024 * 1024;
constexpr double kMostOfAnAmount = 1e6;

std::string text_of(const json& line) {
    // A scene's name need not be UTF-8.
    return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Only what is another than before.
json changes(const Actions& before, const Actions& now) {
    json line = json::object();
    json down = json::array();
    json up = json::array();
    json pressed = json::object();
    json amount = json::object();
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const std::string name(action_name(static_cast<Action>(i)));
        if (now.held[i] != before.held[i]) (now.held[i] ? down : up).push_back(name);
        if (now.pressed[i] > 0) pressed[name] = now.pressed[i];
        // A float survives the way through a double's shortest text unchanged.
        if (now.amount[i] != before.amount[i]) amount[name] = static_cast<double>(now.amount[i]);
    }
    if (!down.empty()) line["down"] = down;
    if (!up.empty()) line["up"] = up;
    if (!pressed.empty()) line["pressed"] = pressed;
    if (!amount.empty()) line["amount"] = amount;
    if (now.look_yaw_rad != 0.0F || now.look_pitch_rad != 0.0F) {
        line["look"] = {static_cast<double>(now.look_yaw_rad),
                        static_cast<double>(now.look_pitch_rad)};
    }
    if (now.pointer != before.pointer) {
        line["pointer"] = nullptr;
        if (now.pointer) {
            line["pointer"] = {static_cast<double>((*now.pointer)[0]),
                               static_cast<double>((*now.pointer)[1])};
        }
    }
    return line;
}

float amount_from(const json& number) {
    const double value = number.get<double>();
    if (!std::isfinite(value) || std::abs(value) > kMostOfAnAmount)
        throw std::runtime_error(fmt::format("{} is no amount", number.dump()));
    return static_cast<float>(value);
}

std::uint8_t presses_from(const json& number) {
    if (!number.is_number_integer() || number < 0 || number > 255)
        throw std::runtime_error(fmt::format("{} is no number of presses", number.dump()));
    return number.get<std::uint8_t>();
}

std::uint64_t step_from(const json& number) {
    if (!number.is_number_unsigned())
        throw std::runtime_error(fmt::format("{} is no step", number.dump()));
    return number.get<std::uint64_t>();
}

template <class Number>
Number hex_from(std::string_view digits) {
    Number value{0};
    const char* end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, value, 16);
    if (digits.empty() || read.ec != std::errc{} || read.ptr != end)
        throw std::runtime_error(fmt::format("\"{}\" is no fingerprint", digits));
    return value;
}

void set_held(Actions& actions, const json& names, bool held) {
    for (const json& name : names) {
        const auto action = action_from_name(name.get<std::string>());
        if (action) actions.held[static_cast<std::size_t>(*action)] = held;
    }
}

/// A line's part over what the step before held.
Actions actions_from(const json& line, int format, const Actions& before) {
    Actions actions;
    if (format != kWholeLines) {
        actions.held = before.held;
        actions.amount = before.amount;
        actions.pointer = before.pointer;
    }
    if (line.contains("held")) set_held(actions, line.at("held"), true);
    if (line.contains("down")) set_held(actions, line.at("down"), true);
    if (line.contains("up")) set_held(actions, line.at("up"), false);
    if (line.contains("pressed")) {
        for (const auto& [name, count] : line.at("pressed").items()) {
            const auto action = action_from_name(name);
            if (action) actions.pressed[static_cast<std::size_t>(*action)] = presses_from(count);
        }
    }
    if (line.contains("amount")) {
        for (const auto& [name, amount] : line.at("amount").items()) {
            const auto action = action_from_name(name);
            if (action) actions.amount[static_cast<std::size_t>(*action)] = amount_from(amount);
        }
    }
    if (line.contains("look")) {
        actions.look_yaw_rad = amount_from(line.at("look").at(0));
        actions.look_pitch_rad = amount_from(line.at("look").at(1));
    }
    if (line.contains("pointer")) {
        const json& pointer = line.at("pointer");
        actions.pointer.reset();
        if (!pointer.is_null())
            actions.pointer = std::array{amount_from(pointer.at(0)), amount_from(pointer.at(1))};
    }
    return actions;
}

std::string digits_of(const std::vector<std::uint32_t>& steps) {
    std::string digits;
    for (const std::uint32_t step : steps) digits += fmt::format("{:08x}", step);
    return digits;
}

std::vector<std::uint32_t> steps_from(const std::string& digits) {
    std::vector<std::uint32_t> steps;
    for (std::size_t at = 0; at < digits.size(); at += 8)
        steps.push_back(hex_from<std::uint32_t>(std::string_view(digits).substr(at, 8)));
    return steps;
}

/// "3:0a1f 17:ffff": into the bodies, which are as many as the line says.
void take_bodies(const std::string& changed, std::vector<std::uint16_t>& bodies) {
    std::size_t at = 0;
    while (at < changed.size()) {
        const std::size_t end = std::min(changed.find(' ', at), changed.size());
        const std::string_view entry = std::string_view(changed).substr(at, end - at);
        const std::size_t colon = entry.find(':');
        std::size_t index = 0;
        const auto read =
            std::from_chars(entry.data(), entry.data() + std::min(colon, entry.size()), index);
        if (colon == std::string_view::npos || read.ec != std::errc{} || index >= bodies.size())
            throw std::runtime_error(fmt::format("\"{}\" is no body's fingerprint", entry));
        bodies[index] = hex_from<std::uint16_t>(entry.substr(colon + 1));
        at = end + 1;
    }
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
    const int format = header.value("format", 0);
    if (format > kFormat)
        return fmt::format(
            "a recording of format {}; this program reads up to {}", format, kFormat);
    if (format < kWholeLines) return "not a recording";
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

std::string sum_of(std::string_view text) {
    Hasher hasher;
    hasher.add(text.data(), text.size());
    return hex_of(hasher.digest());
}

}  // namespace

TapeRecorder::TapeRecorder(const TapeHeader& header, std::size_t most_bytes)
    : spool_(std::tmpfile()), most_bytes_(most_bytes) {
    if (!spool_) failed_ = fmt::format("no temporary file to record in: {}", std::strerror(errno));
    add_line(text_of({{"format", kFormat},
                      {"scene", header.scene},
                      {"scene_hash", header.scene_hash},
                      {"precision", header.precision},
                      {"step_s", header.step_s},
                      {"seed", header.seed}}));
}

void TapeRecorder::add_line(const std::string& line) {
    if (!failed_.empty() || full_) return;
    const bool written = std::fwrite(line.data(), 1, line.size(), spool_.get()) == line.size() &&
                         std::fputc('\n', spool_.get()) != EOF;
    if (!written) {
        failed_ = fmt::format("the recording could not be kept: {}", std::strerror(errno));
        log_warning("{}", failed_);
    }
    bytes_ += line.size() + 1;
}

void TapeRecorder::add_step(std::uint64_t step, const Actions& actions) {
    json line = changes(before_, actions);
    before_ = actions;
    if (line.empty()) return;
    line["n"] = step;
    add_line(text_of(line));
}

void TapeRecorder::add_reset(std::uint64_t step) {
    add_line(text_of({{"n", step}, {"reset", true}}));
}

void TapeRecorder::add_state(std::uint64_t steps, const TapeState& state) {
    std::string bodies;
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
        if (i < bodies_.size() && bodies_[i] == state.bodies[i]) continue;
        bodies += fmt::format("{}{}:{:04x}", bodies.empty() ? "" : " ", i, state.bodies[i]);
    }
    json line = {{"n", steps}, {"hash", hex_of(state.hash)}, {"steps", digits_of(state.steps)}};
    line["count"] = state.bodies.size();
    if (!bodies.empty()) line["bodies"] = bodies;
    add_line(text_of(line));
    if (full_) return;
    bodies_ = state.bodies;
    state_after_ = steps;
    state_hash_ = state.hash;
    if (bytes_ < most_bytes_) return;
    full_ = true;
    log_warning("the recording is full: it ends after {} steps", steps);
}

Result<Done> TapeRecorder::save(const std::filesystem::path& file,
                                std::uint64_t steps,
                                std::uint64_t hash) {
    if (!failed_.empty()) return Error{.message = fmt::format("{}: {}", file.string(), failed_)};
    std::string text(bytes_, '\0');
    std::rewind(spool_.get());
    const bool read = std::fread(text.data(), 1, text.size(), spool_.get()) == text.size();
    if (std::fseek(spool_.get(), 0, SEEK_END) != 0 || !read)
        return Error{.message = fmt::format("{}: the recording cannot be read back: {}",
                                            file.string(),
                                            std::strerror(errno))};
    const json last = {{"n", full_ ? state_after_ : steps},
                       {"end", true},
                       {"hash", hex_of(full_ ? state_hash_ : hash)},
                       {"sum", sum_of(text)}};
    return write_output(file, fmt::format("{}{}\n", text, text_of(last)));
}

struct TapePlayer::Line {
    json content;
    std::size_t begin{0};
    std::uint64_t step{0};
    bool reset{false};
    bool end{false};
    bool has_state{false};
};

TapePlayer::TapePlayer() = default;
TapePlayer::~TapePlayer() = default;
TapePlayer::TapePlayer(TapePlayer&&) noexcept = default;
TapePlayer& TapePlayer::operator=(TapePlayer&&) noexcept = default;

const TapePlayer::Line* TapePlayer::next() {
    if (next_ || at_ >= text_.size()) return next_.get();
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    auto line = std::make_unique<Line>();
    line->begin = at_;
    line->content = scene::read_json<json>(std::string_view(text_).substr(at_, end - at_));
    line->step = step_from(line->content.at("n"));
    line->reset = line->content.value("reset", false);
    line->end = line->content.value("end", false);
    line->has_state = line->content.contains("hash");
    at_ = std::min(end + 1, text_.size());
    next_ = std::move(line);
    return next_.get();
}

TapeState TapePlayer::state_of(const Line& line) {
    constexpr std::size_t kMostBodies = 1'000'000;
    TapeState state{.hash = hex_from<std::uint64_t>(line.content.at("hash").get<std::string>())};
    if (!line.content.contains("steps")) return state;
    state.steps = steps_from(line.content.at("steps").get<std::string>());
    bodies_.resize(std::min(kMostBodies, step_from(line.content.at("count"))));
    take_bodies(line.content.value("bodies", ""), bodies_);
    state.bodies = bodies_;
    return state;
}

Result<TapePlayer> TapePlayer::open(const std::filesystem::path& file, const TapeHeader& expected) {
    Result<std::string> text = read_file(file, kTapeBytes);
    if (!text) return text.error();
    TapePlayer player;
    player.text_ = std::move(*text);
    int number = 1;
    bool ended = false;
    try {
        const std::size_t end = std::min(player.text_.find('\n'), player.text_.size());
        const json header = scene::read_json<json>(std::string_view(player.text_).substr(0, end));
        const std::string wrong = difference(header, expected);
        if (!wrong.empty()) return refused(file, wrong);
        player.format_ = header.at("format").get<int>();
        player.seed_ = header.value("seed", std::uint64_t{0});
        const std::size_t first = std::min(end + 1, player.text_.size());
        // Every line once, so that play meets none that it cannot read.
        player.at_ = first;
        number = 2;
        for (const Line* line = player.next(); line != nullptr; ++number, line = player.next()) {
            if (ended) throw std::runtime_error("it is behind the end");
            if (line->step < player.steps_) throw std::runtime_error("its steps run backwards");
            player.steps_ = line->step;
            ended = line->end;
            if (ended && line->content.contains("sum") &&
                line->content.at("sum") !=
                    sum_of(std::string_view(player.text_).substr(0, line->begin)))
                return refused(file,
                               "the recording is damaged: its lines are not those it was "
                               "ended with");
            if (line->has_state)
                player.state_of(*line);
            else
                actions_from(line->content, player.format_, {});
            player.next_.reset();
        }
        player.at_ = first;
        player.bodies_.clear();
    } catch (const std::exception& fault) {
        return refused(
            file, fmt::format("line {} is not a line of a recording ({})", number, fault.what()));
    }
    if (!ended) return refused(file, "the recording breaks off: its last line is missing");
    return player;
}

TapePlayer::Told TapePlayer::step(std::uint64_t step) {
    Told told{.actions = actions_from(json::object(), format_, now_)};
    while (const Line* line = next()) {
        if (line->step > step || (line->step == step && line->end)) break;
        if (line->has_state)
            state_of(*line);
        else if (line->reset)
            told.reset = line->step == step;
        else
            told.actions = actions_from(line->content, format_, now_);
        next_.reset();
    }
    now_ = told.actions;
    return told;
}

std::optional<TapeState> TapePlayer::state_after(std::uint64_t steps) {
    std::optional<TapeState> found;
    while (const Line* line = next()) {
        if (!line->has_state || line->step > steps) break;
        TapeState state = state_of(*line);
        if (line->step == steps && !found) found = std::move(state);
        next_.reset();
    }
    return found;
}

}  // namespace plumbline::app
