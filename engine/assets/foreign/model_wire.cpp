#include "engine/assets/foreign/model_wire.h"

#include "engine/assets/byte_reader.h"

#include <type_traits>

namespace plumbline::assets {
namespace {

/// Both directions visit the same fields in the same order: see `visit` below.
class WireWriter {
public:
    std::string bytes;

    template <class T>
    void plain(const T& value) {
        bytes.append(static_cast<const char*>(static_cast<const void*>(&value)), sizeof(T));
    }
    template <class T>
    void block(const std::vector<T>& values) {
        plain(std::uint64_t{values.size()});
        bytes.append(static_cast<const char*>(static_cast<const void*>(values.data())),
                     values.size() * sizeof(T));
    }
    void text(const std::string& value) {
        plain(std::uint64_t{value.size()});
        bytes += value;
    }
    template <class T, class Fn>
    void list(const std::vector<T>& values, Fn&& each) {
        plain(std::uint64_t{values.size()});
        for (const T& value : values) each(value);
    }
    bool failed() const { return false; }
};

class WireReader {
public:
    explicit WireReader(std::string_view bytes) : reader_(bytes) {}

    template <class T>
    void plain(T& value) {
        const std::string_view raw = reader_.take(sizeof(T));
        if (raw.size() == sizeof(T)) {
            std::memcpy(static_cast<void*>(&value), raw.data(), sizeof(T));
        }
    }
    template <class T>
    void block(std::vector<T>& values) {
        const std::size_t count = length(sizeof(T));
        values.resize(count);
        const std::string_view raw = reader_.take(count * sizeof(T));
        if (count > 0) std::memcpy(static_cast<void*>(values.data()), raw.data(), raw.size());
    }
    void text(std::string& value) { value = std::string(reader_.take(length(1))); }
    template <class T, class Fn>
    void list(std::vector<T>& values, Fn&& each) {
        const std::size_t count = length(1);
        for (std::size_t i = 0; i < count && !failed(); ++i) each(values.emplace_back());
    }
    bool failed() const { return reader_.failed(); }
    std::size_t left() const { return reader_.left(); }

private:
    /// A count that the bytes left have room for.
    std::size_t length(std::size_t element_bytes) {
        std::uint64_t count = 0;
        plain(count);
        if (count > reader_.left() / element_bytes) {
            reader_.take(reader_.left() + 1);  // fails
            return 0;
        }
        return count;
    }

    ByteReader reader_;
};

template <class Archive, class Optional>
void visit_number(Archive& archive, Optional& value) {
    constexpr std::uint32_t kNone = ~0U;
    std::uint32_t number = value.value_or(kNone);
    archive.plain(number);
    if constexpr (!std::is_const_v<Optional>) {
        value = number == kNone ? std::nullopt : std::optional(number);
    }
}

template <class Archive, class Flag>
void visit_flag(Archive& archive, Flag& flag) {
    std::uint8_t byte = flag ? 1 : 0;
    archive.plain(byte);
    if constexpr (!std::is_const_v<Flag>) flag = byte != 0;
}

template <class Archive, class Path>
void visit_path(Archive& archive, Path& path) {
    std::string name = path.string();
    archive.text(name);
    if constexpr (!std::is_const_v<Path>) path = name;
}

template <class Archive, class Material>
void visit_material(Archive& archive, Material& material) {
    archive.text(material.name);
    archive.plain(material.shading);
    archive.plain(material.base_color);
    archive.plain(material.alpha);
    archive.plain(material.emissive);
    visit_path(archive, material.base_color_map);
    visit_path(archive, material.normal_map);
    visit_path(archive, material.emissive_map);
    archive.plain(material.roughness);
    archive.plain(material.metallic);
    archive.plain(material.occlusion);
    visit_flag(archive, material.vertex_colors);
    archive.plain(material.alpha_mode);
    archive.plain(material.alpha_cutoff);
    visit_flag(archive, material.two_sided);
}

template <class Archive, class Mesh>
void visit_mesh(Archive& archive, Mesh& mesh) {
    archive.text(mesh.name);
    archive.plain(mesh.material);
    archive.block(mesh.vertices);
    archive.block(mesh.indices);
    archive.block(mesh.influences);
    archive.list(mesh.targets, [&](auto& target) {
        archive.block(target.positions);
        archive.block(target.normals);
    });
}

template <class Archive, class Animation>
void visit_animation(Archive& archive, Animation& animation) {
    archive.text(animation.name);
    archive.plain(animation.duration_s);
    archive.list(animation.channels, [&](auto& channel) {
        archive.plain(channel.node);
        archive.plain(channel.path);
        archive.plain(channel.interpolation);
        archive.block(channel.times_s);
        archive.block(channel.values);
    });
}

template <class Archive, class Model>
void visit(Archive& archive, Model& model) {
    archive.list(model.nodes, [&](auto& node) {
        archive.text(node.name);
        visit_number(archive, node.parent);
        visit_number(archive, node.skin);
        archive.plain(node.parent_from_node);
        archive.plain(node.rest);
        archive.block(node.meshes);
        archive.block(node.morph_weights);
    });
    archive.list(model.meshes, [&](auto& mesh) { visit_mesh(archive, mesh); });
    archive.list(model.materials, [&](auto& material) { visit_material(archive, material); });
    archive.list(model.skins, [&](auto& skin) {
        archive.block(skin.joints);
        archive.block(skin.joint_from_mesh);
    });
    archive.list(model.animations, [&](auto& animation) { visit_animation(archive, animation); });
    archive.list(model.images, [&](auto& image) {
        visit_path(archive, image.name);
        archive.text(image.bytes);
    });
}

/// Values of enumerations and switches that no writer of ours makes.
bool has_strange_values(const ModelData& model) {
    for (const MaterialData& material : model.materials) {
        if (material.shading > Shading::Unlit || material.alpha_mode > AlphaMode::Blend)
            return true;
    }
    for (const ModelAnimation& animation : model.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.path > ChannelPath::MorphWeights ||
                channel.interpolation > Interpolation::CubicSpline) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace

std::string bytes_of(const ModelData& model) {
    WireWriter writer;
    visit(writer, model);
    return std::move(writer.bytes);
}

Result<ModelData> model_of_bytes(std::string_view bytes) {
    ModelData model;
    WireReader reader(bytes);
    visit(reader, model);
    if (reader.failed() || reader.left() > 0 || has_strange_values(model)) {
        return Error{.message = "its reader's answer breaks off", .exit_code = ExitCode::Refused};
    }
    const std::string fault = fault_of(model);
    if (!fault.empty()) return Error{.message = fault, .exit_code = ExitCode::Refused};
    return model;
}

}  // namespace plumbline::assets
