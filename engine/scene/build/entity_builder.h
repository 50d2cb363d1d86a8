// Descriptions to entities: visuals, bodies, lights and sounds, each shared thing made once.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/build/collision_groups.h"
#include "engine/scene/build/shape_factory.h"
#include "engine/scene/simulation.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace plumbline::scene {

class EntityBuilder {
public:
    /// `simulation` must outlive the builder.
    explicit EntityBuilder(Simulation& simulation);

    const CollisionGroups& groups() const { return groups_; }
    /// Materials that stand in where the scene has none of the name: for things from outside it.
    void lend_materials(const std::map<std::string, assets::MaterialData>& materials);
    /// Adds the entity under `name`. On an error nothing is left of it.
    Result<ecs::Entity> build(const EntityDescription& description, const std::string& name);

private:
    struct Appearance {
        assets::MeshId mesh{};
        std::vector<assets::MaterialId> materials;
        assets::ModelId model{};
        bool is_model{false};  ///< `mesh` is the model's own, fit for shapes
    };

    Appearance appearance_of(const EntityDescription& description);
    Appearance appearance_of_model(const EntityDescription& description, const ModelVisual& visual);
    Appearance placeholder_for(const EntityDescription& description);
    /// The scene's own, else a lent one, else null.
    const assets::MaterialData* described_material(const std::string& name) const;
    assets::MaterialId material_named(const std::string& name);
    std::uint16_t surface_of(const EntityDescription& description,
                             const Appearance& appearance) const;
    /// Null unless its parts are to collide one by one as they move.
    const assets::MovingModel* moving_parts_of(const EntityDescription& description,
                                               const Appearance& appearance) const;
    Result<Done> build_parts(const EntityDescription& whole,
                             const std::string& name,
                             const assets::MovingModel& model,
                             std::uint16_t surface,
                             ecs::Entity entity);
    Result<BuiltShape> shape_of(const EntityDescription& description, const Appearance& appearance);
    Result<physics::BodyId> body_of(const EntityDescription& description,
                                    const Appearance& appearance,
                                    std::uint16_t surface,
                                    ecs::Entity entity);
    std::optional<Vec3> inertia_of(const EntityDescription& description,
                                   Real mass_kg,
                                   const BuiltShape& shape);
    void track(const EntityDescription& description,
               ecs::Entity entity,
               physics::BodyId body,
               const BuiltShape& shape);
    void add_visual(const EntityDescription& description,
                    const Appearance& appearance,
                    ecs::Entity entity);
    void add_sound(const SoundDescription& sound, ecs::Entity entity);
    void add_trigger(const EntityDescription& description, ecs::Entity entity);
    void warn_once(const std::string& text);

    Simulation& simulation_;
    ShapeFactory shapes_;
    std::map<std::string, assets::MaterialId> materials_;
    std::map<std::string, assets::MaterialData> lent_;
    CollisionGroups groups_;
    std::set<std::filesystem::path> refused_models_;
};

}  // namespace plumbline::scene
