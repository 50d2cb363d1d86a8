#include "engine/render/gl/pass_timer.h"

#include <glad/gl.h>

namespace plumbline::render::gl {
namespace {

constexpr double kLongestPass_ms = 1e4;

}  // namespace

PassTimers::Scope::Scope(PassTimers& timers, std::string_view name)
    : timers_(timers), name_(name), start_s_(thread_cpu_s()) {
    timers_.start(timers_.rings_[name_]);
}

PassTimers::Scope::~Scope() {
    Ring& ring = timers_.rings_[name_];
    if (ring.waiting[ring.next]) {
        glEndQuery(GL_TIME_ELAPSED);
        ring.next = (ring.next + 1) % kQueriesInFlight;
    }
    timers_.timings_.push_back(
        {.name = name_, .cpu_ms = (thread_cpu_s() - start_s_) * 1e3, .gpu_ms = ring.latest_ms});
}

void PassTimers::begin_frame() {
    timings_.clear();
}

void PassTimers::start(Ring& ring) {
    collect(ring);
    // A driver that is a whole ring behind gets no new query, rather than a wait.
    if (ring.waiting[ring.next]) {
        ring.waiting[ring.next] = false;
        ring.queries[ring.next].reset();
    }
    if (!ring.queries[ring.next]) {
        GLuint name = 0;
        glGenQueries(1, &name);
        ring.queries[ring.next] = QueryObject{name};
    }
    glBeginQuery(GL_TIME_ELAPSED, ring.queries[ring.next].name());
    ring.waiting[ring.next] = true;
}

void PassTimers::collect(Ring& ring) {
    for (std::size_t i = 0; i < kQueriesInFlight; ++i) {
        const std::size_t slot = (ring.next + i) % kQueriesInFlight;
        if (!ring.waiting[slot]) continue;
        GLint available = 0;
        glGetQueryObjectiv(ring.queries[slot].name(), GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) return;
        GLuint64 elapsed_ns = 0;
        glGetQueryObjectui64v(ring.queries[slot].name(), GL_QUERY_RESULT, &elapsed_ns);
        ring.waiting[slot] = false;
        // Software GL's first query of a kind can read as hours: it ended before it began.
        const double elapsed_ms = static_cast<double>(elapsed_ns) * 1e-6;
        if (elapsed_ms < kLongestPass_ms) ring.latest_ms = elapsed_ms;
    }
}

}  // namespace plumbline::render::gl
