#include "engine/app/controls/action_tape.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"
#include "engine/core/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace plumbline::app {
namespace {

constexpr std::string_view kMagic = "PLUMTAPE";
constexpr std::uint32_t kFormat = 3;
constexpr std::size_t kStartBytes = kMagic.size() + sizeof(kFormat);
constexpr std::size_t kHeadBytes = 4 + 4 + 8;  // of a record
constexpr std::size_t kTapeBytes = 256ULL * 1024 * 1024;
constexpr float kMostOfAnAmount = 1e6F;

}  // namespace

enum class TapeKind : std::uint8_t { Header, Step, Requested, State, End };
constexpr TapeKind last_of(TapeKind) {
    return TapeKind::End;
}

struct TapeRecord {
    TapeKind kind{TapeKind::Step};
    std::uint64_t step{0};  ///< the one that is told; how many there were before a state or the end

    TapeHeader header{};
    std::string action_names{};  ///< with a space behind each, in the order of their numbers

    /// An action that was pressed, or is another than in the step before.
    struct Change {
        std::uint8_t action{0};
        bool held{false};
        std::uint8_t pressed{0};
        float amount{0};

        void serialize(Archive& archive) { archive(action, held, pressed, amount); }
    };
    std::vector<Change> changes{};
    std::array<float, 2> look_rad{};  ///< yaw, pitch
    std::optional<std::array<float, 2>> pointer{};

    std::string request{};
    TapeState state{};  ///< of the end: the hash alone

    void serialize(Archive& archive) {
        archive(kind, step);
        switch (kind) {
            case TapeKind::Header:
                return archive(header, action_names);
            case TapeKind::Step:
                return archive(changes, look_rad, pointer);
            case TapeKind::Requested:
                return archive(request);
            case TapeKind::State:
                return archive(state);
            case TapeKind::End:
                return archive(state.hash);
        }
    }
    /// How many steps are known once this is.
    std::uint64_t steps() const { return step + (kind == TapeKind::Step ? 1 : 0); }
};

namespace {

std::uint64_t sum_of(std::string_view bytes) {
    Hasher hasher;
    hasher.add(bytes.data(), bytes.size());
    return hasher.digest();
}

std::string framed(TapeRecord record) {
    Archive body;
    body(record);
    auto size = static_cast<std::uint32_t>(body.written().size());
    std::uint32_t turned = ~size;
    std::uint64_t sum = sum_of(body.written());
    Archive head;
    head(size, turned, sum);
    return head.written() + body.written();
}

std::string beginning(const TapeHeader& header) {
    TapeRecord record{.kind = TapeKind::Header, .header = header};
    for (std::size_t i = 0; i < kActionCount; ++i)
        record.action_names += fmt::format("{} ", action_name(static_cast<Action>(i)));
    Archive format;
    std::uint32_t number = kFormat;
    format(number);
    return std::string(kMagic) + format.written() + framed(std::move(record));
}

/// Only what is another than before.
TapeRecord changes(std::uint64_t step, const Actions& before, const Actions& now) {
    TapeRecord record{
        .step = step, .look_rad = {now.look_yaw_rad, now.look_pitch_rad}, .pointer = now.pointer};
    for (std::size_t i = 0; i < kActionCount; ++i) {
        if (now.held[i] == before.held[i] && now.amount[i] == before.amount[i] &&
            now.pressed[i] == 0)
            continue;
        record.changes.push_back({.action = static_cast<std::uint8_t>(i),
                                  .held = now.held[i],
                                  .pressed = now.pressed[i],
                                  .amount = now.amount[i]});
    }
    return record;
}

bool is_possible(float amount) {
    return std::abs(amount) <= kMostOfAnAmount;
}

/// Why a record cannot be; empty: it can.
std::string fault_of(const TapeRecord& record, std::size_t actions) {
    for (const TapeRecord::Change& change : record.changes) {
        if (change.action >= actions) return fmt::format("there is no action {}", change.action);
        if (!is_possible(change.amount)) return fmt::format("{} is no amount", change.amount);
    }
    for (const float angle : record.look_rad) {
        if (!is_possible(angle)) return fmt::format("{} is no angle", angle);
    }
    if (record.pointer && !std::ranges::all_of(*record.pointer, is_possible))
        return "there is no such place of a pointer";
    return {};
}

/// Empty when the two belong together.
std::string difference(const TapeHeader& recorded, const TapeHeader& expected) {
    const std::string scene = printable(recorded.scene);
    if (recorded.scene_hash != expected.scene_hash) {
        if (recorded.scene == expected.scene)
            return fmt::format("recorded in another version of the scene {}", scene);
        return fmt::format("recorded in the scene {}, this one is {}", scene, expected.scene);
    }
    if (recorded.precision != expected.precision)
        return fmt::format("recorded with precision {}, this run has {}",
                           printable(recorded.precision),
                           expected.precision);
    if (recorded.step_s != expected.step_s)
        return fmt::format("recorded with a step of {} s, this run has a step of {} s",
                           recorded.step_s,
                           expected.step_s);
    return {};
}

}  // namespace

