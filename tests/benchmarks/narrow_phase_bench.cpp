// What contacts of one pair of convex shapes cost, of bodies that rest on each other and of random poses, beside
// one point of the same pair by Bullet's detector (GJK with EPA), which adds up four over as many steps.
//
//   narrow_phase_bench --benchmark_filter=rest
#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <benchmark/benchmark.h>
#include <btBulletCollisionCommon.h>

#include <memory>

namespace {

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::physics::convex_rig;

constexpr double kReach_m = 0.02;
constexpr int kPoses = 256;

struct Pose {
    PlacedConvex a;
    PlacedConvex b;
};

btVector3 bullet_vector(const Vec3d& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

btTransform bullet_transform(const PlacedConvex& convex) {
    btMatrix3x3 rotation;
    for (int row = 0; row < 3; ++row)
        rotation[row] =
            bullet_vector({convex.axes[0][row], convex.axes[1][row], convex.axes[2][row]});
    return btTransform(rotation, bullet_vector(convex.center_m));
}

std::unique_ptr<btConvexShape> bullet_shape(const ConvexShape& shape) {
    const auto radius = static_cast<btScalar>(shape.radius_m);
    const auto half = static_cast<btScalar>(shape.half_height_m);
    switch (shape.kind) {
        case Kind::Sphere:
            return std::make_unique<btSphereShape>(radius);
        case Kind::Capsule:
            return std::make_unique<btCapsuleShape>(radius, 2 * half);
        case Kind::Box:
            return std::make_unique<btBoxShape>(bullet_vector(Vec3d(shape.half_m)));
        case Kind::Cylinder:
            return std::make_unique<btCylinderShape>(btVector3(radius, half, radius));
        case Kind::Cone:
            return std::make_unique<btConeShape>(radius, 2 * half);
        case Kind::Hull:
        case Kind::None:
            break;
    }
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3d& corner : shape.hull->corners_m) hull->addPoint(bullet_vector(corner), false);
    hull->recalcLocalAabb();
    return hull;
}

/// On each other, as deep as a solver leaves them, each turned about the vertical.
std::vector<Pose> resting(const Solid& a, const Solid& b, bool lies) {
    Random random(3);
    std::vector<Pose> poses;
    const glm::dmat3 lying = lies ? glm::dmat3{0, 1, 0, -1, 0, 0, 0, 0, 1} : glm::dmat3{1.0};
    for (int i = 0; i < kPoses; ++i) {
        const auto turned = [&] {
            const double half_rad = random.uniform(0, 3.14F);
            return glm::mat3_cast(Quatd{std::cos(half_rad), 0, std::sin(half_rad), 0});
        };
        const glm::dmat3 lean = glm::mat3_cast(Quatd{1, random_direction(random) * 1e-6});
        Pose pose{placed(a, lean * turned() * lying, {0.1, 0, 0.05}),
                  placed(b, turned(), {0, 0, 0})};
        pose.a.center_m.y = -gap_along(pose.a, pose.b, {0, 1, 0}) - 1e-4;
        poses.push_back(pose);
    }
    return poses;
}

std::vector<Pose> random_poses(const Solid& a, const Solid& b) {
    Random random(4);
    std::vector<Pose> poses;
    for (int i = 0; i < kPoses; ++i) {
        const Vec3d direction = random_direction(random);
        Pose pose{placed(a, random_turn(random), {0, 0, 0}),
                  placed(b, random_turn(random), {0, 0, 0})};
        const double gap_m = random.uniform(-0.02F, 0.01F);
        pose.a.center_m = direction * (gap_m - gap_along(pose.a, pose.b, direction));
        poses.push_back(pose);
    }
    return poses;
}

void own(benchmark::State& state, const std::vector<Pose>& poses) {
    std::size_t i = 0;
    for (auto _ : state) {
        const Pose& pose = poses[i++ % kPoses];
        benchmark::DoNotOptimize(contact_of(pose.a, pose.b, kReach_m));
    }
}

void bullet(benchmark::State& state, const std::vector<Pose>& poses) {
    const auto a = bullet_shape(*poses[0].a.shape);
    const auto b = bullet_shape(*poses[0].b.shape);
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    std::vector<btGjkPairDetector::ClosestPointInput> inputs(kPoses);
    for (std::size_t i = 0; i < kPoses; ++i) {
        inputs[i].m_transformA = bullet_transform(poses[i].a);
        inputs[i].m_transformB = bullet_transform(poses[i].b);
    }
    std::size_t i = 0;
    for (auto _ : state) {
        btGjkPairDetector detector(a.get(), b.get(), &simplex, &depth);
        btPointCollector found;
        detector.getClosestPoints(inputs[i++ % kPoses], found, nullptr);
        benchmark::DoNotOptimize(found.m_distance);
    }
}

void add(const std::string& name, const std::vector<Pose>& poses) {
    benchmark::RegisterBenchmark((name + "/own").c_str(), own, poses);
    benchmark::RegisterBenchmark((name + "/bullet").c_str(), bullet, poses);
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const std::vector<Solid>& solids = catalogue();
    const Solid table = box({5, 0.5, 5});
    const Solid barrel = hull("barrel of 24", hull_rig::prism_corners(24, 0.5, 0.4));
    const Solid& prism = solids[6];
    const Solid& drum = solids[3];
    add("rest/prism on box", resting(prism, table, false));
    add("rest/box on prism", resting(solids[2], prism, false));
    add("rest/prism on prism", resting(prism, prism, false));
    add("rest/barrel on barrel", resting(barrel, barrel, false));
    add("rest/cylinder on box", resting(drum, table, false));
    add("rest/cylinder on cylinder", resting(drum, drum, false));
    add("rest/lying cylinder on box", resting(drum, table, true));
    add("rest/cone on box", resting(solids[4], table, false));
    for (std::size_t i = 0; i < solids.size(); ++i) {
        for (std::size_t k = i; k < solids.size(); ++k)
            add("random/" + solids[i].name + " and " + solids[k].name,
                random_poses(solids[i], solids[k]));
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
