#include "engine/assets/model/model_references.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::assets {
namespace {

namespace fs = std::filesystem;

/// Which rule a reference breaks by its text alone; empty when none.
std::string_view textual_fault(std::string_view reference) {
    if (reference.empty()) return "names no file";
    if (reference.find('\0') != std::string_view::npos) return "holds a NUL byte";
    if (reference.front() == '/') return "is absolute; paths are relative";
    if (reference.find('\\') != std::string_view::npos) return "holds a backslash";
    if (reference.find(':') != std::string_view::npos) {
        return "names a drive or a URL; paths are relative";
    }
    int depth = 0;
    for (const fs::path& part : fs::path(std::string(reference))) {
        if (part == "..") {
            --depth;
        } else if (part != "." && !part.empty()) {
            ++depth;
        }
        if (depth < 0) return "leads out of its folder";
    }
    return {};
}

int hex_value(char digit) {
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
    if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
    return -1;
}

int base64_value(char digit) {
    if (digit >= 'A' && digit <= 'Z') return digit - 'A';
    if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
    if (digit >= '0' && digit <= '9') return digit - '0' + 52;
    if (digit == '+') return 62;
    if (digit == '/') return 63;
    return -1;
}

}  // namespace

Result<fs::path> ModelReferences::resolve(std::string_view reference,
                                          std::string_view field,
                                          const fs::path& folder) {
    const auto refuse = [&](std::string_view why) {
        return Error{.message = fmt::format("{}: \"{}\" {}", field, reference, why),
                     .exit_code = ExitCode::Refused};
    };
    if (++count_ > limits::kReferencedFiles) {
        return Error{.message = fmt::format(
                         "{}: more than {} files are named", field, limits::kReferencedFiles),
                     .exit_code = ExitCode::Refused};
    }
    const std::string_view fault = textual_fault(reference);
    if (!fault.empty()) return refuse(fault);
    const fs::path& base = folder.empty() ? folder_ : folder;
    const fs::path full = (base / fs::path(std::string(reference))).lexically_normal();
    if (!is_inside(root_, full)) return refuse("leads out of the root folder through a link");
    std::error_code ignored;
    const fs::file_status status = fs::status(full, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) return refuse("is no regular file");
    return full;
}

fs::path ModelReferences::find_image(std::string_view reference) {
    std::string text(reference.starts_with("file://") ? reference.substr(7) : reference);
    std::replace(text.begin(), text.end(), '\\', '/');
    const std::string last = fs::path(text).filename().string();
    for (const std::string& place : {text, last, "textures/" + last}) {
        const Result<fs::path> file = resolve(place, "image");
        std::error_code failed;
        if (file && fs::is_regular_file(*file, failed)) return *file;
    }
    return {};
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        if (i + 2 >= text.size()) return std::nullopt;
        const int high = hex_value(text[i + 1]);
        const int low = hex_value(text[i + 2]);
        if (high < 0 || low < 0 || high + low == 0) return std::nullopt;
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return decoded;
}

std::optional<std::string> base64_decoded(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    std::size_t padding = 0;
    while (padding < 2 && text.ends_with('=')) {
        text.remove_suffix(1);
        ++padding;
    }
    std::string decoded;
    decoded.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned bit_count = 0;
    for (const char digit : text) {
        const int value = base64_value(digit);
        if (value < 0) return std::nullopt;
        bits = (bits << 6U | static_cast<std::uint32_t>(value)) & 0xFFFFU;
        bit_count += 6;
        if (bit_count < 8) continue;
        bit_count -= 8;
        decoded += static_cast<char>(static_cast<std::uint8_t>(bits >> bit_count));
    }
    return decoded;
}

}  // namespace plumbline::assets
