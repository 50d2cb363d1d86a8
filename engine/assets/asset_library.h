// Everything that has been loaded, once each, behind small ids. Owned by whoever runs a scene;
// ids stay good as long as the library. Read from one thread.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/assets/model/model_pose.h"
#include "engine/assets/model_data.h"
#include "engine/assets/sound_data.h"
#include "engine/core/result.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace plumbline::assets {

/// Index + 1 into one of the library's tables; 0 names none.
template <class Tag>
struct AssetId {
    std::uint32_t value{0};
    friend auto operator<=>(const AssetId&, const AssetId&) = default;
};
using MeshId = AssetId<struct MeshTag>;
using MaterialId = AssetId<struct MaterialTag>;
using SoundId = AssetId<struct SoundTag>;
using ModelId = AssetId<struct ModelTag>;

/// A model as the scene uses it: all of it as one mesh, at rest, and its materials.
struct Model {
    ModelId id{};
    MeshId mesh{};
    std::vector<MaterialId> materials;  ///< the file's own, in the order of SubMesh::material
    /// With physics: what each of ModelPhysics::motions moves, then what none does (see body_meshes); {}: nothing.
    std::vector<MeshId> bodies{};
};

/// What is drawn of a model with animations, in place of Model::mesh.
struct MovingModel {
    ModelData data;
    MeshId still{};                   ///< what never moves; none: {}
    std::vector<ModelPart> parts;     ///< what moves
    std::vector<MeshId> part_meshes;  ///< one a part, in its node's frame; {} where it deforms
};

class AssetLibrary {
public:
    /// Imports on first use; later calls give the same model. `root`: see import_model.
    Result<Model> model(const std::filesystem::path& file, const std::filesystem::path& root);
    /// Null for a model that has no animations.
    const MovingModel* moving(ModelId id) const;
    /// From now on model() looks whether the file, or one that it names, was saved since, and then
    /// imports it again under its old id. When that fails the error is its answer and the old
    /// content stays.
    void doubt_models();
    /// What the models were read from: to be watched.
    std::vector<std::filesystem::path> model_files() const;
    /// Decodes on first use what prefetch_sounds() has not decoded by then.
    Result<SoundId> sound(const std::filesystem::path& file);
    /// Adds a generated mesh under a name; the same name gives the same mesh.
    MeshId add_mesh(const std::string& name, MeshData mesh);
    /// For meshes that change from frame to frame: whoever draws it sees the new content.
    MeshData& change_mesh(MeshId id);
    /// Equal materials are one.
    MaterialId add_material(MaterialData material);

    /// References stay good while the library lives, whatever is added.
    const MeshData& mesh(MeshId id) const;
    const MaterialData& material(MaterialId id) const;
    const SoundData& sound(SoundId id) const;
    std::size_t mesh_count() const { return meshes_.size(); }
    std::size_t material_count() const { return materials_.size(); }

    /// Starts decoding the faces of the skybox in `sky` (empty: none), then the base colour maps that
    /// the materials name, on worker threads; call after a scene is loaded so that the renderer finds
    /// them ready.
    void prefetch_images(const std::filesystem::path& sky = {});
    /// The same for images that are sure to be taken: what nobody takes stays in memory. Each is
    /// decoded ahead once, however often it is named; empty paths are passed over.
    void prefetch_images(const std::vector<std::filesystem::path>& files);
    /// Starts decoding the files one after the other, on a thread. At most once.
    void prefetch_sounds(std::vector<std::filesystem::path> files);
    /// The decoded image, waiting for it if need be; decoded now if nobody prefetched it. A broken
    /// file gives a checkerboard and one warning. Hands the pixels over: the library forgets them.
    std::shared_ptr<const ImageData> take_image(const std::filesystem::path& file);
    /// The bytes of an image, of a model file or one by itself, as they are; empty where it cannot be read.
    std::string encoded_image(const std::filesystem::path& file) const;

    /// Images and sounds outside the folder `installed` are decoded in a process of their own; with an
    /// empty folder none is.
    explicit AssetLibrary(const std::filesystem::path& installed = {});
    ~AssetLibrary();
    AssetLibrary(const AssetLibrary&) = delete;
    AssetLibrary& operator=(const AssetLibrary&) = delete;

private:
    struct Images;
    struct SoundsAhead;
    struct ModelEntry;
    Result<Done> import(ModelEntry& entry,
                        const std::filesystem::path& file,
                        const std::filesystem::path& root);

    std::deque<MeshData> meshes_;  // deques: growth must not move what references point at
    std::deque<MaterialData> materials_;
    std::deque<SoundData> sounds_;
    std::multimap<std::string, MaterialId> materials_by_name_;
    std::vector<std::unique_ptr<ModelEntry>> models_;
    std::map<std::pair<std::filesystem::path, std::filesystem::path>, ModelId> models_by_file_;
    std::map<std::filesystem::path, SoundId> sounds_by_file_;
    std::map<std::string, MeshId> meshes_by_name_;
    std::unique_ptr<Images> images_;
    std::unique_ptr<SoundsAhead> sounds_ahead_;
};

}  // namespace plumbline::assets
