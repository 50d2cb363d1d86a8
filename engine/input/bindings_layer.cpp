#include "engine/input/bindings_layer.h"

#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/core/text/split.h"
#include "engine/core/text/toml_prescan.h"
#include "engine/input/tuning_keys.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::input {
namespace {

constexpr int kFormat = 1;

constexpr auto kGroups = std::to_array<ActionGroup>({ActionGroup::Walk,
                                                     ActionGroup::Things,
                                                     ActionGroup::View,
                                                     ActionGroup::Light,
                                                     ActionGroup::CameraPath,
                                                     ActionGroup::Time,
                                                     ActionGroup::Menu});

std::vector<std::string_view> top_keys() {
    std::vector<std::string_view> keys{"format", "profile", "tuning", "hold"};
    for (const ActionGroup group : kGroups) keys.push_back(group_name(group));
    return keys;
}

SourceLocation location_of(const toml::source_region& region) {
    return {.file = {},
            .line = static_cast<int>(region.begin.line),
            .column = static_cast<int>(region.begin.column)};
}

std::string quote_nearest(std::string_view word, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_name(word, known);
    return nearest.empty() ? std::string{} : fmt::format(" Nearest: \"{}\".", nearest);
}

std::vector<std::string_view> action_names(std::optional<ActionGroup> group) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!group || group_of(action) == *group) names.push_back(action_name(action));
    }
    return names;
}

/// What stands there, for messages: "nan", "\"wide\"", "an array".
std::string words_for(const toml::node& node) {
    if (const auto* text = node.as_string()) return fmt::format("\"{}\"", text->get());
    if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (node.is_table()) return "a table";
    if (node.is_array()) return "an array";
    return "a date or time";
}

class LayerReader {
public:
    LayerReader(const std::string& file, Tuning& tuning, Diagnostics& faults)
        : file_(file), tuning_(tuning), faults_(faults) {}

    LayerContent read(const toml::table& root) {
        for (const auto& [key, node] : root) read_top(key, node);
        std::ranges::sort(content_.lines, [](const LayerLine& a, const LayerLine& b) {
            return std::pair{a.location.line, a.location.column} <
                   std::pair{b.location.line, b.location.column};
        });
        return std::move(content_);
    }

private:
    template <class... Args>
    void report(Severity severity,
                const toml::source_region& place,
                fmt::format_string<Args...> format,
                Args&&... args) {
        const SourceLocation at = location_of(place);
        std::string message = fmt::format(format, std::forward<Args>(args)...);
        faults_.add({severity, file_, at.line, at.column, {}, std::move(message)});
    }
    template <class... Args>
    void warn(const toml::key& key, fmt::format_string<Args...> format, Args&&... args) {
        report(Severity::Warning, key.source(), format, std::forward<Args>(args)...);
    }
    template <class... Args>
    void refuse(const toml::node& node, fmt::format_string<Args...> format, Args&&... args) {
        report(Severity::Error, node.source(), format, std::forward<Args>(args)...);
    }

    void read_top(const toml::key& key, const toml::node& node) {
        const std::string_view name = key.str();
        if (name == "format") return read_format(node);
        if (name == "profile") return read_profile(node);
        const auto* const group = std::ranges::find(kGroups, name, group_name);
        const bool is_known = group != kGroups.end() || name == "tuning" || name == "hold";
        if (!is_known) {
            const std::string nearest = quote_nearest(name, top_keys());
            if (node.is_table()) return warn(key, "no table [{}].{} Table ignored.", name, nearest);
            return warn(key, "no key \"{}\" here.{} Line ignored.", name, nearest);
        }
        const toml::table* table = node.as_table();
        if (table == nullptr)
            return refuse(node, "[{}] is a table, not {}. Ignored.", name, words_for(node));
        for (const auto& [entry_key, entry] : *table) {
            if (name == "tuning") {
                read_tuning(entry_key, entry);
            } else if (name == "hold") {
                read_hold(entry_key, entry);
            } else {
                read_action(*group, entry_key, entry);
            }
        }
    }

    void read_format(const toml::node& node) {
        const auto* number = node.as_integer();
        if (number == nullptr || number->get() < 1)
            return refuse(node, "format = {}: 1 is expected. Read as 1.", words_for(node));
        if (number->get() <= kFormat) return;
        report(Severity::Warning,
               node.source(),
               "format {} is newer than {}: what this program knows is read.",
               number->get(),
               kFormat);
    }

    void read_profile(const toml::node& node) {
        if (const auto* name = node.as_string()) {
            content_.profile = name->get();
        } else {
            refuse(node, "profile = {}: a name in quotes is expected. Ignored.", words_for(node));
        }
    }

    void read_tuning(const toml::key& key, const toml::node& node) {
        const TuningKey* entry = find_tuning_key(key.str());
        if (entry == nullptr) {
            return warn(key,
                        "no key \"{}\" in [tuning].{} Line ignored.",
                        key.str(),
                        quote_nearest(key.str(), tuning_key_names()));
        }
        if (entry->flag != nullptr) {
            if (const auto* flag = node.as_boolean()) {
                tuning_.*entry->flag = flag->get();
                return;
            }
            return refuse(node,
                          "{} = {}: true or false is expected. {} is used.",
                          key.str(),
                          words_for(node),
                          tuning_.*entry->flag);
        }
        // Written so that nan fails too.
        const std::optional<double> number =
            node.is_number() ? node.value<double>() : std::optional<double>{};
        if (number && *number >= entry->min && *number <= entry->max) {
            tuning_.*entry->number = static_cast<float>(*number);
            return;
        }
        refuse(node,
               "{} = {}: a number from {} to {} is expected. {} is used.",
               key.str(),
               words_for(node),
               entry->min,
               entry->max,
               tuning_.*entry->number);
    }

