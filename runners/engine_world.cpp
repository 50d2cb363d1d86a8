#include "runners/engine_world.h"

namespace plumbline::engines {

void refuse_specials(const Json& scene) {
    for (const Json& body : scene.at("bodies")) {
        if (body.at("rolling_friction_m") != 0 || body.at("spinning_friction_m") != 0)
            throw Lacks("rolling friction as a length");
        if (body.at("kind") == "dynamic" && body.at("linear_factor") != Json{1, 1, 1})
            throw Lacks("bodies held along an axis");
    }
    for (const Json& joint : scene.at("joints")) {
        if (joint.at("kind") == "elastic") throw Lacks("elastic joints");
        if (joint.at("breaks")) throw Lacks("joints that break at a force, counted over a step");
    }
}

int knob(const Json& scene, const char* name, int other) {
    return scene.contains("knobs") ? scene.at("knobs").value(name, other) : other;
}

}  // namespace plumbline::engines
