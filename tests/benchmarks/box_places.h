// Boxes toppled into a heap, roughly where the peer scene's boxes lie when they rest.
#pragma once

#include "engine/core/math.h"

namespace plumbline::bench {

/// Where box `i` lies in frame `frame`; w: its turn about +Y.
inline Vec4f box_place(int i, int frame) {
    const int layer = i / 100;
    const float spread = 1.0F + 0.06F * static_cast<float>(layer);
    const float x = (static_cast<float>(i % 10) - 4.5F) * 1.6F +
                    0.28F * static_cast<float>((i * 7 + layer * 3) % 11 - 5) / 5.0F;
    const float z = (static_cast<float>(i / 10 % 10) - 4.5F) * 1.6F +
                    0.28F * static_cast<float>((i * 5 + layer * 4) % 13 - 6) / 6.0F;
    return {x * spread,
            0.5F + static_cast<float>(layer),
            z * spread,
            0.3F * static_cast<float>(i) + 0.01F * static_cast<float>(frame)};
}

}  // namespace plumbline::bench
