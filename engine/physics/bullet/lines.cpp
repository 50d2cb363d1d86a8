// Outlines of collision shapes and contact normals, from Bullet's debug drawing.
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/shape/shape_record.h"
#include "engine/physics/bullet/step_world.h"
#include "engine/physics/character.h"
#include "engine/physics/debug_lines.h"
#include "engine/physics/world/world_state.h"

#include <LinearMath/btIDebugDraw.h>

namespace plumbline::physics {
namespace {

constexpr Real kNormalLength_m = 0.2_r;

/// Collects lines. Its mode is plain wireframe: Bullet reads a "never sleep" bit from there.
class LineCollector final : public btIDebugDraw {
public:
    explicit LineCollector(LineList& lines) : lines_(lines) {}

    void drawLine(const btVector3& from, const btVector3& to, const btVector3& color) override {
        lines_.add(Vec3f{from_bullet(from)}, Vec3f{from_bullet(to)}, Vec3f{from_bullet(color)});
    }
    void drawContactPoint(
        const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
    void reportErrorWarning(const char*) override {}
    void draw3dText(const btVector3&, const char*) override {}
    void setDebugMode(int) override {}
    int getDebugMode() const override { return DBG_DrawWireframe; }

private:
    LineList& lines_;
};

btVector3 color_of(const BodyRecord& record) {
    if (!record.in_world) return {1, 0, 1};
    if (record.frozen) return {0.3_r, 0.8_r, 1};
    if (record.kind == BodyKind::Static) return {0.45_r, 0.45_r, 0.45_r};
    if (record.kind == BodyKind::Kinematic) return {1, 0.6_r, 0.1_r};
    return record.rigid->isActive() ? btVector3(0.2_r, 1, 0.3_r) : btVector3(0.2_r, 0.4_r, 0.8_r);
}

bool is_capsule_round(const BodyRecord& record, const Vec3& eye_world) {
    if (record.user != kCharacterMark) return false;
    btVector3 low;
    btVector3 high;
    record.rigid->getAabb(low, high);
    return glm::all(glm::greaterThanEqual(eye_world, from_bullet(low))) &&
           glm::all(glm::lessThanEqual(eye_world, from_bullet(high)));
}

}  // namespace

void add_shape_lines(const PhysicsWorld& world,
                     ShapeId shape,
                     const Pose& world_from_body,
                     const Vec3f& color,
                     LineList& lines) {
    const ShapeRecord& record = internals(world).shapes.get(shape);
    LineCollector collector(lines);
    StepWorld& bullet = internals(world).engine->world();
    bullet.setDebugDrawer(&collector);
    bullet.debugDrawObject(to_bullet(compose(world_from_body, record.body_from_mass)),
                           record.collision,
                           to_bullet(Vec3(color)));
    bullet.setDebugDrawer(nullptr);
}

void add_debug_lines(const PhysicsWorld& world,
                     LineList& lines,
                     const std::optional<Vec3>& eye_world) {
    LineCollector collector(lines);
    StepWorld& bullet = internals(world).engine->world();
    // Only for the length of this call: a drawer left in place would be asked during steps.
    bullet.setDebugDrawer(&collector);
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (eye_world && is_capsule_round(*record, *eye_world)) return;
        bullet.debugDrawObject(record->rigid->getWorldTransform(),
                               record->rigid->getCollisionShape(),
                               color_of(*record));
    });
    bullet.setDebugDrawer(nullptr);
    internals(world).engine->each_manifold([&lines](const Manifold& manifold) {
        for (const ManifoldPoint& point : manifold.points) {
            const Vec3& foot = point.b.surface_m;
            const Vec3 tip = foot + kNormalLength_m * point.normal_world;
            lines.add(Vec3f{foot}, Vec3f{tip}, Vec3f{1, 0.9F, 0.1F});
        }
    });
}

void add_box_lines(const PhysicsWorld& world,
                   LineList& lines,
                   const std::optional<Vec3>& eye_world) {
    LineCollector collector(lines);
    internals(world).bodies.each([&](BodyId, const std::unique_ptr<BodyRecord>& record) {
        if (eye_world && is_capsule_round(*record, *eye_world)) return;
        btVector3 low;
        btVector3 high;
        record->rigid->getAabb(low, high);
        collector.drawAabb(low, high, color_of(*record));
    });
}

}  // namespace plumbline::physics
