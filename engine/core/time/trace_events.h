// What each thread was busy with, and when: spans of time in the Trace Event format, which Perfetto and chrome://tracing draw
// as a flame graph. Only for reports: nothing simulated reads it.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace plumbline {

/// While one lives, spans are kept; one at a time. Made, read and destroyed while no span is open on another thread.
class TraceRecording {
public:
    TraceRecording();
    ~TraceRecording();
    TraceRecording(const TraceRecording&) = delete;
    TraceRecording& operator=(const TraceRecording&) = delete;

    /// The spans that ended since the last call, and forgets them. What all calls return, one after the other, and
    /// `kEnd` are one JSON array ("JSON Array Format" of Duffy and others, Trace Event Format, 2016): complete events
    /// ("X") with `ts` since the recording's start and `dur` in microseconds, `tid` 0 for the thread that began it.
    std::string take();
    static constexpr std::string_view kEnd = "\n]\n";

private:
    friend class TraceSpan;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// From here to the end of the scope; within the spans of its thread that are open. Without a recording it costs one load.
class TraceSpan {
public:
    /// `name` outlives the recording, as a literal does.
    explicit TraceSpan(std::string_view name) {
        if (recording.load(std::memory_order_relaxed) != nullptr) begin(name);
    }
    ~TraceSpan() {
        if (start_s_ != 0) end();
    }
    TraceSpan(const TraceSpan&) = delete;
    TraceSpan& operator=(const TraceSpan&) = delete;

    /// A number to show with the span; `key` as the name. No more than kMostNotes are kept.
    void note(std::string_view key, std::int64_t value) {
        if (start_s_ != 0 && note_count_ < kMostNotes) notes_[note_count_++] = {key, value};
    }

    static constexpr std::size_t kMostNotes = 4;
    struct Note {
        std::string_view key;
        std::int64_t value;
    };

private:
    friend class TraceRecording;
    void begin(std::string_view name);
    void end();

    static std::atomic<TraceRecording*> recording;  ///< null: nobody records

    std::string_view name_{};
    double start_s_{0};  ///< of wall_s(); 0: nobody records
    std::size_t note_count_{0};
    std::array<Note, kMostNotes>
        notes_;  ///< the first note_count_; else a span that nobody records would clear them
};

}  // namespace plumbline