// --- recording ----------------------------------------------------------------------------------

TapeRecorder::TapeRecorder(TapeHeader header, std::filesystem::path file, std::size_t most_bytes)
    : header_(std::move(header)), file_(std::move(file)), most_bytes_(most_bytes) {
    if (!is_replaced(file_)) file_.clear();
}

void TapeRecorder::fail() {
    fault_ = fmt::format("the recording could not be kept: {}", std::strerror(errno));
    log_warning("{}", fault_);
}

bool TapeRecorder::open() {
    if (out_ || !fault_.empty()) return fault_.empty();
    out_.reset(file_.empty() ? std::tmpfile() : std::fopen(file_.c_str(), "w+be"));
    if (out_)
        add(beginning(header_));
    else
        fail();
    return fault_.empty();
}

void TapeRecorder::add(const std::string& record) {
    if (full_ || !open()) return;
    // Flushed: nothing that a step was told is lost with the program.
    const bool written =
        std::fwrite(record.data(), 1, record.size(), out_.get()) == record.size() &&
        std::fflush(out_.get()) == 0;
    if (!written) fail();
    bytes_ += record.size();
}

void TapeRecorder::add_step(std::uint64_t step, const Actions& actions) {
    const TapeRecord record = changes(step, before_, actions);
    const bool says_something = !record.changes.empty() || record.pointer != before_.pointer ||
                                record.look_rad != std::array{0.0F, 0.0F};
    before_ = actions;
    if (says_something) add(framed(record));
}

void TapeRecorder::add_request(std::uint64_t step, std::string request) {
    add(framed({.kind = TapeKind::Requested, .step = step, .request = std::move(request)}));
}

void TapeRecorder::add_state(std::uint64_t steps, TapeState state) {
    if (full_) return;
    state_after_ = steps;
    state_hash_ = state.hash;
    add(framed({.kind = TapeKind::State, .step = steps, .state = std::move(state)}));
    if (bytes_ < most_bytes_) return;
    full_ = true;
    log_warning("the recording is full: it ends after {} steps", steps);
}

Result<Done> TapeRecorder::save(const std::filesystem::path& file,
                                std::uint64_t steps,
                                std::uint64_t hash) {
    const auto fault = [&](const std::string& why) {
        return Error{.message = fmt::format("{}: {}", file.string(), why)};
    };
    if (!open()) return fault(fault_);
    const std::string end = framed({.kind = TapeKind::End,
                                    .step = full_ ? state_after_ : steps,
                                    .state = {.hash = full_ ? state_hash_ : hash}});
    if (file == file_) {
        full_ = false;
        add(end);
        out_.reset();
        if (!fault_.empty()) return fault(fault_);
        fault_ = "the recording has ended";
        return Done{};
    }
    std::string text(bytes_, '\0');
    std::rewind(out_.get());
    const bool read = std::fread(text.data(), 1, text.size(), out_.get()) == text.size();
    if (std::fseek(out_.get(), 0, SEEK_END) != 0 || !read)
        return fault(fmt::format("the recording cannot be read back: {}", std::strerror(errno)));
    return write_output(file, text + end);
}

// --- playing ------------------------------------------------------------------------------------

Result<TapePlayer> TapePlayer::open(const std::filesystem::path& file, const TapeHeader& expected) {
    Result<std::string> bytes = read_file(file, kTapeBytes);
    if (!bytes) return bytes.error();
    return from(std::move(*bytes), file, expected);
}

Result<TapePlayer> TapePlayer::from(std::string bytes,
                                    const std::filesystem::path& file,
                                    const TapeHeader& expected) {
    TapePlayer player;
    player.bytes_ = std::move(bytes);
    std::string fault = player.read_header(expected);
    if (fault.empty()) fault = player.read_all();
    if (!fault.empty())
        return Error{fmt::format("{}: {}", file.string(), fault), ExitCode::Differs};
    return player;
}

