#include "engine/render/resources/gpu_meshes.h"

#include "engine/render/culling/foliage_order.h"
#include "engine/render/resources/gpu_materials.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <deque>
#include <future>
#include <limits>
#include <set>

namespace plumbline::render {
namespace {

/// Making coarser versions of more takes seconds.
constexpr std::size_t kMostLodTriangles = 400'000;

// Attribute locations, as in the vertex shaders.
constexpr GLuint kPosition = 0;
constexpr GLuint kNormal = 1;
constexpr GLuint kTangent = 2;
constexpr GLuint kUv = 3;
constexpr GLuint kColor = 4;
constexpr GLuint kInstanceRows = 5;  // to 7
constexpr GLuint kTint = 8;
constexpr GLuint kWind = 9;

struct PackedVertex {
    Vec3f position_body;
    std::uint32_t normal_body;   // 10 bits a part, signed
    std::uint32_t tangent_body;  // w: handedness
    Vec2f uv;
    std::uint32_t color;  // square roots, 8 bits a part: as fine in the dark as in the light
};
static_assert(sizeof(PackedVertex) == 32);

std::uint32_t pack_signed(float value, int bits) {
    const float scale = static_cast<float>((1 << (bits - 1)) - 1);
    const float scaled = std::round(std::clamp(value, -1.0F, 1.0F) * scale);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled)) & ((1U << bits) - 1U);
}

std::uint32_t pack_direction(const Vec3f& v, float w) {
    return pack_signed(v.x, 10) | pack_signed(v.y, 10) << 10U | pack_signed(v.z, 10) << 20U |
           pack_signed(w, 2) << 30U;
}

std::uint32_t pack_color(const Vec3f& color) {
    std::uint32_t packed = 0xFF000000U;
    for (int i = 0; i < 3; ++i) {
        const float byte = std::round(std::sqrt(std::clamp(color[i], 0.0F, 1.0F)) * 255.0F);
        packed |= static_cast<std::uint32_t>(byte) << (8U * static_cast<std::uint32_t>(i));
    }
    return packed;
}

std::vector<PackedVertex> pack(const std::vector<assets::Vertex>& vertices) {
    std::vector<PackedVertex> packed;
    packed.reserve(vertices.size());
    for (const assets::Vertex& v : vertices) {
        packed.push_back({v.position_body,
                          pack_direction(v.normal_body, 0.0F),
                          pack_direction(Vec3f{v.tangent_body}, v.tangent_body.w),
                          v.uv,
                          pack_color(v.color)});
    }
    return packed;
}

struct DepthGeometry {
    std::vector<Vec3f> positions;
    std::vector<std::uint32_t> indices;
};

/// Equal for 0 and -0 too.
std::uint64_t hash_of(const Vec3f& position) {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto bits = std::bit_cast<std::uint32_t>(position[axis] + 0.0F);
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// Vertices that differ in normal or uv only are one for a shadow map: a cube has 8, not 24.
DepthGeometry merged_positions(const assets::MeshData& mesh) {
    constexpr std::uint32_t kEmpty = ~0U;
    // Open addressing: a million flat triangles bring three million vertices.
    std::vector<std::uint32_t> places(std::bit_ceil(mesh.vertices.size() * 2 + 1), kEmpty);
    DepthGeometry merged;
    std::vector<std::uint32_t> merged_index(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3f& position = mesh.vertices[i].position_body;
        std::size_t place = hash_of(position) & (places.size() - 1);
        while (places[place] != kEmpty && merged.positions[places[place]] != position) {
            place = (place + 1) & (places.size() - 1);
        }
        if (places[place] == kEmpty) {
            places[place] = static_cast<std::uint32_t>(merged.positions.size());
            merged.positions.push_back(position);
        }
        merged_index[i] = places[place];
    }
    merged.indices.reserve(mesh.indices.size());
    for (const std::uint32_t i : mesh.indices) merged.indices.push_back(merged_index[i]);
    return merged;
}

/// Uploads as 16 bit where they fit; tells the GL type.
unsigned int upload_indices(gl::Buffer& buffer,
                            const std::vector<std::uint32_t>& indices,
                            std::size_t vertex_count) {
    if (vertex_count <= std::numeric_limits<std::uint16_t>::max()) {
        const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
        buffer.upload(narrow.data(), narrow.size() * sizeof(std::uint16_t));
        return GL_UNSIGNED_SHORT;
    }
    buffer.upload(indices.data(), indices.size() * sizeof(std::uint32_t));
    return GL_UNSIGNED_INT;
}

const void* offset_pointer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

void packed_attribute(GLuint location, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, type, GL_TRUE, sizeof(PackedVertex), offset_pointer(offset));
}

void enable_instance_attributes() {
    for (GLuint location = kInstanceRows; location <= kTint; ++location) {
        glEnableVertexAttribArray(location);
        glVertexAttribDivisor(location, 1);
    }
}

