#include "engine/study/findings/findings_json.h"

#include "engine/core/hash.h"
#include "engine/study/findings/findings_json_impl.h"

namespace plumbline::study {

void fields(const auto& field, Like<ImageRow> auto& row) {
    field("name", row.name);
    field("rms_error", row.error.rms);
    field("mean_error", row.error.mean);
    field("cpu_ms", row.cpu_ms);
    field("more_ms", row.more_ms);
    field("unbeaten", row.unbeaten);
    field("verdict", row.verdict);
}

void fields(const auto& field, Like<ImageFindings> auto& findings) {
    field("scene", findings.scene);
    field("width_px", findings.width_px);
    field("height_px", findings.height_px);
    field("samples_per_pixel", findings.samples_per_pixel);
    field("mean_luminance", findings.mean_luminance);
    field("rows", findings.rows);
}

void fields(const auto& field, Like<EffectFindings> auto& findings) {
    field("scene", findings.scene);
    field("seconds", findings.seconds);
    field("pairs", findings.pairs);
    field("width_px", findings.width_px);
    field("height_px", findings.height_px);
    field("rows", findings.rows);
}

void fields(const auto& field, Like<Findings> auto& findings) {
    field("command", findings.command);
    field("machine", findings.machine);
    field("build", findings.build);
    field("made_on", findings.made_on);
    field("complete", findings.complete);
    field("clock_spread", findings.clock_spread);
    field("subjects", findings.subjects);
    field("images", findings.images);
    field("effects", findings.effects);
    field("references", findings.references);
    field("shard", findings.shard);
}

namespace {

/// Of all but the sum itself, however it is laid out.
std::string sum_of(Json json) {
    json.erase("sum");
    const std::string text = text_of(json);
    Hasher hasher;
    hasher.add(text.data(), text.size());
    return hex_of(hasher.digest());
}

}  // namespace

/// Refuses findings whose sum is not right.
void from_json(const Json& json, Findings& findings) {
    const std::string sum = json.at("sum");
    if (sum != sum_of(json))
        throw std::runtime_error(fmt::format(
            "its checksum is {}, it should be {}: something in it was changed", sum_of(json), sum));
    fields(FieldReader{json}, findings);
}

std::string findings_to_json(const Findings& findings) {
    Json json = findings;
    json["sum"] = sum_of(json);
    return text_of(json, 1) + "\n";
}

std::string references_to_json(const std::vector<EffectError>& errors) {
    return text_of(Json(errors), 1) + "\n";
}

Result<Findings> findings_from_json(const std::string& text) {
    return read_text<Findings>(text, "not what a study writes");
}

}  // namespace plumbline::study
