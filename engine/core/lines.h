// Coloured segments that any module may emit for debugging; the renderer draws them.
#pragma once

#include "engine/core/math.h"

#include <vector>

namespace plumbline {

struct LineVertex {
    Vec3f position_world;  ///< m
    Vec3f color;           ///< linear RGB
};

/// Two vertices a segment. Past `limit` segments are counted, not kept (the HUD says how many).
struct LineList {
    std::vector<LineVertex> vertices;
    std::size_t limit{200'000};  ///< segments
    std::size_t not_shown{0};

    void add(const Vec3f& from_world, const Vec3f& to_world, const Vec3f& color) {
        if (vertices.size() / 2 >= limit) {
            ++not_shown;
            return;
        }
        vertices.push_back({from_world, color});
        vertices.push_back({to_world, color});
    }
    void clear() {
        vertices.clear();
        not_shown = 0;
    }
};

}  // namespace plumbline
