// The accuracy panel's study: a diagram of settings by cost and error that grows while it is measured.
#include "engine/app/accuracy/study_diagram.h"
#include "engine/app/overlay/overlay_panels_impl.h"
#include "engine/app/settings/quality_control.h"
#include "engine/study/findings/number_text.h"
#include "engine/study/scenes/scene_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace plumbline::app::panels {
namespace {

using physics::Solver;
using study::Setting;

constexpr ImU32 kAxes = IM_COL32(255, 255, 255, 60);
constexpr ImU32 kGrid = IM_COL32(255, 255, 255, 22);
constexpr ImU32 kLetters = IM_COL32(255, 255, 255, 170);
constexpr ImU32 kTolerance = IM_COL32(255, 205, 70, 200);
constexpr ImU32 kPresent = IM_COL32(255, 255, 255, 255);
constexpr float kLeastTolerance = 1e-5F;
constexpr float kMostTolerance = 1.0F;

ImU32 color_of(const Setting& setting) {
    switch (setting.solver) {
        case Solver::SmallStep:
            return IM_COL32(70, 200, 235, 255);
        case Solver::BulletSi:
            return IM_COL32(240, 130, 70, 255);
        case Solver::BulletNncg:
            return IM_COL32(230, 100, 150, 255);
        case Solver::BulletDantzig:
            return IM_COL32(170, 130, 240, 255);
        case Solver::BulletPgs:
            return IM_COL32(150, 190, 90, 255);
    }
    return kLetters;
}

/// "0.1 %" of 1e-3; "10 ms" of 10.
std::string decade_text(int decade, bool percent) {
    const double value = std::pow(10.0, decade) * (percent ? 100.0 : 1.0);
    return fmt::format("{:g} {}", value, percent ? "%" : "ms");
}

/// The diagram's place on the screen.
struct Frame {
    ImVec2 low;  ///< upper left corner
    ImVec2 size;

    ImVec2 at(const Vec2f& place) const {
        return {low.x + place.x * size.x, low.y + (1.0F - place.y) * size.y};
    }
    Vec2f place_of(const ImVec2& at) const {
        return {(at.x - low.x) / size.x, 1.0F - (at.y - low.y) / size.y};
    }
};

void draw_decades(ImDrawList& list, const Frame& frame, const StudyDiagram& diagram) {
    const float font_px = ImGui::GetFontSize();
    for (int decade = diagram.error.least_decade; decade <= diagram.error.most_decade; ++decade) {
        const float up = diagram.error.place_of(std::pow(10.0, decade));
        list.AddLine(frame.at({0, up}), frame.at({1, up}), kGrid);
        const std::string words = decade_text(decade, true);
        const ImVec2 end = frame.at({0, up});
        const float width = ImGui::CalcTextSize(words.c_str()).x;
        list.AddText(
            {end.x - width - 0.3F * font_px, end.y - 0.5F * font_px}, kLetters, words.c_str());
    }
    for (int decade = diagram.ms.least_decade; decade <= diagram.ms.most_decade; ++decade) {
        const float along = diagram.ms.place_of(std::pow(10.0, decade));
        list.AddLine(frame.at({along, 0}), frame.at({along, 1}), kGrid);
        const std::string words = decade_text(decade, false);
        const ImVec2 end = frame.at({along, 0});
        const float width = ImGui::CalcTextSize(words.c_str()).x;
        list.AddText({end.x - 0.5F * width, end.y + 0.15F * font_px}, kLetters, words.c_str());
    }
    list.AddRect(frame.at({0, 1}), frame.at({1, 0}), kAxes);
}

void draw_tolerance(ImDrawList& list, const Frame& frame, float up) {
    constexpr int kDashes = 24;
    for (int i = 0; i < kDashes; i += 2) {
        list.AddLine(frame.at({static_cast<float>(i) / kDashes, up}),
                     frame.at({static_cast<float>(i + 1) / kDashes, up}),
                     kTolerance,
                     1.5F);
    }
}

struct Marks {
    std::optional<std::size_t> chosen{};  ///< the cheapest within the tolerance
    Setting present{};
    float tolerance{0};
};

void draw_points(const study::SceneStudy& study,
                 const StudyDiagram& diagram,
                 const Marks& marks,
                 const Frame& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius_px = 0.24F * ImGui::GetFontSize();
    draw_decades(list, frame, diagram);
    draw_tolerance(list, frame, diagram.error.place_of(static_cast<double>(marks.tolerance)));
    for (std::size_t i = 1; i < diagram.front.size(); ++i)
        list.AddLine(frame.at(diagram.front[i - 1]), frame.at(diagram.front[i]), kAxes, 1.5F);
    const std::string present = study::setting_text(marks.present);
    for (const DiagramPoint& point : diagram.points) {
        const Setting& setting = study.subject.points[point.of].setting;
        const ImVec2 at = frame.at(point.place);
        if (setting.precision == marks.present.precision)
            list.AddCircleFilled(at, radius_px, color_of(setting));
        else  // the other program's
            list.AddCircle(at, radius_px, color_of(setting), 0, 1.5F);
        if (study::setting_text(setting) == present)
            list.AddCircle(at, 1.9F * radius_px, kPresent, 0, 2.0F);
        if (point.of == marks.chosen) list.AddCircle(at, 2.6F * radius_px, kTolerance, 0, 2.0F);
    }
}

/// The point that the pointer is at; its words are shown beside it.
std::optional<std::size_t> draw_diagram(const study::SceneStudy& study, const Marks& marks) {
    const StudyDiagram diagram = diagram_of(study.subject.points);
    const float font_px = ImGui::GetFontSize();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float left = 4.2F * font_px;  // for the letters there
    const Frame frame{
        .low = {from.x + left, from.y + 0.6F * font_px},
        .size = {ImGui::GetContentRegionAvail().x - left - 1.5F * font_px, 8.5F * font_px}};
    ImGui::InvisibleButton("diagram",
                           {ImGui::GetContentRegionAvail().x, frame.size.y + 2.0F * font_px});
    draw_points(study, diagram, marks, frame);
    if (!ImGui::IsItemHovered()) return {};
    const std::optional<std::size_t> at = point_at(diagram,
                                                   frame.place_of(ImGui::GetMousePos()),
                                                   {frame.size.x, frame.size.y},
                                                   0.7F * font_px);
    if (at) ImGui::SetTooltip("%s", study::point_text(study.subject.points[*at]).c_str());
    return at;
}

/// Takes the setting over at once, and shows how far it is from a finer one.
void use(const study::Point& point, const AccuracyPanel& shown, Requests& requests) {
    if (shown.replaying || point.setting.precision != shown.control.setting().precision) return;
    requests.push_back(WorldRequest{SetAccuracy{point.setting}});
    requests.push_back(StartGhost{finer(point.setting), GhostFrom::Here});
}

/// Kept by the window from frame to frame.
float& tolerance_of(const AccuracyPanel& shown) {
    return *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("tolerance"),
                                                  static_cast<float>(shown.tolerance));
}

