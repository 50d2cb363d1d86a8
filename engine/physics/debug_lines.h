// Outlines of shapes, boxes and contact normals, for debug drawing.
#pragma once

#include "engine/core/lines.h"
#include "engine/core/pose.h"
#include "engine/physics/shape.h"

#include <optional>

namespace plumbline::physics {

class PhysicsWorld;

/// Outline of a shape at a pose of its body, whether or not a body is there.
void add_shape_lines(const PhysicsWorld& world,
                     ShapeId shape,
                     const Pose& world_from_body,
                     const Vec3f& color,
                     LineList& lines);
/// Outlines of every collision shape, coloured by kind and sleep, and contact normals. The capsule
/// of a character round the eye, if one is given, is left out: it would be all there is to see.
void add_debug_lines(const PhysicsWorld& world,
                     LineList& lines,
                     const std::optional<Vec3>& eye_world = {});
/// The box along the world's axes round every body, as the broad phase compares them.
void add_box_lines(const PhysicsWorld& world,
                   LineList& lines,
                   const std::optional<Vec3>& eye_world = {});

}  // namespace plumbline::physics
