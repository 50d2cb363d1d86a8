#include "engine/scene/scene_description.h"

#include <fmt/format.h>

namespace plumbline::scene {

std::string to_string(const Origin& origin) {
    return fmt::format("{}:{}", origin.file, origin.line);
}

}  // namespace plumbline::scene
