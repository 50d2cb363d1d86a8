// Waves on boxes of water.
#include "engine/core/io/archive.h"
#include "engine/effects/callers.h"
#include "engine/effects/effect_table.h"
#include "engine/scene/build/water_mesh.h"
#include "engine/scene/environment/wave_field.h"

namespace plumbline::effects {
namespace {

bool has_waves(const scene::WaterDescription& water) {
    return water.surface == scene::WaterSurface::Waves;
}

/// Along each side.
int modes_of(const scene::Simulation& simulation) {
    return by_fidelity(simulation.description().forces.fidelity.water, std::array{16, 32, 64});
}

/// Steps the waves after the bodies have given them what they displaced.
class Water final : public Effect {
public:
    explicit Water(scene::Simulation& simulation) : simulation_(simulation) {
        const int modes = modes_of(simulation);
        const auto gravity_mps2 =
            std::max(-static_cast<double>(simulation.physics.def().gravity_mps2.y), 0.0);
        for (std::size_t i = 0; i < simulation.waters.size(); ++i) {
            const scene::WaterDescription& water = simulation.description().forces.waters[i];
            if (!has_waves(water)) continue;
            simulation.waters[i].waves =
                std::make_unique<scene::WaveField>(water, modes, gravity_mps2);
        }
    }
    ~Water() override {
        for (scene::SceneWater& water : simulation_.waters) {
            if (!water.waves) continue;
            water.waves.reset();
            flatten(water);
        }
    }
    Water(const Water&) = delete;
    Water& operator=(const Water&) = delete;

    void after_step(scene::Simulation& simulation, const scene::Game&) override {
        for (scene::SceneWater& water : simulation.waters) {
            if (!water.waves || water.waves->is_asleep()) continue;
            water.waves->advance(simulation.step_s());
            ++work_.calls;
        }
    }

    void extract(const scene::Simulation& simulation,
                 const scene::ViewPoint& view,
                 render::RenderFrame&) override {
        drawn_.resize(simulation.waters.size());
        for (std::size_t i = 0; i < simulation.waters.size(); ++i) {
            const scene::SceneWater& water = simulation.waters[i];
            if (!water.waves) continue;
            const Drawn now{
                .step = simulation.steps(), .blend = view.blend, .rests = water.waves->is_asleep()};
            if (now == drawn_[i] || (now.rests && drawn_[i].rests)) continue;
            drawn_[i] = now;
            assets::MeshData* mesh = mesh_of(water);
            if (mesh == nullptr) continue;
            std::vector<double> heights_m(mesh->vertices.size());
            water.waves->sample(scene::kWaterCells + 1, static_cast<double>(view.blend), heights_m);
            scene::shape_water_mesh(heights_m, water.max_m.y, *mesh);
        }
    }

    void serialize(Archive& archive) override {
        for (scene::SceneWater& water : simulation_.waters) {
            if (water.waves) water.waves->serialize(archive);
        }
    }

    std::uint64_t bytes_held() const override {
        const int modes = modes_of(simulation_);
        return simulation_.waters.size() * static_cast<std::uint64_t>(modes * modes) * 32;
    }

private:
    struct Drawn {
        std::uint64_t step{~std::uint64_t{0}};
        Real blend{0};
        bool rests{false};
        bool operator==(const Drawn&) const = default;
    };
    /// Null where nothing is drawn of it.
    assets::MeshData* mesh_of(const scene::SceneWater& water) const {
        const auto* visual = simulation_.registry.find<scene::Visual>(water.surface);
        return visual == nullptr ? nullptr : &simulation_.library().change_mesh(visual->mesh);
    }
    void flatten(const scene::SceneWater& water) const {
        assets::MeshData* mesh = mesh_of(water);
        if (mesh == nullptr) return;
        const std::vector<double> heights_m(mesh->vertices.size(), 0);
        scene::shape_water_mesh(heights_m, water.max_m.y, *mesh);
    }

    scene::Simulation& simulation_;
    std::vector<Drawn> drawn_;  ///< by water
};

Callers callers_of_water(const scene::Simulation& simulation) {
    if (!simulation.switches.is_on("water", true)) return {};
    Callers callers;
    for (const scene::WaterDescription& water : simulation.description().forces.waters) {
        if (has_waves(water)) callers.push_back(setting("[[water]] " + water.name, water.location));
    }
    return callers;
}

}  // namespace

EffectRow water() {
    return with_effect<Water>({.called_for_by = &callers_of_water});
}

}  // namespace plumbline::effects
