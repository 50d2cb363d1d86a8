#include "engine/core/io/saved_file.h"

#include "engine/core/hash.h"
#include "engine/core/io/archive.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

constexpr std::string_view kMagic = "PLUMSAVE";
constexpr std::size_t kShellBytes = 8 + 4 + 8 + 8;

std::uint64_t sum_of(std::string_view content) {
    Hasher hasher;
    hasher.add(content.data(), content.size());
    return hasher.digest();
}

}  // namespace

std::string shelled(std::string_view content) {
    std::uint32_t format = kSavedFormat;
    std::uint64_t size = kShellBytes + content.size();
    std::uint64_t sum = sum_of(content);
    Archive head;
    head(format, size, sum);
    std::string bytes(kMagic);
    bytes += head.written();
    bytes += content;
    return bytes;
}

Result<std::string_view> unshelled(std::string_view bytes, const std::filesystem::path& file) {
    const auto refuse = [&](const std::string& why) {
        return Error{fmt::format("{}: {}", file.generic_string(), why), ExitCode::Refused};
    };
    const std::string_view start = bytes.substr(0, kMagic.size());
    if (start != kMagic.substr(0, start.size()) || bytes.empty())
        return refuse(fmt::format("no saved game: it does not begin with \"{}\"", kMagic));
    if (bytes.size() < kShellBytes)
        return refuse(fmt::format(
            "a saved game cut short: {} bytes, its head alone has {}", bytes.size(), kShellBytes));
    std::uint32_t format = 0;
    std::uint64_t size = 0;
    std::uint64_t sum = 0;
    Archive head(bytes.substr(kMagic.size(), kShellBytes - kMagic.size()));
    head(format, size, sum);
    if (format != kSavedFormat)
        return refuse(fmt::format(
            "a saved game of format {}; this program reads format {}", format, kSavedFormat));
    if (bytes.size() < size)
        return refuse(fmt::format("a saved game cut short: {} bytes of {}", bytes.size(), size));
    if (bytes.size() > size)
        return refuse(
            fmt::format("a damaged saved game: {} bytes, it should have {}", bytes.size(), size));
    const std::string_view content = bytes.substr(kShellBytes);
    if (const std::uint64_t found = sum_of(content); found != sum)
        return refuse(fmt::format("a damaged saved game: its checksum is {}, it should be {}",
                                  hex_of(found),
                                  hex_of(sum)));
    return content;
}

}  // namespace plumbline
