// Meshes as they lie on the GPU.
#include "engine/render/resources/gpu_meshes.h"
#include "tests/engine/render/gl_fixture.h"

namespace plumbline::render {
namespace {

class GpuMeshesGl : public GlTest {
protected:
    assets::MeshId add(const std::string& name, assets::MeshData mesh) {
        return library_.add_mesh(name, std::move(mesh));
    }
    GpuMeshes meshes_{library_};
};

constexpr unsigned int kShort = 0x1403;  // GL_UNSIGNED_SHORT
constexpr unsigned int kInt = 0x1405;    // GL_UNSIGNED_INT

TEST_F(GpuMeshesGl, ACubeHas24CornersToLookAtAnd8ThatCastShadows) {
    const GpuMesh& cube = meshes_.get(add("cube", assets::box_mesh(Vec3f{1.0F})));
    EXPECT_EQ(cube.vertices.size(), 24U * 32U);
    EXPECT_EQ(cube.depth_vertices.size(), 8U * 12U);
    EXPECT_EQ(cube.indices.size(), 36U * 2U);
    EXPECT_EQ(cube.index_type, kShort);
    EXPECT_EQ(cube.wind.size(), 0U);
    EXPECT_FALSE(cube.sways);
    EXPECT_TRUE(cube.faceted) << "each triangle has one normal and one colour";
    EXPECT_EQ(cube.bytes, 24U * 32U + 8U * 12U + 2U * 36U * 2U);
    EXPECT_EQ(meshes_.bytes(), cube.bytes);
}

TEST_F(GpuMeshesGl, RoundOrManyColouredMeshesAreNotFaceted) {
    EXPECT_FALSE(meshes_.get(add("ball", assets::sphere_mesh(1.0F))).faceted);
    assets::MeshData box = assets::box_mesh(Vec3f{1.0F});
    box.vertices[0].color = Vec3f{0.0F};
    EXPECT_FALSE(meshes_.get(add("spotted", box)).faceted);
}

TEST_F(GpuMeshesGl, IndicesAreWideWhereThereAreMoreThan65535Vertices) {
    assets::MeshData mesh = assets::box_mesh(Vec3f{1.0F});
    mesh.vertices.resize(65'535);
    EXPECT_EQ(meshes_.get(add("narrow", mesh)).index_type, kShort);
    mesh.vertices.resize(65'536);
    const GpuMesh& wide = meshes_.get(add("wide", mesh));
    EXPECT_EQ(wide.index_type, kInt);
    EXPECT_EQ(wide.indices.size(), 36U * 4U);
    EXPECT_EQ(wide.depth_index_type, kShort) << "those that are left over are one place";
}

TEST_F(GpuMeshesGl, WhatSwaysHasAWeightForEveryVertex) {
    assets::MeshData mesh = assets::box_mesh(Vec3f{1.0F});
    mesh.vertices[3].wind.sway = 1;
    const GpuMesh& leaf = meshes_.get(add("leaf", mesh));
    EXPECT_TRUE(leaf.sways);
    EXPECT_EQ(leaf.wind.size(), 24U * sizeof(assets::WindWeights));
}

TEST_F(GpuMeshesGl, AnotherVersionIsUploadedAgainWithoutCoarserOnes) {
    const assets::MeshId id = add("cube", assets::box_mesh(Vec3f{1.0F}));
    const std::uint32_t version = meshes_.get(id).version;
    const std::size_t bytes = meshes_.bytes();
    for (assets::Vertex& vertex : library_.change_mesh(id).vertices) vertex.position_body *= 2.0F;
    const GpuMesh& again = meshes_.get(id);
    EXPECT_NE(again.version, version);
    EXPECT_EQ(again.depth_vertices.size(), 24U * 12U) << "what changes is not merged";
    EXPECT_EQ(meshes_.bytes(), bytes + 16U * 12U);
}

TEST_F(GpuMeshesGl, CoarserVersionsAreMadeFromWhenTheyAreAskedFor) {
    const assets::MeshId ball = add("ball", assets::sphere_mesh(1.0F));
    const std::size_t plain = meshes_.get(ball).bytes;
    EXPECT_TRUE(meshes_.lods().empty());
    meshes_.make_lods();
    EXPECT_EQ(meshes_.bytes(), 0U) << "with their next use";
    EXPECT_GT(meshes_.get(ball).bytes, plain);
    ASSERT_TRUE(meshes_.lods().contains(ball));
    const std::size_t made = meshes_.bytes();
    meshes_.make_lods();
    EXPECT_EQ(meshes_.bytes(), made) << "once";
    meshes_.clear();
    EXPECT_TRUE(meshes_.lods().empty());
}

TEST_F(GpuMeshesGl, ManyAreLoadedAtOnceAndEachIsTold) {
    std::vector<MeshRequest> requests;
    for (int i = 0; i < 9; ++i)
        requests.push_back({.id = add("box " + std::to_string(i), assets::box_mesh(Vec3f{1.0F}))});
    requests.push_back(requests.front());
    int told = 0;
    meshes_.load(requests, [&] { ++told; });
    EXPECT_EQ(told, 10);
    EXPECT_EQ(meshes_.bytes(), 9 * meshes_.get(requests[0].id).bytes);
}

}  // namespace
}  // namespace plumbline::render
