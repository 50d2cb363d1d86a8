#include "engine/assets/foreign/confined_io_impl.h"

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>

#include <algorithm>
#include <cstring>

namespace plumbline::assets {
namespace {

class MemoryStream final : public Assimp::IOStream {
public:
    explicit MemoryStream(std::string_view bytes) : bytes_(bytes) {}

    std::size_t Read(void* target, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t whole = std::min(count, (bytes_.size() - place_) / size);
        if (whole > 0) std::memcpy(target, bytes_.data() + place_, whole * size);
        place_ += whole * size;
        return whole;
    }
    std::size_t Write(const void* /*source*/,
                      std::size_t /*size*/,
                      std::size_t /*count*/) override {
        return 0;
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        std::size_t start = 0;
        if (origin == aiOrigin_CUR) start = place_;
        if (origin == aiOrigin_END) start = bytes_.size();
        const std::size_t target = start + offset;  // wraps for steps back, as callers mean it
        if (target > bytes_.size()) return aiReturn_FAILURE;
        place_ = target;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return place_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    std::string_view bytes_;
    std::size_t place_{0};
};

/// assimp may put its idea of a folder in front.
std::string plain_name(std::string_view file) {
    const std::size_t slash = file.find_last_of("/\\");
    return std::string(slash == std::string_view::npos ? file : file.substr(slash + 1));
}

}  // namespace

bool ConfinedIo::Exists(const char* file) const {
    return plain_name(file) == name_;
}

Assimp::IOStream* ConfinedIo::Open(const char* file, const char* mode) {
    if (mode == nullptr || *mode != 'r' || plain_name(file) != name_) return nullptr;
    return new MemoryStream(bytes_);
}

void keep_importers(Assimp::Importer& importer, std::initializer_list<std::string_view> names) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string_view name = importer.GetImporterInfo(i)->mName;
        if (std::ranges::find(names, name) != names.end()) continue;
        Assimp::BaseImporter* unwanted = importer.GetImporter(i);
        importer.UnregisterLoader(unwanted);
        delete unwanted;
    }
}

}  // namespace plumbline::assets
