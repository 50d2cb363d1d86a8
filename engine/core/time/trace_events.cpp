#include "engine/core/time/trace_events.h"

#include "engine/core/assert.h"
#include "engine/core/time/stopwatch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <iterator>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace plumbline {
namespace {

struct Span {
    std::string_view name;
    double start_s{0};
    double end_s{0};
    std::array<TraceSpan::Note, TraceSpan::kMostNotes> notes{};
    std::size_t note_count{0};
};

void append(std::string& json, const Span& span, std::size_t thread, double from_s) {
    fmt::format_to(
        std::back_inserter(json),
        ",\n{{\"name\":\"{}\",\"ph\":\"X\",\"ts\":{:.3f},\"dur\":{:.3f},\"pid\":1,\"tid\":{}",
        span.name,
        (span.start_s - from_s) * 1e6,
        (span.end_s - span.start_s) * 1e6,
        thread);
    const auto notes = std::span(span.notes).first(span.note_count);
    for (const TraceSpan::Note& note : notes) {
        fmt::format_to(std::back_inserter(json),
                       "{}\"{}\":{}",
                       &note == notes.data() ? ",\"args\":{" : ",",
                       note.key,
                       note.value);
    }
    json += notes.empty() ? "}" : "}}";
}

}  // namespace

struct TraceRecording::Impl {
    double start_s{wall_s()};
    std::mutex mutex;  ///< of the list; each thread's spans are its own
    std::deque<std::vector<Span>> threads;
    std::uint64_t number{0};
    bool begun{false};

    /// Of the calling thread.
    std::vector<Span>& spans();
};

std::vector<Span>& TraceRecording::Impl::spans() {
    struct Place {
        std::uint64_t recording{0};
        std::vector<Span>* spans{nullptr};
    };
    thread_local Place place;
    if (place.recording != number) {
        const std::lock_guard lock(mutex);
        place = {number, &threads.emplace_back()};
    }
    return *place.spans;
}

TraceRecording::TraceRecording() : impl_(std::make_unique<Impl>()) {
    static std::atomic<std::uint64_t> recordings{0};
    impl_->number = ++recordings;
    impl_->spans();
    const TraceRecording* before = TraceSpan::recording.exchange(this);
    PL_ASSERT(before == nullptr, "one recording at a time");
}

TraceRecording::~TraceRecording() {
    TraceSpan::recording = nullptr;
}

std::string TraceRecording::take() {
    std::string json;
    if (!std::exchange(impl_->begun, true))
        json = R"([{"name":"process_name","ph":"M","pid":1,"tid":0,"args":{"name":"plumbline"}})";
    const std::lock_guard lock(impl_->mutex);
    for (std::size_t thread = 0; thread < impl_->threads.size(); ++thread) {
        for (const Span& span : impl_->threads[thread]) append(json, span, thread, impl_->start_s);
        impl_->threads[thread].clear();
    }
    return json;
}

std::atomic<TraceRecording*> TraceSpan::recording{nullptr};

void TraceSpan::begin(std::string_view name) {
    name_ = name;
    start_s_ = wall_s();
}

void TraceSpan::end() {
    const TraceRecording* to = recording.load(std::memory_order_acquire);
    if (to == nullptr) return;
    Span& span = to->impl_->spans().emplace_back();
    span.name = name_;
    span.start_s = start_s_;
    span.end_s = wall_s();
    span.note_count = note_count_;
    std::copy_n(notes_.begin(), note_count_, span.notes.begin());
}

}  // namespace plumbline
