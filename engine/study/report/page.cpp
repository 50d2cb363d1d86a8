#include "engine/study/report/page.h"

#include "engine/core/io/files.h"
#include "engine/study/findings/findings_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace plumbline::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 16 * 1024 * 1024;
constexpr std::string_view kFindings = "findings.json";
constexpr std::string_view kPeers = "peers.csv";

/// JSON that no text of which can end the element it stands in: "<" is escaped, which only strings
/// of JSON hold.
std::string escaped_json(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    for (const char letter : json) {
        if (letter == '<') {
            out += "\\u003c";
        } else {
            out += letter;
        }
    }
    return out;
}

/// The heading, and the lines of the scenes.
std::string peers_of(std::string_view csv, std::span<const std::string> scenes) {
    std::string out(csv.substr(0, csv.find('\n') + 1));
    for (std::size_t begin = out.size(); begin < csv.size();) {
        const std::size_t end = std::min(csv.find('\n', begin), csv.size() - 1) + 1;
        const std::string_view line = csv.substr(begin, end - begin);
        const std::string_view scene = line.substr(0, line.find(','));
        if (std::ranges::find(scenes, scene) != scenes.end()) out += line;
        begin = end;
    }
    return out;
}

/// What stands in quotes after `key`, and the same line without it; empty where there is none.
std::string_view attribute(std::string_view line, std::string_view key) {
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return {};
    const std::string_view rest = line.substr(at + key.size());
    return rest.substr(0, rest.find('"'));
}

/// A line of the template that names a file, with the file's text in place of its name.
std::string inlined(std::string_view line, std::string_view file, const std::string& text) {
    if (line.starts_with("<link")) return fmt::format("<style>\n{}</style>\n", text);
    const std::string name = fmt::format(" src=\"{}\"", file);
    const std::size_t at = line.find(name);
    std::string tag(line.substr(0, at));
    tag += line.substr(at + name.size(), line.find('>') + 1 - at - name.size());
    return fmt::format("{}\n{}</script>\n", tag, text);
}

}  // namespace

Result<std::string> report_page(const std::string& json, std::span<const std::string> peer_scenes) {
    const Result<DataFolders> folders = find_data_folders();
    if (!folders) return folders.error();
    const fs::path folder = folders->assets / "report";
    const Result<std::string> markup = read_file(folder / "page.html", kMostBytes);
    if (!markup) return markup.error();
    std::string page;
    std::string_view rest = *markup;
    while (!rest.empty()) {
        const std::size_t length = std::min(rest.find('\n'), rest.size() - 1) + 1;
        const std::string_view line = rest.substr(0, length);
        rest.remove_prefix(length);
        const std::string_view file =
            attribute(line, line.starts_with("<link") ? "href=\"" : "src=\"");
        if (file.empty()) {
            page += line;
        } else if (file == kFindings) {
            page += inlined(line, file, escaped_json(json));
        } else {
            const Result<std::string> text = read_file(folder / file, kMostBytes);
            if (!text) return text.error();
            page +=
                inlined(line, file, file.ends_with(kPeers) ? peers_of(*text, peer_scenes) : *text);
        }
    }
    return page;
}

Result<std::string> study_page(const Findings& findings) {
    std::vector<std::string> peer_scenes;
    for (const Subject& subject : findings.subjects) {
        if (!subject.peer_scene.empty()) peer_scenes.push_back(subject.peer_scene);
    }
    return report_page(findings_to_json(findings), peer_scenes);
}

}  // namespace plumbline::study
