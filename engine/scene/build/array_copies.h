// The copies of an array, one after the other.
#pragma once

#include "engine/scene/scene_description.h"

#include <fmt/format.h>

#include <string>

namespace plumbline::scene {

/// Calls visit(name, pose) for each copy, until one call says false: x runs fastest, as the files say; z slowest. False
/// where it was stopped.
template <class Visit>
bool visit_copies(const ArrayDescription& array, Visit visit) {
    for (int z = 0; z < array.count[2]; ++z) {
        for (int y = 0; y < array.count[1]; ++y) {
            for (int x = 0; x < array.count[0]; ++x) {
                const std::string name = fmt::format("{}.{}.{}.{}", array.name, x, y, z);
                if (!visit(name, pose_of_copy(array, {x, y, z}))) return false;
            }
        }
    }
    return true;
}

}  // namespace plumbline::scene
