#include "engine/assets/byte_reader.h"
#include "engine/assets/obj_check_impl.h"
#include "engine/assets/single_mesh_impl.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace plumbline::assets {
namespace {

constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;
constexpr std::size_t kMostCorners = 256;

enum class Number : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

std::optional<Number> number_of(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, Number>, 16> kWords{
        {{"char", Number::Int8},
         {"int8", Number::Int8},
         {"uchar", Number::Uint8},
         {"uint8", Number::Uint8},
         {"short", Number::Int16},
         {"int16", Number::Int16},
         {"ushort", Number::Uint16},
         {"uint16", Number::Uint16},
         {"int", Number::Int32},
         {"int32", Number::Int32},
         {"uint", Number::Uint32},
         {"uint32", Number::Uint32},
         {"float", Number::Float},
         {"float32", Number::Float},
         {"double", Number::Double},
         {"float64", Number::Double}}};
    for (const auto& [known, number] : kWords) {
        if (word == known) return number;
    }
    return std::nullopt;
}

std::size_t bytes_of(Number number) {
    switch (number) {
        case Number::Int8:
        case Number::Uint8:
            return 1;
        case Number::Int16:
        case Number::Uint16:
            return 2;
        case Number::Int32:
        case Number::Uint32:
        case Number::Float:
            return 4;
        case Number::Double:
            return 8;
    }
    return 1;
}

/// Colours stored as whole numbers are shares of this.
double range_of(Number number) {
    if (number == Number::Uint8) return 255.0;
    return number == Number::Uint16 ? 65'535.0 : 1.0;
}

struct Property {
    std::string name;
    Number type{Number::Float};
    std::optional<Number> count;  ///< lists: how their length is stored
};

struct Element {
    std::string name;
    std::size_t count{0};
    std::vector<Property> properties;
};

enum class Format { Text, Little, Big };

struct Header {
    Format format{Format::Text};
    std::vector<Element> elements;
    std::string_view body;
};

/// Values in the order of the file, as text or as bytes.
class Values {
public:
    Values(Format format, std::string_view body) : format_(format), text_(body), bytes_(body) {}

    double next(Number type) {
        if (format_ == Format::Text) return next_word_value();
        const std::endian order = format_ == Format::Big ? std::endian::big : std::endian::little;
        switch (type) {
            case Number::Int8:
                return bytes_.number<std::int8_t>(order);
            case Number::Uint8:
                return bytes_.number<std::uint8_t>(order);
            case Number::Int16:
                return bytes_.number<std::int16_t>(order);
            case Number::Uint16:
                return bytes_.number<std::uint16_t>(order);
            case Number::Int32:
                return bytes_.number<std::int32_t>(order);
            case Number::Uint32:
                return bytes_.number<std::uint32_t>(order);
            case Number::Float:
                return double{bytes_.number<float>(order)};
            case Number::Double:
                return bytes_.number<double>(order);
        }
        return 0.0;
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
        double value = 0.0;
        const auto [end, fault] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
        const auto length = static_cast<std::size_t>(end - text_.data());
        const bool whole = length == text_.size() || kBlank.find(text_[length]) != kBlank.npos;
        failed_ =
            failed_ || (fault != std::errc{} && fault != std::errc::result_out_of_range) || !whole;
        text_.remove_prefix(failed_ ? text_.size() : length);
        return value;
    }