void set_up_full(GpuMesh& mesh) {
    mesh.vertex_array = gl::new_vertex_array();
    glBindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
    gl::float_attribute(kPosition, 3, sizeof(PackedVertex), offsetof(PackedVertex, position_body));
    packed_attribute(kNormal, GL_INT_2_10_10_10_REV, offsetof(PackedVertex, normal_body));
    packed_attribute(kTangent, GL_INT_2_10_10_10_REV, offsetof(PackedVertex, tangent_body));
    gl::float_attribute(kUv, 2, sizeof(PackedVertex), offsetof(PackedVertex, uv));
    packed_attribute(kColor, GL_UNSIGNED_BYTE, offsetof(PackedVertex, color));
    if (mesh.sways) {
        glBindBuffer(GL_ARRAY_BUFFER, mesh.wind.name());
        glEnableVertexAttribArray(kWind);
        glVertexAttribPointer(
            kWind, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(assets::WindWeights), nullptr);
    }
    enable_instance_attributes();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.name());
    glBindVertexArray(0);
}

void set_up_depth(GpuMesh& mesh) {
    mesh.depth_vertex_array = gl::new_vertex_array();
    glBindBuffer(GL_ARRAY_BUFFER, mesh.depth_vertices.name());
    gl::float_attribute(kPosition, 3, sizeof(Vec3f), 0);
    enable_instance_attributes();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.depth_indices.name());
    glBindVertexArray(0);
}

/// Merging takes longer than drawing what is merged once.
DepthGeometry plain_positions(const assets::MeshData& mesh) {
    DepthGeometry depth{.positions = {}, .indices = mesh.indices};
    depth.positions.reserve(mesh.vertices.size());
    for (const assets::Vertex& vertex : mesh.vertices) {
        depth.positions.push_back(vertex.position_body);
    }
    return depth;
}

enum class MeshLife { Kept, Changing };

/// What is uploaded, and the coarser versions in it.
struct PackedMesh {
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<assets::WindWeights> wind;  ///< of each vertex, or none
    DepthGeometry depth;
    std::vector<MeshLod> lods;
    std::uint32_t version{0};
};

std::vector<assets::WindWeights> wind_of(const assets::MeshData& data) {
    std::vector<assets::WindWeights> wind;
    if (!assets::sways(data)) return wind;
    wind.reserve(data.vertices.size());
    for (const assets::Vertex& vertex : data.vertices) wind.push_back(vertex.wind);
    return wind;
}

PackedMesh packed(const assets::MeshData& data, MeshLife life) {
    return {.vertices = pack(data.vertices),
            .indices = data.indices,
            .wind = wind_of(data),
            .depth = life == MeshLife::Kept ? merged_positions(data) : plain_positions(data),
            .lods = {},
            .version = data.version};
}

PackedMesh packed_with_lods(const assets::MeshData& data, const std::vector<bool>& is_foliage) {
    const bool is_solid = std::ranges::find(is_foliage, true) == is_foliage.end();
    if (data.indices.size() / 3 > kMostLodTriangles) return packed(data, MeshLife::Kept);
    assets::MeshData all = data;
    std::vector<MeshLod> lods = add_lods(all, is_foliage);
    if (!is_solid) lods.insert(lods.begin(), {.error_m = 0.0F, .sub_meshes = data.sub_meshes});
    if (lods.empty()) return packed(data, MeshLife::Kept);
    PackedMesh mesh = packed(all, MeshLife::Kept);
    // Shadow maps do without.
    add_foliage_order(all.vertices, is_foliage, mesh.indices, lods);
    mesh.lods = std::move(lods);
    return mesh;
}

/// What vertices of a faceted mesh hand on would cost more where there are many.
constexpr std::size_t kMostFacets = 1000;

/// Whether it has few triangles, each of one normal and one colour.
bool is_faceted(const PackedMesh& mesh) {
    if (mesh.indices.size() > 3 * kMostFacets) return false;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const PackedVertex& first = mesh.vertices[mesh.indices[i]];
        for (std::size_t k = 1; k < 3; ++k) {
            const PackedVertex& other = mesh.vertices[mesh.indices[i + k]];
            if (other.normal_body != first.normal_body || other.color != first.color) return false;
        }
    }
    return true;
}

GpuMesh uploaded(const PackedMesh& data) {
    using gl::Buffer;
    using gl::BufferLife;
    using gl::BufferUse;
    GpuMesh mesh;
    mesh.vertices = Buffer{BufferUse::Vertices, BufferLife::Kept};
    mesh.vertices.upload(data.vertices.data(), data.vertices.size() * sizeof(PackedVertex));
    mesh.indices = Buffer{BufferUse::Indices, BufferLife::Kept};
    mesh.index_type = upload_indices(mesh.indices, data.indices, data.vertices.size());
    mesh.sways = !data.wind.empty();
    mesh.faceted = is_faceted(data);
    if (mesh.sways) {
        mesh.wind = Buffer{BufferUse::Vertices, BufferLife::Kept};
        mesh.wind.upload(data.wind.data(), data.wind.size() * sizeof(assets::WindWeights));
    }
    mesh.depth_vertices = Buffer{BufferUse::Vertices, BufferLife::Kept};
    const std::vector<Vec3f>& positions = data.depth.positions;
    mesh.depth_vertices.upload(positions.data(), positions.size() * sizeof(Vec3f));
    mesh.depth_indices = Buffer{BufferUse::Indices, BufferLife::Kept};
    mesh.depth_index_type =
        upload_indices(mesh.depth_indices, data.depth.indices, positions.size());

    set_up_full(mesh);
    set_up_depth(mesh);
    mesh.version = data.version;
    mesh.bytes = mesh.vertices.size() + mesh.indices.size() + mesh.depth_vertices.size() +
                 mesh.depth_indices.size() + mesh.wind.size();
    return mesh;
}