    void read_hold(const toml::key& key, const toml::node& node) {
        const std::optional<Action> action = action_from_name(key.str());
        if (!action || *action == Action::Look) {
            std::vector<std::string_view> names = action_names({});
            std::erase(names, action_name(Action::Look));
            return warn(key,
                        "no action \"{}\" in [hold].{} Line ignored.",
                        key.str(),
                        quote_nearest(key.str(), names));
        }
        const std::string mode = node.value<std::string>().value_or("");
        if (mode == "hold" || mode == "toggle") {
            content_.holds.push_back({*action, mode == "hold" ? HoldMode::Hold : HoldMode::Toggle});
            return;
        }
        refuse(node,
               "{} = {}: \"hold\" or \"toggle\" is expected. Line ignored.",
               key.str(),
               words_for(node));
    }

    void read_action(ActionGroup group, const toml::key& key, const toml::node& node) {
        const std::optional<Action> action = action_from_name(key.str());
        if (!action) {
            std::string nearest = quote_nearest(key.str(), action_names(group));
            if (nearest.empty()) nearest = quote_nearest(key.str(), action_names({}));
            return warn(key,
                        "no action \"{}\" in [{}].{} Line ignored.",
                        key.str(),
                        group_name(group),
                        nearest);
        }
        if (group_of(*action) != group) {
            warn(key,
                 "action \"{}\" belongs in [{}], not [{}]. It is taken all the same.",
                 key.str(),
                 group_name(group_of(*action)),
                 group_name(group));
        }
        LayerLine line{
            .action = *action, .location = location_of(key.source()), .inputs = {}, .faults = {}};
        if (const toml::array* list = node.as_array()) {
            for (const toml::node& entry : *list) read_entry(line, entry);
        } else {
            read_entry(line, node);
        }
        content_.lines.push_back(std::move(line));
    }

    void read_entry(LayerLine& line, const toml::node& node) {
        const SourceLocation location = location_of(node.source());
        const auto* word = node.as_string();
        if (word == nullptr) {
            line.faults.push_back(
                {location, fmt::format("an input is a word in quotes, not {}", words_for(node))});
            return;
        }
        Result<Input> input = parse_input(word->get());
        if (!input) {
            line.faults.push_back({location, input.error().message});
            return;
        }
        if (input->word != word->get())
            content_.aliases.push_back(fmt::format("{}:{}: \"{}\" is called \"{}\" here",
                                                   file_,
                                                   location.line,
                                                   word->get(),
                                                   input->word));
        line.inputs.push_back({*input, location});
    }

    const std::string& file_;
    Tuning& tuning_;
    Diagnostics& faults_;
    LayerContent content_;
};

}  // namespace

std::optional<LayerContent> read_layer(const BindingLayer& layer,
                                       Tuning& tuning,
                                       Diagnostics& faults) {
    const auto refuse = [&](SourceLocation location, std::string_view why) {
        faults.add({Severity::Error,
                    layer.name,
                    location.line,
                    location.column,
                    {},
                    fmt::format("{}. The whole file is left out.", why)});
    };
    if (layer.text.size() > limits::kConfigFileBytes) {
        refuse({}, fmt::format("larger than {} bytes", limits::kConfigFileBytes));
        return std::nullopt;
    }
    if (const std::optional<TextFault> fault = prescan_toml(layer.text)) {
        refuse({.file = {}, .line = fault->line, .column = fault->column}, fault->message);
        return std::nullopt;
    }
    try {
        const toml::table root = toml::parse(layer.text);
        return LayerReader(layer.name, tuning, faults).read(root);
    } catch (const toml::parse_error& error) {
        refuse(location_of(error.source()), error.description());
    }
    return std::nullopt;
}

std::optional<LayerLine> read_bind_option(std::string_view option, Diagnostics& faults) {
    std::string_view rest = option;
    const std::string_view name = cut_part(rest, '=');
    if (name.size() == option.size()) {
        faults.add_error("--bind", fmt::format("\"{}\" is not action=key[,key]. Ignored.", option));
        return std::nullopt;
    }
    const std::optional<Action> action = action_from_name(name);
    if (!action) {
        faults.add_error(
            "--bind",
            fmt::format(
                "no action \"{}\".{} Ignored.", name, quote_nearest(name, action_names({}))));
        return std::nullopt;
    }
    LayerLine line{.action = *action, .location = {}, .inputs = {}, .faults = {}};
    while (!rest.empty()) {
        Result<Input> input = parse_input(cut_part(rest, ','));
        if (input) {
            line.inputs.push_back({*input, {}});
        } else {
            line.faults.push_back({{}, input.error().message});
        }
    }
    return line;
}

}  // namespace plumbline::input