    Format format_;
    std::string_view text_;
    ByteReader bytes_;
    bool failed_{false};
};

/// One line up to its end, which is cut off too.
std::string_view header_line(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = trimmed(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return line;
}

std::string read_property(std::string_view line, Header& header) {
    if (header.elements.empty()) return "a property stands before any element";
    Property property;
    std::string_view type = next_word(line);
    if (type == "list") {
        property.count = number_of(next_word(line));
        if (!property.count) return "a list's length has an unknown type";
        type = next_word(line);
    }
    const std::optional<Number> number = number_of(type);
    if (!number) return fmt::format("the type \"{}\" is unknown", type);
    property.type = *number;
    property.name = std::string(next_word(line));
    header.elements.back().properties.push_back(std::move(property));
    return header.elements.back().properties.size() > kMostProperties ? "it has too many properties"
                                                                      : "";
}

std::string read_element(std::string_view line, Header& header) {
    Element element{.name = std::string(next_word(line))};
    const std::string_view digits = next_word(line);
    const auto [end, fault] =
        std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
    if (fault != std::errc{} || end != digits.data() + digits.size()) {
        return fmt::format("element {} has no count", element.name);
    }
    if (element.count > limits::kIndices)
        return fmt::format("{} {} are too many", element.count, element.name);
    header.elements.push_back(std::move(element));
    return header.elements.size() > kMostElements ? "it has too many elements" : "";
}

std::string read_header(std::string_view bytes, Header& header) {
    if (header_line(bytes) != "ply") return "its content is not PLY";
    bool has_format = false;
    while (!bytes.empty()) {
        std::string_view line = header_line(bytes);
        const std::string_view key = next_word(line);
        std::string fault;
        if (key == "end_header") {
            if (!has_format) return "its header names no format";
            header.body = bytes;
            return {};
        }
        if (key == "format") {
            const std::string_view format = next_word(line);
            has_format = true;
            if (format == "binary_little_endian") {
                header.format = Format::Little;
            } else if (format == "binary_big_endian") {
                header.format = Format::Big;
            } else if (format != "ascii") {
                fault = fmt::format("its format \"{}\" is unknown", format);
            }
        } else if (key == "element") {
            fault = read_element(line, header);
        } else if (key == "property") {
            fault = read_property(line, header);
        }
        if (!fault.empty()) return fault;
    }
    return "its header breaks off";
}

/// The least that an element's rows take, to refuse counts that the file has no room for.
std::size_t least_bytes(const Header& header, const Element& element) {
    std::size_t bytes = 0;
    for (const Property& property : element.properties) {
        bytes +=
            header.format == Format::Text ? 2 : bytes_of(property.count.value_or(property.type));
    }
    return bytes;
}

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

struct PlyReader {
    const std::string& name;
    Values values;
    ModelMesh mesh{.name = "ply"};
    bool has_colors{false};
    bool has_normals{false};
    std::size_t bad_faces{0};
    std::string fault{};

    /// Which numbers of a vertex the element's properties fill.
    void read_vertices(const Element& element) {
        if (element.count > limits::kVertices) {
            fault = fmt::format(
                "it has {} vertices; at most {} are read", element.count, limits::kVertices);
            return;
        }
        std::size_t places = 0;
        Vertex probe;
        for (const Property& property : element.properties) {
            places += property.name.size() == 1 && slot_of(probe, property.name) != nullptr &&
                      std::string_view("xyz").find(property.name) != std::string_view::npos;
            has_normals = has_normals || property.name == "nx";
            has_colors = has_colors || slot_of(probe, property.name) == &probe.color.x;
        }
        if (places != 3) {
            fault = "its vertices have no x, y and z";
            return;
        }
        mesh.vertices.resize(element.count);
        for (Vertex& vertex : mesh.vertices) {
            vertex.normal_body = Vec3f{0.0F};
            for (const Property& property : element.properties) read_value(property, vertex);
            if (values.failed()) return;
            if (!is_finite(vertex.position_body)) {
                fault = fmt::format("vertex {} is not finite", &vertex - mesh.vertices.data());
                return;
            }
            if (!is_finite(vertex.normal_body)) vertex.normal_body = Vec3f{0.0F};
            // The image's rows run down here.
            vertex.uv = std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y)
                            ? Vec2f{vertex.uv.x, 1.0F - vertex.uv.y}
                            : Vec2f{0.0F};
        }
    }

    void read_value(const Property& property, Vertex& vertex) {
        if (property.count) {
            read_over_list(property);
            return;
        }
        const double value = values.next(property.type);
        float* slot = slot_of(vertex, property.name);
        if (slot == nullptr) return;
        *slot = static_cast<float>(value);
        const bool is_color = slot >= &vertex.color.x && slot <= &vertex.color.z;
        if (is_color) {
            const double share = std::isfinite(value) ? value / range_of(property.type) : 1.0;
            *slot = linear_from_srgb(static_cast<float>(std::clamp(share, 0.0, 1.0)));
        }
    }

    std::vector<std::uint32_t> read_list(const Property& property) {
        const double count = values.next(*property.count);
        std::vector<std::uint32_t> corners;
        if (!(count >= 0.0 && count <= 1e7)) {
            fault = "a list has an impossible length";
            return corners;
        }
        for (double i = 0; i < count && !values.failed(); ++i) {
            const double value = values.next(property.type);
            const bool fits = value >= 0.0 && value < static_cast<double>(mesh.vertices.size());
            corners.push_back(fits ? static_cast<std::uint32_t>(value) : ~0U);
        }
        return corners;
    }

    void read_over_list(const Property& property) {
        const double count = values.next(*property.count);
        for (double i = 0; i < count && !values.failed(); ++i) values.next(property.type);
    }

    void add_face(const std::vector<std::uint32_t>& corners) {
        const bool bad = std::find(corners.begin(), corners.end(), ~0U) != corners.end();
        if (bad || corners.size() < 3 || corners.size() > kMostCorners) {
            ++bad_faces;
            return;
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
            mesh.indices.insert(mesh.indices.end(), {corners[0], corners[i - 1], corners[i]});
        }
        if (mesh.indices.size() > limits::kIndices) {
            fault = fmt::format("it draws more than {} indices", limits::kIndices);
        }
    }

    void read_faces(const Element& element) {
        for (std::size_t i = 0; i < element.count && !values.failed() && fault.empty(); ++i) {
            for (const Property& property : element.properties) {
                if (!property.count) {
                    values.next(property.type);
                } else if (property.name == "vertex_indices" || property.name == "vertex_index") {
                    add_face(read_list(property));
                } else {
                    read_over_list(property);
                }
            }
        }
    }

    void read_over(const Element& element) {
        for (std::size_t i = 0; i < element.count && !values.failed(); ++i) {
            for (const Property& property : element.properties) {
                if (property.count) {
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

}  // namespace

Result<ModelData> read_ply(std::string_view bytes, const std::string& name) {
    Header header;
    std::string fault = read_header(bytes, header);
    if (!fault.empty()) return model_error(name, fault);
    PlyReader reader{.name = name, .values = Values(header.format, header.body)};
    std::size_t least = 0;
    for (const Element& element : header.elements) {
        least += element.count * least_bytes(header, element);
    }
    if (least > header.body.size() + 1) {
        return model_error(
            name,
            fmt::format(
                "its header promises {} bytes or more; {} follow", least, header.body.size()));
    }
    for (const Element& element : header.elements) {
        if (element.name == "vertex") {
            reader.read_vertices(element);
        } else if (element.name == "face") {
            reader.read_faces(element);
        } else {
            reader.read_over(element);
        }
        if (reader.fault.empty() && reader.values.failed()) {
            reader.fault = fmt::format(
                "it breaks off, or holds what is no number, in its element {}", element.name);
        }
        if (!reader.fault.empty()) return model_error(name, reader.fault);
    }
    if (reader.bad_faces > 0) {
        log_warning(
            "model {}: {} faces that name vertices it lacks, or no usable ones, are left out",
            name,
            reader.bad_faces);
    }
    if (reader.mesh.indices.empty()) return model_error(name, "it holds no triangles");
    if (!reader.has_normals) make_normals(reader.mesh);
    return model_with_z_up(std::move(reader.mesh), reader.has_colors);
}

}  // namespace plumbline::assets
