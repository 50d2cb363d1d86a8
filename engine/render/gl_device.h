// Private: the driver that a renderer was made with.
#pragma once

#include "engine/render/renderer.h"
#include "engine/render/setup/image_plan.h"

namespace plumbline::render {

/// 0: the device works.
using ResetStatus = unsigned int (*)();

struct GlDevice {
    Device device;
    GlInfo info;
    ResetStatus reset_status{nullptr};  ///< null: the driver cannot tell
    bool is_lost{false};
};

/// Loads the functions of GL and asks the driver what it can hold. The error names vendor, renderer,
/// found and needed version.
Result<GlDevice> load_device(GlLoader loader, PresentTarget target, const GpuLimits& limits);

}  // namespace plumbline::render
