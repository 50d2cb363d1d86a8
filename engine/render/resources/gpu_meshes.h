// Meshes of the asset library, uploaded on first use, and the stream of per-instance data.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/culling/draw_list.h"
#include "engine/render/gl/buffer.h"
#include "engine/render/gl/object.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace plumbline::render {

struct GpuMesh {
    gl::VertexArrayObject vertex_array;        ///< all attributes
    gl::VertexArrayObject depth_vertex_array;  ///< positions only, merged: for shadow maps
    gl::Buffer vertices;
    gl::Buffer indices;
    gl::Buffer depth_vertices;
    gl::Buffer depth_indices;
    gl::Buffer wind;  ///< weights; empty where nothing sways
    unsigned int index_type{0};
    unsigned int depth_index_type{0};
    bool sways{false};
    bool faceted{false};  ///< few triangles, each of one normal and one colour
    std::size_t bytes{0};
    std::uint32_t version{0};  ///< MeshData::version of what was uploaded
};

/// A mesh and the materials of the first thing that is drawn with it.
struct MeshRequest {
    assets::MeshId id{};
    std::span<const assets::MaterialId> materials;
};

class GpuMeshes {
public:
    explicit GpuMeshes(const assets::AssetLibrary& library) : library_(library) {}

    /// Uploads what is not there yet, and again what has another version.
    const GpuMesh& get(assets::MeshId id) { return get(id, {}); }
    /// `materials`: of the first thing that is drawn with it; they tell what is foliage.
    const GpuMesh& get(assets::MeshId id, std::span<const assets::MaterialId> materials);
    /// Makes all of them ready for get(), on several threads; `on_each`: after every request.
    void load(std::span<const MeshRequest> requests, const std::function<void()>& on_each);
    void clear();
    std::size_t bytes() const { return bytes_; }
    /// Coarser versions of what was uploaded since make_lods(). Meshes that change have none.
    const LodTable& lods() const { return lods_; }
    /// From now on every mesh gets coarser versions, those there already with their next use.
    void make_lods();

private:
    std::vector<bool> foliage_parts(const assets::MeshData& data,
                                    std::span<const assets::MaterialId> materials) const;
    const GpuMesh& add(assets::MeshId id, GpuMesh mesh, std::vector<MeshLod> lods);

    const assets::AssetLibrary& library_;
    LodTable lods_;
    bool makes_lods_{false};
    std::map<assets::MeshId, GpuMesh> meshes_;
    std::size_t bytes_{0};
};

/// Instances of one draw list in GPU memory.
class InstanceStream {
public:
    InstanceStream() : buffer_(gl::BufferUse::Vertices, gl::BufferLife::PerFrame) {}
    void upload(std::span<const Instance> instances);
    /// Points the bound vertex array's instance attributes at `first` and what follows.
    void attach(std::uint32_t first) const;

private:
    gl::Buffer buffer_;
};

/// Which of a mesh's two vertex arrays a draw uses.
enum class MeshDetail { Full, DepthOnly };

void draw_instances(const GpuMesh& mesh,
                    MeshDetail detail,
                    const InstanceStream& instances,
                    const DrawRun& run);

}  // namespace plumbline::render