// Packed meshes waiting for upload hold memory; so few are kept under way.
constexpr std::size_t kMeshesUnderWay = 4;

}  // namespace

const GpuMesh& GpuMeshes::get(assets::MeshId id, std::span<const assets::MaterialId> materials) {
    const assets::MeshData& data = library_.mesh(id);
    const auto found = meshes_.find(id);
    if (found != meshes_.end()) {
        GpuMesh& mesh = found->second;
        if (mesh.version == data.version) return mesh;
        bytes_ -= mesh.bytes;
        mesh = uploaded(packed(data, MeshLife::Changing));
        lods_.erase(id);
        bytes_ += mesh.bytes;
        return mesh;
    }
    PackedMesh mesh = makes_lods_ ? packed_with_lods(data, foliage_parts(data, materials))
                                  : packed(data, MeshLife::Kept);
    return add(id, uploaded(mesh), std::move(mesh.lods));
}

void GpuMeshes::load(std::span<const MeshRequest> requests, const std::function<void()>& on_each) {
    struct UnderWay {
        assets::MeshId id;
        std::future<PackedMesh> mesh;
    };
    std::deque<UnderWay> under_way;
    const auto finish_oldest = [&] {
        PackedMesh mesh = under_way.front().mesh.get();
        add(under_way.front().id, uploaded(mesh), std::move(mesh.lods));
        under_way.pop_front();
    };
    std::set<assets::MeshId> asked;
    for (const MeshRequest& request : requests) {
        on_each();
        if (meshes_.contains(request.id) || !asked.insert(request.id).second) continue;
        const assets::MeshData& data = library_.mesh(request.id);
        // Deferred to whoever asks where no thread can be made.
        const auto make = [&data,
                           makes_lods = makes_lods_,
                           is_foliage = foliage_parts(data, request.materials)] {
            return makes_lods ? packed_with_lods(data, is_foliage) : packed(data, MeshLife::Kept);
        };
        under_way.push_back(
            {request.id, std::async(std::launch::async | std::launch::deferred, make)});
        if (under_way.size() >= kMeshesUnderWay) finish_oldest();
    }
    while (!under_way.empty()) finish_oldest();
}

std::vector<bool> GpuMeshes::foliage_parts(const assets::MeshData& data,
                                           std::span<const assets::MaterialId> materials) const {
    std::vector<bool> is_foliage;
    for (const assets::SubMesh& part : data.sub_meshes) {
        const bool has_material =
            part.material < materials.size() && materials[part.material].value != 0;
        is_foliage.push_back(
            has_material &&
            (features_of(library_.material(materials[part.material])) & mesh_feature::kLeaf) != 0);
    }
    return is_foliage;
}

const GpuMesh& GpuMeshes::add(assets::MeshId id, GpuMesh mesh, std::vector<MeshLod> lods) {
    bytes_ += mesh.bytes;
    if (!lods.empty()) lods_.insert_or_assign(id, std::move(lods));
    return meshes_.emplace(id, std::move(mesh)).first->second;
}

void GpuMeshes::make_lods() {
    if (makes_lods_) return;
    clear();
    makes_lods_ = true;
}

void GpuMeshes::clear() {
    meshes_.clear();
    lods_.clear();
    bytes_ = 0;
}

void InstanceStream::upload(std::span<const Instance> instances) {
    buffer_.upload(instances.data(), instances.size_bytes());
}

void InstanceStream::attach(std::uint32_t first) const {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    for (GLuint i = 0; i < 4; ++i) {
        glVertexAttribPointer(kInstanceRows + i,
                              4,
                              GL_FLOAT,
                              GL_FALSE,
                              sizeof(Instance),
                              offset_pointer(first * sizeof(Instance) + i * sizeof(Vec4f)));
    }
}

void draw_instances(const GpuMesh& mesh,
                    MeshDetail detail,
                    const InstanceStream& instances,
                    const DrawRun& run) {
    const bool full = detail == MeshDetail::Full;
    glBindVertexArray(full ? mesh.vertex_array.name() : mesh.depth_vertex_array.name());
    instances.attach(run.first_instance);
    const unsigned int type = full ? mesh.index_type : mesh.depth_index_type;
    const std::size_t index_bytes = type == GL_UNSIGNED_SHORT ? 2 : 4;
    glDrawElementsInstanced(GL_TRIANGLES,
                            static_cast<GLsizei>(run.index_count),
                            type,
                            offset_pointer(run.first_index * index_bytes),
                            static_cast<GLsizei>(run.instance_count));
}

}  // namespace plumbline::render
