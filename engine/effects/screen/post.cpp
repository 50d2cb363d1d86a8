// Exposure and bloom.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"

namespace plumbline::effects {
namespace {

class Post final : public Effect {
public:
    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        const scene::PostDescription& post = *simulation.description().post;
        frame.post =
            render::Post{.exposure = post.exposure, .bloom = post.bloom, .adapts = post.adapts};
        ++work_.calls;
    }
    std::uint64_t bytes_cpu() const override { return sizeof(*this); }
};

Callers callers_of_post(const scene::Simulation& simulation) {
    const auto& post = simulation.description().post;
    if (!post) return {};
    return {setting("[post]", post->location)};
}

std::unique_ptr<Effect> make_post(scene::Simulation&) {
    return std::make_unique<Post>();
}

}  // namespace

EffectRow post() {
    return {.name = "post",
            .domain = Domain::Frame,
            .called_for_by = &callers_of_post,
            .make = &make_post,
            .gpu_owner = "post",
            .passes = "post."};
}

}  // namespace plumbline::effects
