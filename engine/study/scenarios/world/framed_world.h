// A scene that is built through a change of frame and read back through it, for invariances.
#pragma once

#include "engine/study/scenarios/world/stepper.h"

namespace plumbline::study {

/// How a scene is changed: x' = offset + turn (scale x) + drift t', with t' = sqrt(scale) t, so that
/// gravity stays what it is.
struct Frame {
    Quatd turn{1, 0, 0, 0};
    Vec3d offset_m{0, 0, 0};
    Vec3d drift_mps{0, 0, 0};
    double scale{1};
    bool backwards{false};  ///< bodies are made in the opposite order
};

/// Parts first, then build(), then run() and what became of them, in the scene's own lengths.
class FramedWorld {
public:
    FramedWorld(const Frame& frame, const Setting& setting);

    /// The index of the new part. Static ones are carried along by a frame that drifts.
    std::size_t box(physics::BodyKind kind,
                    const Vec3d& at,
                    const Vec3d& size,
                    const BodyProperties& properties);
    std::size_t sphere(const Vec3d& at, double radius, const BodyProperties& properties);
    /// 90 m square, top at y = 0.
    void floor(double friction, double restitution = 0);
    void build();
    /// A ball-and-socket joint where `a` is off `b` by now; after build().
    void join(std::size_t a, std::size_t b, const Vec3d& anchor);
    void run(Stepper& stepper, double seconds);

    Vec3d at(std::size_t part) const;
    Vec3d velocity(std::size_t part) const;

private:
    struct Part {
        physics::BodyKind kind;
        physics::ShapeDef shape;
        Vec3d at;
        BodyProperties properties;
    };
    Vec3d place(const Vec3d& at) const {
        return frame_.offset_m + frame_.turn * (at * frame_.scale);
    }

    Frame frame_;
    ScenarioWorld world_;
    std::vector<Part> parts_;
    std::vector<physics::BodyId> ids_;
    double passed_s_{0};  ///< of the world's time
};

}  // namespace plumbline::study
