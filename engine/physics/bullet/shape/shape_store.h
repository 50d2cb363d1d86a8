// The shapes of a world, by their ids.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/shape.h"

#include <memory>
#include <string>
#include <vector>

namespace plumbline::physics {

struct ShapeRecord;

class ShapeStore {
public:
    ShapeStore();
    ~ShapeStore();
    ShapeStore(const ShapeStore&) = delete;
    ShapeStore& operator=(const ShapeStore&) = delete;

    /// As PhysicsWorld::create_shape().
    Result<ShapeId> create(const ShapeDef& def, std::vector<std::string>* notes);
    const ShapeRecord& get(ShapeId id) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::physics
