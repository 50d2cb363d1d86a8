// assimp's view of the file system: the files of one CheckedModel, in memory, and nothing else.
// It never opens a file: what a model names was resolved, confined to its root, and read before.
#pragma once

#include "engine/assets/checked_model.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include <initializer_list>
#include <string_view>

namespace Assimp {
class Importer;
}

namespace plumbline::assets {

class ConfinedIo final : public Assimp::IOSystem {
public:
    /// `model` must outlive this.
    explicit ConfinedIo(const CheckedModel& model) : model_(model) {}

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    /// Null unless the model has the file and it is to be read.
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    const CheckedModel& model_;
};

/// assimp registers 48 importers, and hands a file to whichever likes its bytes: these are left.
void keep_importers(Assimp::Importer& importer, std::initializer_list<std::string_view> names);

}  // namespace plumbline::assets
