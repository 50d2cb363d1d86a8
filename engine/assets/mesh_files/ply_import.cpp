#include "engine/assets/mesh_files/ply_import.h"

#include "engine/assets/mesh_files/ply_header_impl.h"
#include "engine/assets/mesh_files/polygon_triangles_impl.h"
#include "engine/assets/mesh_files/single_mesh_impl.h"
#include "engine/assets/mesh_files/text_words_impl.h"
#include "engine/core/color.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <utility>

namespace plumbline::assets {
namespace {

constexpr double kExactGamma = 2.2;

/// Values in the order of the file, as text or as bytes.
class Values {
public:
    Values(PlyFormat format, std::string_view body) : format_(format), text_(body), bytes_(body) {}

    double next(const PlyNumber* type) {
        if (format_ == PlyFormat::Text) return next_word_value();
        return type->read(bytes_,
                          format_ == PlyFormat::Big ? std::endian::big : std::endian::little);
    }
    bool failed() const { return failed_ || bytes_.failed(); }

private:
    double next_word_value() {
        constexpr std::string_view kBlank = " \t\r\n\v\f";
        const std::size_t first = text_.find_first_not_of(kBlank);
        if (first == std::string_view::npos) {
            failed_ = true;
            return 0.0;
        }
        text_.remove_prefix(first);
        const auto [value, length] = leading_number(text_);
        const bool whole = length == text_.size() || kBlank.find(text_[length]) != kBlank.npos;
        failed_ = failed_ || length == 0 || !whole;
        text_.remove_prefix(failed_ ? text_.size() : length);
        return value;
    }

    PlyFormat format_;
    std::string_view text_;
    ByteReader bytes_;
    bool failed_{false};
};

/// Where a property goes; nothing for those that are read over.
float* slot_of(Vertex& vertex, std::string_view name) {
    constexpr std::string_view kAxes = "xyz";
    if (name.size() == 1 && kAxes.find(name[0]) != kAxes.npos) {
        return &vertex.position_body[static_cast<int>(kAxes.find(name[0]))];
    }
    if (name.size() == 2 && name[0] == 'n' && kAxes.find(name[1]) != kAxes.npos) {
        return &vertex.normal_body[static_cast<int>(kAxes.find(name[1]))];
    }
    if (name == "red" || name == "diffuse_red") return &vertex.color.x;
    if (name == "green" || name == "diffuse_green") return &vertex.color.y;
    if (name == "blue" || name == "diffuse_blue") return &vertex.color.z;
    if (name == "s" || name == "u" || name == "texture_u") return &vertex.uv.x;
    if (name == "t" || name == "v" || name == "texture_v") return &vertex.uv.y;
    return nullptr;
}

enum class Reading : std::uint8_t {
    Model,  ///< for looks: colours as sRGB codes, faces that cannot be drawn are left out
    Exact,  ///< see read_exact_ply
};

struct PlyReader {
    Reading reading;
    Values values;
    ModelMesh mesh{.name = "ply"};
    bool has_colors{false};
    bool has_normals{false};
    bool has_uvs{false};
    std::size_t bad_faces{0};
    std::size_t place{0};  ///< in the element that is read

    /// Which numbers of a vertex the element's properties fill.
    void read_vertices(const PlyElement& element) {
        if (element.count > limits::kVertices) {
            fail("it has {} vertices; at most {} are read", element.count, limits::kVertices);
        }
        std::size_t places = 0;
        Vertex probe;
        for (const PlyProperty& property : element.properties) {
            places += property.name.size() == 1 && slot_of(probe, property.name) != nullptr &&
                      std::string_view("xyz").find(property.name) != std::string_view::npos;
            has_normals = has_normals || property.name == "nx";
            has_colors = has_colors || slot_of(probe, property.name) == &probe.color.x;
            has_uvs = has_uvs || slot_of(probe, property.name) == &probe.uv.x;
        }
        if (places != 3) fail("its vertices have no x, y and z");
        mesh.vertices.resize(element.count);
        for (Vertex& vertex : mesh.vertices) {
            vertex.normal_body = Vec3f{0.0F};
            place = static_cast<std::size_t>(&vertex - mesh.vertices.data());
            for (const PlyProperty& property : element.properties) read_value(property, vertex);
            if (values.failed()) return;
            if (!is_finite(vertex.position_body)) fail("vertex {} is not finite", place);
            if (reading == Reading::Exact && !is_finite(vertex.color)) {
                fail("the colour of vertex {} is not finite", place);
            }
            if (!is_finite(vertex.normal_body)) vertex.normal_body = Vec3f{0.0F};
            // The image's rows run down here.
            vertex.uv = std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y)
                            ? Vec2f{vertex.uv.x, 1.0F - vertex.uv.y}
                            : Vec2f{0.0F};
        }
    }

