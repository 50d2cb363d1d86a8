#include "engine/render/shaders/shader_source.h"

#include "engine/core/io/files.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace plumbline::render {
namespace {

constexpr int kIncludeDepth = 8;

/// The name between quotes of an `#include "name"` line; empty for any other line.
std::string_view included_name(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || line.compare(start, 8, "#include") != 0) return {};
    const std::size_t open = line.find('"', start);
    if (open == std::string_view::npos) return {};
    const std::size_t close = line.find('"', open + 1);
    if (close == std::string_view::npos) return {};
    return line.substr(open + 1, close - open - 1);
}

/// Ends text that the preprocessor may have skipped, with the `#line` in it.
bool ends_a_branch(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos) return false;
    line.remove_prefix(start);
    return line.starts_with("#endif") || line.starts_with("#el");
}

class Expander {
public:
    Expander(const std::filesystem::path& folder, std::size_t first_number, ShaderSource& source)
        : folder_(folder), first_number_(first_number), source_(source) {}

    Result<Done> expand(const std::string& file, int depth) {
        if (depth > kIncludeDepth) return Error{file + ": includes nest too deeply"};
        auto path = resolve_inside(folder_, file);
        if (!path) return path.error();
        auto content = read_file(*path, limits::kConfigFileBytes);
        if (!content) return content.error();
        const std::size_t file_index = first_number_ + source_.files.size();
        source_.files.push_back(file);
        source_.text += fmt::format("#line 1 {}\n", file_index);
        return expand_lines(*content, file, file_index, depth);
    }

private:
    Result<Done> expand_lines(std::string_view content,
                              const std::string& file,
                              std::size_t file_index,
                              int depth) {
        int line_number = 0;
        bool has_include = false;
        const auto tell_next_line = [&] {
            source_.text += fmt::format("#line {} {}\n", line_number + 1, file_index);
        };
        while (!content.empty()) {
            ++line_number;
            const std::size_t end = content.find('\n');
            const std::string_view line = content.substr(0, end);
            content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
            const std::string name{included_name(line)};
            if (name.empty()) {
                source_.text.append(line);
                source_.text += '\n';
                if (has_include && ends_a_branch(line)) tell_next_line();
                continue;
            }
            if (std::ranges::find(source_.files, name) == source_.files.end()) {
                const auto included = expand(name, depth + 1);
                if (!included) {
                    return Error{
                        fmt::format("{}:{}: {}", file, line_number, included.error().message),
                        ExitCode::NoDisplay};
                }
            }
            has_include = true;
            tell_next_line();
        }
        return Done{};
    }

    const std::filesystem::path& folder_;
    std::size_t first_number_;
    ShaderSource& source_;
};

}  // namespace

std::string defines_of(std::span<const Feature> features, FeatureSet set) {
    std::string text;
    for (const Feature& feature : features) {
        if ((set & feature) != 0) text += fmt::format("#define {} 1\n", feature.macro);
    }
    return text;
}

Result<ShaderSource> load_shader(const std::filesystem::path& folder,
                                 std::string_view file,
                                 std::string_view defines,
                                 std::size_t first_number) {
    ShaderSource source;
    source.text = "#version 330 core\n";
    source.text += defines;
    const auto expanded = Expander(folder, first_number, source).expand(std::string{file}, 0);
    if (!expanded) {
        return Error{fmt::format("shader {}: {}", file, expanded.error().message),
                     ExitCode::NoDisplay};
    }
    return source;
}

std::string with_file_names(std::string_view driver_log, const std::vector<std::string>& files) {
    static const std::regex place{
        R"((^|\n)(ERROR: |WARNING: )?(\d+)(?::|\()(\d+)(?:\(\d+\)|\))?\s*:?)"};
    const std::string log{driver_log};
    std::string named;
    auto copied_to = log.cbegin();
    for (std::sregex_iterator match(log.begin(), log.end(), place), end; match != end; ++match) {
        const auto& m = *match;
        // More digits than a source number can have is no source number.
        const std::size_t index = m[3].length() < 4 ? std::stoul(m[3].str()) : files.size();
        if (index >= files.size()) continue;
        named.append(copied_to, m[0].first);
        named += fmt::format("{}{}{}:{}:", m[1].str(), m[2].str(), files[index], m[4].str());
        copied_to = m[0].second;
    }
    named.append(copied_to, log.cend());
    return named;
}

}  // namespace plumbline::render
