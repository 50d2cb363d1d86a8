#include "engine/study/scene_start.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/files.h"
#include "engine/core/io/saved_file.h"
#include "engine/scene/simulation/simulation_archive.h"

#include <fmt/format.h>

namespace plumbline::study {

SceneStart scene_start_of(scene::Simulation& simulation) {
    Archive archive;
    serialize_bodies_of_scene(simulation, archive);
    return {.time_s = simulation.time_s(), .state = archive.take()};
}

Result<Done> take_up(const SceneStart& start, PlayedScene& scene) {
    scene::Simulation& simulation = scene.simulation();
    physics::WorldDef own = simulation.physics.def();
    Archive archive(start.state);
    serialize_bodies_of_scene(simulation, archive);
    if (archive.failed()) return Error{.message = "its state: " + archive.fault()};
    own.gravity_mps2 = simulation.physics.def().gravity_mps2;
    simulation.set_accuracy(own);
    simulation.set_time(start.time_s);
    return Done{};
}

Result<Done> write_start(const std::filesystem::path& file, SceneStart start) {
    Archive archive;
    archive(start.time_s, start.state);
    return write_file_atomically(file, archive.written());
}

Result<SceneStart> read_start(const std::filesystem::path& file) {
    const Result<std::string> bytes = read_file(file, kSavedFileBytes);
    if (!bytes) return bytes.error();
    SceneStart start;
    Archive archive(*bytes);
    archive(start.time_s, start.state);
    if (archive.failed())
        return Error{.message = fmt::format("{}: {}", file.string(), archive.fault())};
    return start;
}

}  // namespace plumbline::study