void draw_choice(const study::SceneStudy& study, const AccuracyPanel& shown, Requests& requests) {
    float& tolerance = tolerance_of(shown);
    const auto choice = study::choose(study, {.tolerance = static_cast<double>(tolerance)});
    Marks marks{.present = shown.control.setting(), .tolerance = tolerance};
    if (choice && choice->met) marks.chosen = choice->point;
    const std::optional<std::size_t> at = draw_diagram(study, marks);
    if (at && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        use(study.subject.points[*at], shown, requests);
    float percent = 100.0F * tolerance;
    if (ImGui::SliderFloat(
            "Tolerance",
            &percent,
            100.0F * kLeastTolerance,
            100.0F * kMostTolerance,
            "%.3g %%",
            ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | ImGuiSliderFlags_Logarithmic))
        tolerance = percent / 100.0F;
    if (!choice) return;
    const study::Point& point = study.subject.points[choice->point];
    if (!shown.replaying && ImGui::Button("Use it")) use(point, shown, requests);
    if (!shown.replaying) ImGui::SameLine();
    draw_text(fmt::format("{}: {}",
                          choice->met ? "Cheapest within it" : "None within it; the closest",
                          study::point_text(point)));
}

/// "18 settings: 50 bodies, 2 joints, 3.00 s from 4.50 s on".
std::string head_of(const study::SceneStudy& study) {
    const std::string& set_up = study.subject.set_up;
    return fmt::format("{} settings: {}",
                       study.subject.points.size(),
                       set_up.substr(0, set_up.find(", compared")));
}

void draw_buttons(const StudyControl& control, Requests& requests) {
    if (!control.runs()) {
        if (ImGui::Button("Study from here")) requests.push_back(StartStudy{});
        ImGui::SameLine();
        draw_text("Measures cost and error of many settings, 20 s.");
        return;
    }
    if (ImGui::Button("Stop study")) requests.push_back(StopStudy{});
    ImGui::SameLine();
    const study::StudyProgress progress = control.progress();
    const std::string words =
        control.waits_for_processor()
            ? "waits for the processor"
            : fmt::format("{:.0f} %, {:.0f} s left", 100.0 * progress.share, progress.left_s);
    ImGui::ProgressBar(static_cast<float>(progress.share), {-1.0F, 0.0F}, words.c_str());
}

/// One of the image's levels, with a button that takes it over.
void draw_level(const study::ImageRow& row, Requests& requests) {
    const std::string level = row.name.substr(row.name.rfind(' ') + 1);
    if (ImGui::Button(fmt::format("Use##{}", level).c_str())) {
        if (const std::optional<QualityLevel> found = quality_level_named(level))
            requests.push_back(SetImageLevel{*found});
    }
    ImGui::SameLine();
    draw_text(fmt::format(
        "image {}: {} off, {:.3g} ms of CPU", level, study::error_text(row.error.rms), row.cpu_ms));
}

void draw_picture(const PictureStudy& picture, Requests& requests) {
    if (picture.runs()) {
        if (ImGui::Button("Stop##picture")) requests.push_back(StopPictureStudy{});
        ImGui::SameLine();
        draw_text("measuring the levels of the image");
    } else {
        if (ImGui::Button("Study image")) requests.push_back(StartPictureStudy{});
        ImGui::SameLine();
        draw_text("Levels from this view, against exact shadows.");
    }
    if (!picture.failure().empty()) draw_text("image study failed: " + picture.failure());
    for (const study::ImageRow& row : picture.rows()) draw_level(row, requests);
}

}  // namespace

void draw_study(const AccuracyPanel& shown, Requests& requests) {
    const StudyControl& control = shown.control.study;
    if (!shown.replaying) draw_buttons(control, requests);
    if (!control.failure().empty()) draw_text("study failed: " + control.failure());
    if (control.runs() && control.left_out() > 0)
        draw_text(fmt::format("Without {} things made in play.", control.left_out()));
    if (const study::SceneStudy* study = control.study()) {
        draw_text(head_of(*study));
        draw_choice(*study, shown, requests);
        if (!shown.replaying) draw_text("Click a point: its setting, and a ghost beside it.");
    }
    draw_picture(shown.control.picture, requests);
}

}  // namespace plumbline::app::panels
