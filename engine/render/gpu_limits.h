// What the driver can hold. Tests ask for less than there is, to see that less is survived.
#pragma once

#include <cstddef>
#include <cstdint>

namespace plumbline::render {

struct GpuLimits {
    std::uint32_t texture_px{0};  ///< largest side of an image; 0: what the driver says
    std::size_t target_bytes{0};  ///< of all images of one size to draw into; 0: any number
};

}  // namespace plumbline::render
