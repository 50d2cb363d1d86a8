// What the driver can hold. Tests ask for less than there is, to see that less is survived.
#pragma once

#include <cstddef>
#include <cstdint>

namespace plumbline::render {

struct GpuLimits {
    std::uint32_t texture_px{0};  ///< largest side of an image; 0: what the driver says
    std::uint32_t map_px{0};  ///< of those that materials name; 0: a sensible size for the driver
    std::size_t target_bytes{0};  ///< of all images of one size to draw into; 0: any number
    bool half_float_targets{
        true};  ///< false: light is drawn into 8 bits, at most as bright as white
};

}  // namespace plumbline::render
