#include "engine/input/bindings_layer.h"

#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/core/text/toml_prescan.h"
#include "engine/input/tuning_keys.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

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

constexpr auto kTopKeys = std::to_array<std::string_view>({"format",
                                                           "profile",
                                                           "tuning",
                                                           "hold",
                                                           "walk",
                                                           "things",
                                                           "view",
                                                           "light",
                                                           "camera_path",
                                                           "time",
                                                           "menu"});

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
    void report(Severity severity, SourceLocation location, std::string message) {
        faults_.add({severity, file_, location.line, location.column, {}, std::move(message)});
    }

    void read_top(const toml::key& key, const toml::node& node) {
        const std::string_view name = key.str();
        if (name == "format") return read_format(node);
        if (name == "profile") return read_profile(node);
        const auto* const group = std::ranges::find(kGroups, name, group_name);
        const bool is_known = group != kGroups.end() || name == "tuning" || name == "hold";
        if (!is_known) {
            report(Severity::Warning,
                   location_of(key.source()),
                   node.is_table()
                       ? fmt::format(
                             "no table [{}].{} Table ignored.", name, quote_nearest(name, kTopKeys))
                       : fmt::format("no key \"{}\" here.{} Line ignored.",
                                     name,
                                     quote_nearest(name, kTopKeys)));
            return;
        }
        const toml::table* table = node.as_table();
        if (table == nullptr) {
            report(Severity::Error,
                   location_of(node.source()),
                   fmt::format("[{}] is a table, not {}. Ignored.", name, words_for(node)));
            return;
        }
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
        if (number == nullptr || number->get() < 1) {
            report(Severity::Error,
                   location_of(node.source()),
                   fmt::format("format = {}: 1 is expected. Read as 1.", words_for(node)));
        } else if (number->get() > kFormat) {
            report(Severity::Warning,
                   location_of(node.source()),
                   fmt::format("format {} is newer than {}: what this program knows is read.",
                               number->get(),
                               kFormat));
        }
    }

    void read_profile(const toml::node& node) {
        if (const auto* name = node.as_string()) {
            content_.profile = name->get();
        } else {
            report(Severity::Error,
                   location_of(node.source()),
                   fmt::format("profile = {}: a name in quotes is expected. Ignored.",
                               words_for(node)));
        }
    }

    void read_tuning(const toml::key& key, const toml::node& node) {
        const TuningKey* entry = find_tuning_key(key.str());
        if (entry == nullptr) {
            report(Severity::Warning,
                   location_of(key.source()),
                   fmt::format("no key \"{}\" in [tuning].{} Line ignored.",
                               key.str(),
                               quote_nearest(key.str(), tuning_key_names())));
            return;
        }
        if (entry->flag != nullptr) {
            const auto* flag = node.as_boolean();
            if (flag != nullptr) {
                tuning_.*entry->flag = flag->get();
                return;
            }
            report(Severity::Error,
                   location_of(node.source()),
                   fmt::format("{} = {}: true or false is expected. {} is used.",
                               key.str(),
                               words_for(node),
                               tuning_.*entry->flag));
            return;
        }
        // Written so that nan fails too.
        const std::optional<double> number =
            node.is_number() ? node.value<double>() : std::optional<double>{};
        if (number && *number >= entry->min && *number <= entry->max) {
            tuning_.*entry->number = static_cast<float>(*number);
            return;
        }
        report(Severity::Error,
               location_of(node.source()),
               fmt::format("{} = {}: a number from {} to {} is expected. {} is used.",
                           key.str(),
                           words_for(node),
                           entry->min,
                           entry->max,
                           tuning_.*entry->number));
    }

    void read_hold(const toml::key& key, const toml::node& node) {
        const std::optional<Action> action = action_from_name(key.str());
        if (!action || *action == Action::Look) {
            std::vector<std::string_view> names = action_names({});
            std::erase(names, action_name(Action::Look));
            report(Severity::Warning,
                   location_of(key.source()),
                   fmt::format("no action \"{}\" in [hold].{} Line ignored.",
                               key.str(),
                               quote_nearest(key.str(), names)));
            return;
        }
        const std::string mode = node.value<std::string>().value_or("");
        if (mode == "hold" || mode == "toggle") {
            content_.holds.push_back({*action, mode == "hold" ? HoldMode::Hold : HoldMode::Toggle});
            return;
        }
        report(Severity::Error,
               location_of(node.source()),
               fmt::format("{} = {}: \"hold\" or \"toggle\" is expected. Line ignored.",
                           key.str(),
                           words_for(node)));
    }

    void read_action(ActionGroup group, const toml::key& key, const toml::node& node) {
        const std::optional<Action> action = action_from_name(key.str());
        if (!action) {
            std::string nearest = quote_nearest(key.str(), action_names(group));
            if (nearest.empty()) nearest = quote_nearest(key.str(), action_names({}));
            report(Severity::Warning,
                   location_of(key.source()),
                   fmt::format("no action \"{}\" in [{}].{} Line ignored.",
                               key.str(),
                               group_name(group),
                               nearest));
            return;
        }
        if (group_of(*action) != group) {
            report(Severity::Warning,
                   location_of(key.source()),
                   fmt::format("action \"{}\" belongs in [{}], not [{}]. It is taken all the same.",
                               key.str(),
                               group_name(group_of(*action)),
                               group_name(group)));
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
    const auto refuse = [&](std::string message) {
        faults.add({Severity::Error, "--bind", 0, 0, {}, std::move(message)});
    };
    const auto equals = option.find('=');
    if (equals == std::string_view::npos) {
        refuse(fmt::format("\"{}\" is not action=key[,key]. Ignored.", option));
        return std::nullopt;
    }
    const std::string_view name = option.substr(0, equals);
    const std::optional<Action> action = action_from_name(name);
    if (!action) {
        refuse(fmt::format(
            "no action \"{}\".{} Ignored.", name, quote_nearest(name, action_names({}))));
        return std::nullopt;
    }
    LayerLine line{.action = *action, .location = {}, .inputs = {}, .faults = {}};
    std::string_view rest = option.substr(equals + 1);
    while (!rest.empty()) {
        const auto comma = rest.find(',');
        const std::string_view word = rest.substr(0, comma);
        rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
        Result<Input> input = parse_input(word);
        if (input) {
            line.inputs.push_back({*input, {}});
        } else {
            line.faults.push_back({{}, input.error().message});
        }
    }
    return line;
}

}  // namespace plumbline::input
