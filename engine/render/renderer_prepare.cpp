// All that a frame needs, uploaded and compiled before it is drawn.
#include "engine/render/renderer_impl.h"

#include <algorithm>
#include <set>

namespace plumbline::render {

void Renderer::prepare(const RenderFrame& frame, const std::function<void(float share)>& tell) {
    Impl& r = *impl_;
    const std::optional<FrameSetup> setup = r.set_up_frame(frame);
    if (!setup) return;
    std::vector<MeshRequest> meshes;
    std::vector<TextureRequest> textures;
    std::set<std::pair<assets::MeshId, FeatureSet>> looks;
    bool has_mask = false;
    for (const DrawItem& item : frame.items) {
        if (item.mesh.value == 0) continue;
        meshes.push_back({item.mesh, materials_of(frame, item)});
        for (const assets::MaterialId id : materials_of(frame, item)) {
            if (id.value == 0) continue;
            const auto& material = r.scene.library.material(id);
            const auto& wanted = r.scene.materials.textures(id);
            textures.insert(textures.end(), wanted.begin(), wanted.end());
            looks.emplace(item.mesh, r.scene.materials.features(id));
            has_mask = has_mask || material.alpha_mode == assets::AlphaMode::Mask;
        }
    }
    // Each mesh, shader and image counts alike.
    float done = 0.0F;
    const auto total = static_cast<float>(meshes.size() + 2 * looks.size() + textures.size());
    const auto on_each = [&] {
        if (tell) tell(std::min((done += 1.0F) / total, 1.0F));
    };
    r.scene.meshes.load(meshes, on_each);
    r.scene.smooth_looks.clear();
    for (const auto& [mesh, look] : looks) {
        if (!r.scene.meshes.get(mesh).faceted) r.scene.smooth_looks.insert(look);
    }
    std::set<FeatureSet> variants;
    for (const auto& [mesh, look] : looks) {
        const FeatureSet features = features_with(setup->features, r.scene.meshes.get(mesh));
        for (const FeatureSet used : {features, features & ~kFlashlightFeatures})
            variants.insert(variant_of(look, used, r.scene.smooth_looks));
    }
    done = static_cast<float>(meshes.size());
    for (const FeatureSet variant : variants) {
        r.scene.shaders.find(kMeshShader, variant);
        on_each();
    }
    const bool has_shadows =
        !setup->sun.shadow_views.empty() || setup->flashlight.shadow || setup->lamps.shadow_px > 0;
    if (has_shadows) {
        r.scene.shaders.find(kDepthShader, 0);
        if (has_mask) r.scene.shaders.find(kDepthShader, depth_feature::kAlphaMask);
    }
    if (DropPass::has_work(frame)) r.scene.shaders.find(kDropShader, 0);
    // Fog may be switched on in any frame.
    r.scene.shaders.find(kFogShader, 0);
    done = total - static_cast<float>(textures.size());
    r.scene.textures.load(textures, on_each);
}

}  // namespace plumbline::render
