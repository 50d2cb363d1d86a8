// Small images of lines and circles: sharp at any size, the same in every language.
#include "engine/app/ui/canvas_impl.h"

#include <array>
#include <cmath>

namespace plumbline::app::ui {
namespace {

constexpr float kTurn = 6.2831853F;

/// Coordinates from -0.5 to 0.5 about the middle.
struct Pen {
    ImDrawList& list;
    ImVec2 middle;
    float size;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {middle.x + x * size, middle.y + y * size}; }
    float wide() const { return std::max(1.0F, size * 0.11F); }
    void line(float x0, float y0, float x1, float y1) const {
        list.AddLine(at(x0, y0), at(x1, y1), color, wide());
    }
    void box(float x0, float y0, float x1, float y1) const {
        list.AddRect(at(x0, y0), at(x1, y1), color, size * 0.08F, 0, wide());
    }
    void filled_box(float x0, float y0, float x1, float y1) const {
        list.AddRectFilled(at(x0, y0), at(x1, y1), color, size * 0.06F);
    }
    void circle(float x, float y, float radius) const {
        list.AddCircle(at(x, y), radius * size, color, 0, wide());
    }
    void disc(float x, float y, float radius) const {
        list.AddCircleFilled(at(x, y), radius * size, color);
    }
    void triangle(float x0, float y0, float x1, float y1, float x2, float y2) const {
        list.AddTriangleFilled(at(x0, y0), at(x1, y1), at(x2, y2), color);
    }
    void arc(float radius, float from_turn, float to_turn) const {
        list.PathArcTo(middle, radius * size, from_turn * kTurn, to_turn * kTurn, 24);
        list.PathStroke(color, 0, wide());
    }
};

void gear(const Pen& pen) {
    pen.circle(0, 0, 0.26F);
    for (int i = 0; i < 8; ++i) {
        const float angle = kTurn * static_cast<float>(i) / 8.0F;
        const float x = std::cos(angle);
        const float y = std::sin(angle);
        pen.line(x * 0.3F, y * 0.3F, x * 0.48F, y * 0.48F);
    }
}

void keyboard(const Pen& pen) {
    pen.box(-0.5F, -0.3F, 0.5F, 0.32F);
    for (const float x : {-0.3F, -0.1F, 0.1F, 0.3F}) pen.disc(x, -0.1F, 0.055F);
    pen.line(-0.25F, 0.13F, 0.25F, 0.13F);
}

void loudspeaker(const Pen& pen) {
    pen.filled_box(-0.45F, -0.15F, -0.2F, 0.15F);
    pen.triangle(-0.3F, 0.0F, 0.02F, -0.38F, 0.02F, 0.38F);
    pen.arc(0.25F, -0.12F, 0.12F);
    pen.arc(0.45F, -0.12F, 0.12F);
}

void mouse(const Pen& pen) {
    pen.list.AddRect(
        pen.at(-0.28F, -0.46F), pen.at(0.28F, 0.46F), pen.color, pen.size * 0.28F, 0, pen.wide());
    pen.line(0.0F, -0.32F, 0.0F, -0.08F);
}

void again(const Pen& pen) {
    pen.arc(0.36F, -0.15F, 0.62F);
    pen.triangle(0.1F, -0.42F, 0.46F, -0.44F, 0.38F, -0.1F);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size_px, ImU32 color) {
    const Pen pen{list, middle, size_px, color};
    switch (icon) {
        case Icon::None:
            return;
        case Icon::Play:
            return pen.triangle(-0.32F, -0.42F, 0.45F, 0.0F, -0.32F, 0.42F);
        case Icon::Again:
            return again(pen);
        case Icon::Scenes:
            for (const float x : {-0.4F, 0.08F})
                for (const float y : {-0.4F, 0.08F}) pen.filled_box(x, y, x + 0.34F, y + 0.34F);
            return;
        case Icon::Settings:
            return gear(pen);
        case Icon::Keys:
            return keyboard(pen);
        case Icon::Help:
            pen.list.AddText(
                ImGui::GetIO().Fonts->Fonts[0], size_px * 1.2F, pen.at(-0.3F, -0.65F), color, "?");
            return;
        case Icon::Quit:
            pen.line(-0.35F, -0.35F, 0.35F, 0.35F);
            return pen.line(-0.35F, 0.35F, 0.35F, -0.35F);
        case Icon::Back:
            pen.line(-0.4F, 0.0F, 0.45F, 0.0F);
            pen.line(-0.4F, 0.0F, -0.1F, -0.3F);
            return pen.line(-0.4F, 0.0F, -0.1F, 0.3F);
        case Icon::Image:
            pen.box(-0.48F, -0.38F, 0.48F, 0.38F);
            pen.triangle(-0.4F, 0.32F, -0.1F, -0.1F, 0.2F, 0.32F);
            return pen.disc(0.22F, -0.14F, 0.1F);
        case Icon::Screen:
            pen.box(-0.48F, -0.4F, 0.48F, 0.24F);
            return pen.line(-0.25F, 0.42F, 0.25F, 0.42F);
        case Icon::Sound:
            return loudspeaker(pen);
        case Icon::Mouse:
            return mouse(pen);
        case Icon::Accuracy:
            pen.circle(0, 0, 0.4F);
            pen.line(-0.5F, 0.0F, 0.5F, 0.0F);
            return pen.line(0.0F, -0.5F, 0.0F, 0.5F);
        case Icon::On:
            pen.circle(0, 0, 0.38F);
            return pen.disc(0, 0, 0.24F);
        case Icon::Off:
            return pen.circle(0, 0, 0.38F);
        case Icon::Save:  // a floppy disk
            pen.box(-0.42F, -0.42F, 0.42F, 0.42F);
            pen.filled_box(-0.2F, -0.42F, 0.2F, -0.12F);
            return pen.box(-0.25F, 0.06F, 0.25F, 0.42F);
        case Icon::Light:
            pen.filled_box(-0.45F, -0.12F, 0.0F, 0.12F);
            pen.triangle(-0.05F, 0.0F, 0.18F, -0.26F, 0.18F, 0.26F);
            pen.line(0.3F, 0.0F, 0.5F, 0.0F);
            pen.line(0.28F, -0.2F, 0.45F, -0.32F);
            return pen.line(0.28F, 0.2F, 0.45F, 0.32F);
    }
}

}  // namespace plumbline::app::ui