    void read_value(const PlyProperty& property, Vertex& vertex) {
        if (property.count != nullptr) return read_over_list(property);
        const double value = values.next(property.type);
        float* slot = slot_of(vertex, property.name);
        if (slot == nullptr) return;
        *slot = static_cast<float>(value);
        const bool is_color = slot >= &vertex.color.x && slot <= &vertex.color.z;
        if (is_color && reading == Reading::Exact) {
            const bool coded = property.type->range != 1.0;
            const double share = value / property.type->range;
            *slot = static_cast<float>(coded ? std::pow(share, kExactGamma) : value);
        } else if (is_color) {
            const double share = std::isfinite(value) ? value / property.type->range : 1.0;
            *slot = linear_from_srgb(static_cast<float>(std::clamp(share, 0.0, 1.0)));
        }
    }

    std::vector<std::uint32_t> read_list(const PlyProperty& property) {
        const double count = values.next(property.count);
        if (!(count >= 0.0 && count <= 1e7)) fail("a list has an impossible length");
        std::vector<std::uint32_t> corners;
        for (double i = 0; i < count && !values.failed(); ++i) {
            const double value = values.next(property.type);
            const bool fits = value >= 0.0 && value < static_cast<double>(mesh.vertices.size());
            corners.push_back(fits ? static_cast<std::uint32_t>(value) : ~0U);
        }
        return corners;
    }

    void read_over_list(const PlyProperty& property) {
        const double count = values.next(property.count);
        for (double i = 0; i < count && !values.failed(); ++i) values.next(property.type);
    }

    void add_face(const std::vector<std::uint32_t>& corners) {
        if (values.failed()) return;
        const bool bad = std::find(corners.begin(), corners.end(), ~0U) != corners.end();
        if (bad || corners.size() < 3 || corners.size() > kMostCorners) {
            ++bad_faces;
            if (reading != Reading::Exact) return;
            if (!bad) fail("face {} has {} corners", place, corners.size());
            fail(
                "face {} names a vertex that is not there: it has {}", place, mesh.vertices.size());
        }
        if (corners.size() == 3) {
            mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
        } else {
            std::vector<Vec3f> places;
            for (const std::uint32_t i : corners) places.push_back(mesh.vertices[i].position_body);
            for (const auto& triangle : triangles_of(places)) {
                for (const std::uint32_t i : triangle) mesh.indices.push_back(corners[i]);
            }
        }
        if (mesh.indices.size() > limits::kIndices) {
            fail("it draws more than {} indices", limits::kIndices);
        }
    }

    void read_faces(const PlyElement& element) {
        for (place = 0; place < element.count && !values.failed(); ++place) {
            for (const PlyProperty& property : element.properties) {
                if (property.count == nullptr) {
                    values.next(property.type);
                } else if (property.name == "vertex_indices" || property.name == "vertex_index") {
                    add_face(read_list(property));
                } else {
                    read_over_list(property);
                }
            }
        }
    }

    void read_over(const PlyElement& element) {
        for (place = 0; place < element.count && !values.failed(); ++place) {
            for (const PlyProperty& property : element.properties) {
                if (property.count != nullptr) {
                    read_over_list(property);
                } else {
                    values.next(property.type);
                }
            }
        }
    }
};

/// Scans come without normals; they are meant to look round.
void make_normals(ModelMesh& mesh) {
    MeshData made{.vertices = std::move(mesh.vertices), .indices = mesh.indices};
    compute_normals(made);
    mesh.vertices = std::move(made.vertices);
}

/// Everything but what is made of it.
PlyReader read_all(std::string_view bytes, Reading reading) {
    const PlyHeader header = read_ply_header(bytes);
    PlyReader reader{.reading = reading, .values = Values(header.format, header.body)};
    const std::size_t least = least_bytes_of(header);
    if (least > header.body.size() + 1) {
        fail("its header promises {} bytes or more; {} follow", least, header.body.size());
    }
    for (const PlyElement& element : header.elements) {
        reader.place = 0;
        if (element.name == "vertex") {
            reader.read_vertices(element);
        } else if (element.name == "face") {
            reader.read_faces(element);
        } else {
            reader.read_over(element);
        }
        if (reader.values.failed()) {
            fail("it breaks off, or holds what is no number, in its element {} number {} of {}",
                 element.name,
                 std::min(reader.place, element.count - 1),
                 element.count);
        }
    }
    return reader;
}

}  // namespace

Result<ModelData> read_ply(std::string_view bytes, const std::string& name) {
    return or_refused(name, [&] {
        PlyReader reader = read_all(bytes, Reading::Model);
        if (reader.bad_faces > 0) {
            log_warning(
                "model {}: {} faces that name vertices it lacks, or no usable ones, are left out",
                name,
                reader.bad_faces);
        }
        if (reader.mesh.indices.empty()) fail("it holds no triangles");
        if (!reader.has_normals) make_normals(reader.mesh);
        return model_with_z_up(std::move(reader.mesh), reader.has_colors);
    });
}

Result<ExactPly> read_exact_ply(std::string_view bytes, const std::string& name) {
    return or_refused(name, [&] {
        PlyReader reader = read_all(bytes, Reading::Exact);
        return ExactPly{.vertices = std::move(reader.mesh.vertices),
                        .indices = std::move(reader.mesh.indices),
                        .has_normals = reader.has_normals,
                        .has_uvs = reader.has_uvs};
    });
}

}  // namespace plumbline::assets
