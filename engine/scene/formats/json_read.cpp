#include "engine/scene/formats/json_read.h"

#include "engine/core/text/json_depth.h"

#include <fmt/format.h>

#include <stdexcept>

namespace plumbline::scene {

void refuse_deep_json(std::string_view text) {
    if (json_depth(text) > kJsonDepth)
        throw std::runtime_error(fmt::format("it nests deeper than {} levels", kJsonDepth));
}

}  // namespace plumbline::scene
