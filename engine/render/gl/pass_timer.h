// Times the passes of a frame on both processors. GPU times come from timer queries that are read
// frames later, so that nobody waits for them.
#pragma once

#include "engine/core/time/stopwatch.h"
#include "engine/render/frame_stats.h"
#include "engine/render/gl/object.h"

#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace plumbline::render::gl {

class PassTimers {
public:
    /// The timing of one pass, from begin() to the end of the scope. Passes do not nest.
    class Scope {
    public:
        Scope(PassTimers& timers, std::string_view name);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        PassTimers& timers_;
        std::string_view name_;
        double start_s_;
    };

    void begin_frame();
    /// Passes of the frame so far, in the order they ran.
    const std::vector<PassTiming>& timings() const { return timings_; }

private:
    static constexpr std::size_t kQueriesInFlight = 4;
    struct Ring {
        std::array<QueryObject, kQueriesInFlight> queries;
        std::array<bool, kQueriesInFlight> waiting{};
        std::size_t next{0};
        double latest_ms{-1};
    };

    void start(Ring& ring);
    void collect(Ring& ring);

    std::map<std::string_view, Ring> rings_;
    std::vector<PassTiming> timings_;
};

}  // namespace plumbline::render::gl
