// assimp's view of the file system: one file, in memory, and nothing else. It never opens one.
#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace Assimp {
class Importer;
}

namespace plumbline::assets {

class ConfinedIo final : public Assimp::IOSystem {
public:
    /// The bytes must outlive this.
    ConfinedIo(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {}

    bool Exists(const char* file) const override;
    char getOsSeparator() const override { return '/'; }
    /// Null unless it is the file, to be read.
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    std::string name_;  ///< "model.fbx"
    std::string_view bytes_;
};

/// assimp registers 48 importers, and hands a file to whichever likes its bytes: these are left.
void keep_importers(Assimp::Importer& importer, std::initializer_list<std::string_view> names);

}  // namespace plumbline::assets
