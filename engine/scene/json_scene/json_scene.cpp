// Scenes of the viewer: a camera and meshes in JSON, as homework viewers exchange them.
#include "engine/core/hash.h"
#include "engine/core/io/files.h"
#include "engine/core/limits.h"
#include "engine/core/text/printable.h"
#include "engine/scene/formats/json_read.h"
#include "engine/scene/json_scene/json_scene_impl.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plumbline::scene {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

// One light as lectures have it, from (1, 1, 1): see SceneDescription::sun for its unit.
constexpr float kLightIntensity = 3.14159265F;
constexpr float kLightAmbient = 0.1F;
constexpr float kLightSpecular = 0.5F;
constexpr float kLightShininess = 32.0F;

/// An image beside the mesh whose name begins as the mesh's does: the nearest in length. A longer
/// mesh name that fits it better takes it.
fs::path image_beside(const fs::path& mesh, const fs::path& root) {
    constexpr std::array<std::string_view, 3> kImages{".png", ".jpg", ".jpeg"};
    const std::string stem = mesh.stem().string();
    std::vector<fs::path> images;
    std::vector<std::string> rivals;
    std::error_code failed;
    for (fs::directory_iterator entry(mesh.parent_path(), failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const fs::path& path = entry->path();
        const std::string name = path.stem().string();
        if (!name.starts_with(stem)) continue;
        if (path.extension() == mesh.extension() && name != stem) rivals.push_back(name);
        if (std::ranges::find(kImages, path.extension().string()) != kImages.end())
            images.push_back(path);
    }
    std::erase_if(images, [&](const fs::path& image) {
        const std::string name = image.stem().string();
        return std::ranges::any_of(rivals,
                                   [&](const auto& rival) { return name.starts_with(rival); }) ||
               !is_inside(root, image);
    });
    const auto nearest = std::ranges::min_element(images, [](const auto& a, const auto& b) {
        const std::string left = a.filename().string();
        const std::string right = b.filename().string();
        return std::pair{left.size(), left} < std::pair{right.size(), right};
    });
    return nearest == images.end() ? fs::path{} : *nearest;
}

/// A mesh file that was read, for all objects that name it.
struct ReadFile {
    std::shared_ptr<const JsonMesh> mesh;  ///< null: it was refused
    fs::path image;
};

class JsonSceneReader {
public:
    JsonSceneReader(const fs::path& assets_folder, const SourceLocation& location, FaultList& list)
        : assets_folder_(assets_folder), list_(list), faults_{list, location} {}

    std::optional<SceneDescription> read(const fs::path& file) {
        scene_.file = file;
        const Result<std::string> text = read_file(file, limits::kModelJsonBytes);
        if (!text) return faults_.error({}, text.error().message);
        hasher_.add(text->data(), text->size());
        scene_.source_files.push_back(file);
        const std::optional<Json> root = parse(*text);
        if (!root) return std::nullopt;
        if (!root->is_object())
            return faults_.error({}, "expected an object, found {}", root->type_name());
        read_camera(*root);
        read_background(*root);
        read_objects(*root);
        finish();
        if (list_.any_error()) return std::nullopt;
        return std::move(scene_);
    }

private:
    std::optional<Json> parse(const std::string& text) const {
        if (is_utf16(text)) return faults_.error({}, std::string(kUtf16Fault));
        try {
            return read_json<Json>(text);
        } catch (const Json::parse_error& fault) {
            const std::size_t end = std::min(fault.byte, text.size());
            const auto lines =
                std::count(text.begin(), text.begin() + static_cast<long>(end), '\n');
            const std::size_t start = text.rfind('\n', end == 0 ? 0 : end - 1);
            const std::size_t column = start == std::string::npos ? end : end - start - 1;
            std::string message = fault.what();
            const std::size_t colon = message.find(": ");
            if (colon != std::string::npos) message.erase(0, colon + 2);
            list_.error({faults_.file.file, static_cast<int>(lines) + 1, static_cast<int>(column)},
                        {},
                        "this is no JSON: " + message);
        } catch (const std::exception& fault) {
            std::string message = fault.what();
            const std::size_t bracket = message.find("] ");
            if (bracket != std::string::npos) message.erase(0, bracket + 2);
            faults_.error({}, message);
        }
        return std::nullopt;
    }

    void read_resolution(const Json& camera) {
        const Json* value = member_of(camera, "resolution");
        if (value == nullptr) {
            faults_.error("camera.resolution", "missing; expected [width, height] in pixels");
            return;
        }
        const auto sides = json_numbers(*value, 2, "camera.resolution", faults_);
        if (!sides) return;
        for (const double side : *sides) {
            if (side >= 1 && side <= limits::kImageSide && side == std::floor(side)) continue;
            faults_.error("camera.resolution",
                          "expected whole numbers from 1 to {}, found {}",
                          limits::kImageSide,
                          side);
            return;
        }
        viewer_.width_px = static_cast<int>((*sides)[0]);
        viewer_.height_px = static_cast<int>((*sides)[1]);
    }

    void read_camera(const Json& root) {
        const Json* camera = member_of(root, "camera");
        if (camera == nullptr || !camera->is_object()) {
            faults_.error("camera",
                          camera == nullptr
                              ? "missing; expected an object with resolution and transform"
                              : fmt::format("expected an object, found {}", camera->type_name()));
            return;
        }
        read_resolution(*camera);
        const double tangent = json_positive(*camera, "s", 1.0, "camera", faults_);
        const double near_m = json_positive(*camera, "z_near", 1e-3, "camera", faults_);
        const double far_m = json_positive(*camera, "z_far", 1e3, "camera", faults_);
        if (near_m >= far_m)
            faults_.error("camera.z_far", "{} is not beyond z_near, {}", far_m, near_m);
        const JsonTransform transform = json_transform(*camera, "camera", faults_);
        const glm::dmat3 linear{transform.matrix};
        const double volume =
            glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
        if (!(std::abs(glm::determinant(linear)) > 1e-12 * volume)) {
            faults_.error("camera.transform", "it flattens space: no image can be taken so");
            return;
        }
        const glm::dvec3 eye{transform.matrix[3]};
        const glm::dvec3 back = glm::normalize(linear[2]);
        const glm::dvec3 right = glm::normalize(glm::cross(linear[1], back));
        const glm::dvec3 up = glm::cross(back, right);
        // A camera that scales or mirrors becomes one that does not, in a world that does.
        const glm::dmat4 rigid{
            glm::dvec4{right, 0}, glm::dvec4{up, 0}, glm::dvec4{back, 0}, glm::dvec4{eye, 1}};
        const glm::dmat3 change = linear - glm::dmat3{rigid};
        const double difference =
            glm::length(change[0]) + glm::length(change[1]) + glm::length(change[2]);
        if (difference > 1e-9) ours_from_file_ = rigid * glm::inverse(transform.matrix);
        scene_.has_camera = true;
        scene_.camera = {.position_m = Vec3(eye),
                         .target_m = Vec3(eye - back),
                         .up = Vec3(up),
                         .fov_y_rad = static_cast<Real>(2.0 * portable_atan2(tangent, 1.0)),
                         .near_m = static_cast<Real>(near_m),
                         .far_m = static_cast<Real>(far_m)};
        viewer_.up = Vec3(transform.up.value_or(up));
    }

    void read_background(const Json& root) {
        scene_.camera.clear_color = Vec3f{1.0F};
        const Json* value = member_of(root, "background");
        if (value == nullptr) return;
        if (const auto color = json_vector(*value, "background", faults_))
            scene_.camera.clear_color = Vec3f{*color};
    }

    void read_objects(const Json& root) {
        const Json* objects = member_of(root, "objects");
        if (objects == nullptr || !objects->is_array()) {
            faults_.error("objects",
                          objects == nullptr
                              ? "missing; expected an array of objects"
                              : fmt::format("expected an array, found {}", objects->type_name()));
            return;
        }
        for (std::size_t i = 0; i < objects->size(); ++i) {
            const std::string path = fmt::format("objects[{}]", i);
            const Json& object = (*objects)[i];
            if (!object.is_object()) {
                faults_.error(path, "expected an object, found {}", object.type_name());
                continue;
            }
            if (!read_object(object, i, path)) return;
        }
    }

    /// False when the scene is too large to go on.
    bool read_object(const Json& object, std::size_t number, const std::string& path) {
        const JsonTransform transform = json_transform(object, path, faults_);
        ReadFile source;
        if (const Json* name = member_of(object, "filename")) {
            source = read_mesh_file(*name, path + ".filename");
        } else if (auto mesh = json_inline_mesh(object, path, faults_)) {
            source.mesh = std::make_shared<const JsonMesh>(std::move(*mesh));
        }
        if (!source.mesh || source.mesh->triangles.indices.empty()) return true;
        triangles_ += source.mesh->triangles.indices.size() / 3;
        if (triangles_ * 3 > limits::kIndices) {
            faults_.error(path,
                          "with it the scene has {} triangles; at most {} are drawn",
                          triangles_,
                          limits::kIndices / 3);
            return false;
        }
        add_entity(source, ours_from_file_ * transform.matrix, number, path);
        return true;
    }

    ReadFile read_mesh_file(const Json& name, const std::string& path) {
        if (!name.is_string()) {
            faults_.error(path, "expected text, found {}", name.type_name());
            return {};
        }
        const std::string wanted = name.get<std::string>();
        const Result<Reference> reference = find_reference(scene_.file, assets_folder_, wanted);
        if (!reference) {
            faults_.error(path, reference.error().message);
            return {};
        }
        const auto known = files_.find(reference->file);
        if (known != files_.end()) return known->second;
        ReadFile& file = files_[reference->file];
        const Result<std::string> bytes = read_file(reference->file, limits::kModelFileBytes);
        if (!bytes) {
            faults_.error(path, bytes.error().message);
            return {};
        }
        hasher_.add(bytes->data(), bytes->size());
        scene_.source_files.push_back(reference->file);
        Result<assets::ExactPly> read = assets::read_exact_ply(*bytes, shown(wanted));
        if (!read) {
            faults_.error(path, read.error().message);
            return {};
        }
        Hasher own;
        own.add(bytes->data(), bytes->size());
        if (read->has_uvs) file.image = image_beside(reference->file, reference->root);
        file.mesh = std::make_shared<const JsonMesh>(
            JsonMesh{.triangles = std::move(*read), .hash = own.digest()});
        return file;
    }

    std::string material_for(const fs::path& image, float brightest) {
        const std::string name = fmt::format("viewer {} {}", image.filename().string(), brightest);
        assets::MaterialData material{.name = name,
                                      .shading = assets::Shading::Unlit,
                                      .base_color = Vec3f{brightest},
                                      .base_color_map = image,
                                      .shininess = kLightShininess,
                                      .specular = kLightSpecular,
                                      .two_sided = true};
        scene_.materials.emplace(name, std::move(material));
        return name;
    }

    void add_entity(const ReadFile& source,
                    const glm::dmat4& matrix,
                    std::size_t number,
                    const std::string& path) {
        const glm::dmat3 linear{matrix};
        const float brightest = brightest_of(source.mesh->triangles);
        Hasher key;
        key.add(&source.mesh->hash, sizeof(source.mesh->hash));
        key.add(&linear, sizeof(linear));
        std::shared_ptr<const assets::MeshData>& mesh = meshes_[key.digest()];
        if (!mesh) {
            mesh = std::make_shared<const assets::MeshData>(
                json_mesh_data(source.mesh->triangles, linear, brightest));
        }
        const Vec3f offset{glm::dvec3{matrix[3]}};
        const Aabb& bounds = mesh->bounds;
        if (!is_finite(bounds.min + offset) || !is_finite(bounds.max + offset)) {
            faults_.error(path, "its transform takes it beyond all numbers");
            return;
        }
        bounds_.include(bounds.min + offset);
        bounds_.include(bounds.max + offset);
        EntityDescription entity;
        entity.name = fmt::format("object_{}", number);
        entity.world_from_body.position = Vec3(glm::dvec3{matrix[3]});
        entity.visual = MeshVisual{.key = "json " + hex_of(key.digest()), .mesh = mesh};
        entity.material = material_for(source.image, brightest);
        entity.location = in_file(scene_.file.filename().string());
        scene_.entities.push_back(std::move(entity));
    }

    void finish() {
        const SourceLocation location = in_file(scene_.file.filename().string());
        const Sphere sphere = sphere_around(bounds_);
        viewer_.center_m = Vec3{sphere.center};
        viewer_.radius_m = sphere.radius > 0.0F ? Real{sphere.radius} : Real{1};
        scene_.viewer = viewer_;
        scene_.title = scene_.file.stem().string();
        scene_.description = "a JSON scene";
        scene_.controls = "viewer";
        scene_.ambient.color = Vec3f{kLightAmbient};
        const Real reach_m =
            glm::distance(scene_.camera.position_m, viewer_.center_m) + 2 * viewer_.radius_m;
        scene_.sun =
            SunDescription{.direction = -glm::normalize(Vec3{1, 1, 1}),
                           .color = Vec3f{1.0F},
                           .intensity = kLightIntensity,
                           .shadow = ShadowDescription{.distance_m = reach_m, .location = location},
                           .location = location};
        scene_.content_hash = hasher_.digest();
    }

    const fs::path& assets_folder_;
    FaultList& list_;
    JsonFaults faults_;
    SceneDescription scene_;
    ViewerDescription viewer_;
    Hasher hasher_;
    glm::dmat4 ours_from_file_{1.0};
    std::map<fs::path, ReadFile> files_;
    std::map<std::uint64_t, std::shared_ptr<const assets::MeshData>> meshes_;  ///< by content
    std::size_t triangles_{0};
    Aabb bounds_;
};

}  // namespace

std::optional<SceneDescription> read_json_scene(const fs::path& file,
                                                const fs::path& assets_folder,
                                                Diagnostics& faults) {
    const std::string name = file.string();
    const SourceLocation location = in_file(name);
    FaultList list(faults);
    return JsonSceneReader(assets_folder, location, list).read(file);
}

}  // namespace plumbline::scene
