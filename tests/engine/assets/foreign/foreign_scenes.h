// assimp's scenes, made by hand.
#pragma once

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>

namespace plumbline::assets::test {

/// A triangle, named; the scene owns it.
inline aiMesh* foreign_mesh(const char* name, unsigned material) {
    auto* mesh = new aiMesh;
    mesh->mName = name;
    mesh->mMaterialIndex = material;
    mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    mesh->mNumVertices = 3;
    mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->mTextureCoords[0] = new aiVector3D[3]{{0.25F, 0.25F, 0}, {NAN, 0, 0}, {1, 1, 0}};
    mesh->mNumUVComponents[0] = 2;
    mesh->mNumFaces = 1;
    mesh->mFaces = new aiFace[1];
    mesh->mFaces[0].mNumIndices = 3;
    mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
    return mesh;
}

/// A root with two children; the second shows the meshes, which wear one plain material.
inline std::unique_ptr<aiScene> foreign_scene(std::initializer_list<aiMesh*> meshes) {
    auto scene = std::make_unique<aiScene>();
    scene->mNumMaterials = 1;
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mNumMeshes = static_cast<unsigned>(meshes.size());
    scene->mMeshes = new aiMesh*[meshes.size()];
    std::copy(meshes.begin(), meshes.end(), scene->mMeshes);
    scene->mRootNode = new aiNode("root");
    aiNode* children[]{new aiNode("first"), new aiNode("second")};
    scene->mRootNode->addChildren(2, children);
    aiNode& shown = *children[1];
    shown.mTransformation = aiMatrix4x4(1, 0, 0, 5, 0, 2, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1);
    shown.mNumMeshes = scene->mNumMeshes;
    shown.mMeshes = new unsigned[meshes.size()];
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) shown.mMeshes[i] = i;
    return scene;
}

}  // namespace plumbline::assets::test
