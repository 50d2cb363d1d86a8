// Draws models as their animations have them, part by part.
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/extract.h"

#include <fmt/format.h>

#include <map>

namespace plumbline::effects {
namespace {

using assets::MeshId;
using assets::MovingModel;

/// A model's pose as it was drawn last. Deforming parts have meshes of their own for each entity.
struct Posed {
    std::vector<MeshId> meshes;  ///< by MovingModel::parts
    assets::ModelPose pose;
    double time_s{-1};
    std::uint32_t animation{0};
};

class ModelAnimation final : public Effect {
public:
    explicit ModelAnimation(scene::Simulation& simulation) : library_(simulation.library()) {}

    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame& frame) override {
        for (auto [entity, playing, visual, transform] :
             simulation.registry
                 .view<const scene::PlayingModel, const scene::Visual, const scene::Transform>()) {
            const MovingModel* model = library_.moving(playing.model);
            if (model == nullptr) continue;
            Posed& posed = posed_of(entity, *model);
            take_pose(*model, playing, static_cast<double>(view.blend), posed);
            const Pose pose = scene::drawn_pose(simulation, entity, transform, view.blend);
            add_items(*model, visual, matrix_of(pose, transform.scale), posed, frame);
            ++work_.calls;
        }
    }

private:
    Posed& posed_of(ecs::Entity entity, const MovingModel& model) {
        const auto [found, is_new] = posed_.try_emplace(entity.index);
        Posed& posed = found->second;
        if (!is_new && posed.meshes.size() == model.parts.size()) return posed;
        posed = Posed{.meshes = model.part_meshes};
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            if (!model.parts[i].deforms) continue;
            // By name: a scene that starts anew takes the mesh that it had.
            posed.meshes[i] =
                library_.add_mesh(fmt::format("entity {} part {}", entity.index, i), {});
            assets::MeshData mesh =
                assets::part_mesh(model.data, model.parts[i], rest_pose(model.data));
            assets::MeshData& place = library_.change_mesh(posed.meshes[i]);
            mesh.version = place.version;
            place = std::move(mesh);
        }
        return posed;
    }

    void take_pose(const MovingModel& model,
                   const scene::PlayingModel& playing,
                   double blend,
                   Posed& posed) {
        const std::size_t number = playing.animation % model.data.animations.size();
        const assets::ModelAnimation& animation = model.data.animations[number];
        double time_s = playing.time_s - playing.latest_step_s * (1.0 - blend);
        if (time_s < 0.0) time_s += static_cast<double>(animation.duration_s);  // began anew
        if (posed.time_s == time_s && posed.animation == number) return;
        posed.time_s = time_s;
        posed.animation = static_cast<std::uint32_t>(number);
        posed.pose = assets::pose_at(model.data, animation, static_cast<float>(time_s));
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            if (!model.parts[i].deforms) continue;
            assets::deform(
                model.data, model.parts[i], posed.pose, library_.change_mesh(posed.meshes[i]));
        }
    }

    void add_items(const MovingModel& model,
                   const scene::Visual& visual,
                   const Mat4f& world_from_body,
                   const Posed& posed,
                   render::RenderFrame& frame) const {
        const auto add = [&](MeshId mesh, const Mat4f& world_from_part) {
            render::add_item(frame,
                             {.mesh = mesh,
                              .world_from_body = world_from_part,
                              .tint = visual.tint,
                              .casts_shadow = visual.casts_shadow},
                             visual.materials);
        };
        if (model.still != MeshId{}) add(model.still, world_from_body);
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            const assets::ModelPart& part = model.parts[i];
            add(posed.meshes[i],
                part.deforms ? world_from_body
                             : world_from_body * posed.pose.model_from_node[part.node]);
        }
    }

    assets::AssetLibrary& library_;
    std::map<std::uint32_t, Posed> posed_;  ///< by the entity's index
};

}  // namespace

EffectRow model_animation() {
    return with_effect<ModelAnimation>({.called_for_by = &entities_with<scene::PlayingModel>});
}

}  // namespace plumbline::effects