/// Nothing where the bytes end, or with a fault.
std::optional<TapeRecord> TapePlayer::peek(std::size_t& next, std::string& fault) const {
    const std::string_view left = std::string_view(bytes_).substr(at_);
    if (left.size() < kHeadBytes) return {};
    std::uint32_t size = 0;
    std::uint32_t turned = 0;
    std::uint64_t sum = 0;
    Archive head(left.substr(0, kHeadBytes));
    head(size, turned, sum);
    const std::string_view body = left.substr(kHeadBytes, size);
    TapeRecord record;
    Archive fields(body);
    if (size != ~turned) {
        fault = "its size is damaged";
    } else if (body.size() == size && sum_of(body) != sum) {
        fault =
            fmt::format("its checksum is {}, it should be {}", hex_of(sum_of(body)), hex_of(sum));
    } else if (body.size() == size) {
        fields(record);
        fault = fields.left() > 0 ? "it goes on after its end" : fields.fault();
        if (fault.empty()) fault = fault_of(record, actions_.size());
    }
    next = at_ + kHeadBytes + size;
    if (!fault.empty())
        fault = fmt::format("a damaged recording: the record at byte {}: {}", at_, fault);
    if (body.size() < size || !fault.empty()) return {};
    return record;
}

std::string TapePlayer::read_header(const TapeHeader& expected) {
    if (bytes_.starts_with('{'))
        return "a recording of an earlier version, which this program does not read";
    if (!bytes_.starts_with(kMagic))
        return fmt::format("not a recording: it does not begin with \"{}\"", kMagic);
    std::uint32_t format = 0;
    Archive start(std::string_view(bytes_).substr(kMagic.size()));
    start(format);
    if (format != kFormat)
        return fmt::format(
            "a recording of format {}; this program reads format {}", format, kFormat);
    at_ = kStartBytes;
    std::string fault;
    std::size_t next = at_;
    const std::optional<TapeRecord> record = peek(next, fault);
    at_ = next;
    if (!fault.empty()) return fault;
    if (!record || record->kind != TapeKind::Header) return "the recording has no header";
    const std::string& names = record->action_names;
    for (std::size_t begin = 0, end = names.find(' '); end != std::string::npos;
         begin = end + 1, end = names.find(' ', begin))
        actions_.push_back(action_from_name(std::string_view(names).substr(begin, end - begin)));
    seed_ = record->header.seed;
    return difference(record->header, expected);
}

/// Every record once, so that play meets none that it cannot read.
std::string TapePlayer::read_all() {
    const std::size_t first = at_;
    std::string fault;
    for (std::size_t next = at_; auto record = peek(next, fault); at_ = next) {
        if (whole_) return "a damaged recording: it goes on behind its end";
        if (record->kind == TapeKind::Header) return "a damaged recording: it has two headers";
        if (record->steps() < steps_) return "a damaged recording: its steps run backwards";
        steps_ = record->steps();
        whole_ = record->kind == TapeKind::End;
    }
    if (fault.empty() && whole_ && at_ != bytes_.size())
        return "a damaged recording: it goes on behind its end";
    at_ = first;
    return fault;
}

Actions TapePlayer::told_by(const TapeRecord& record) const {
    Actions told = now_;
    for (const TapeRecord::Change& change : record.changes) {
        const std::optional<Action> action = actions_[change.action];
        if (!action) continue;  // of another version
        told.held[index_of(*action)] = change.held;
        told.pressed[index_of(*action)] = change.pressed;
        told.amount[index_of(*action)] = change.amount;
    }
    told.look_yaw_rad = record.look_rad[0];
    told.look_pitch_rad = record.look_rad[1];
    told.pointer = record.pointer;
    return told;
}

TapePlayer::Told TapePlayer::step(std::uint64_t step) {
    now_.pressed = {};
    now_.look_yaw_rad = now_.look_pitch_rad = 0;
    Told told{.actions = now_};
    std::string fault;
    for (std::size_t next = at_; auto record = peek(next, fault); at_ = next) {
        if (record->step > step || (record->step == step && record->kind == TapeKind::End)) break;
        if (record->kind == TapeKind::Step) told.actions = told_by(*record);
        if (record->kind == TapeKind::Requested)
            told.requests.push_back(std::move(record->request));
    }
    now_ = told.actions;
    return told;
}

std::optional<TapeState> TapePlayer::state_after(std::uint64_t steps) {
    std::optional<TapeState> found;
    std::string fault;
    for (std::size_t next = at_; auto record = peek(next, fault); at_ = next) {
        const bool has_state = record->kind == TapeKind::State || record->kind == TapeKind::End;
        if (!has_state || record->step > steps) break;
        if (record->step == steps && !found) found = std::move(record->state);
    }
    return found;
}

}  // namespace plumbline::app
