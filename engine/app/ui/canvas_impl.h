// Private to canvas.cpp and menu_draw.cpp.
#pragma once

#include "engine/app/ui/canvas.h"
#include "engine/app/ui/menu.h"

#include <imgui.h>

#include <optional>

namespace plumbline::app::ui {

struct ImageUv {
    ImVec2 from;
    ImVec2 to;
};

struct Canvas::Impl {
    ImGuiContext* context{nullptr};
    float font_px{0.0F};
    double last_now_s{-1.0};
    TextSize text_size;
    std::map<std::string, std::filesystem::path> thumbnail_files;
    struct Thumbnail {
        int width;
        int height;
        std::vector<std::uint8_t> rgba;
        int place{-1};
    };
    std::map<std::string, Thumbnail> thumbnails;
    std::vector<std::string> cut;

    bool load_thumbnail(const std::string& name);  ///< false: there is none, or it was read before
    void build_atlas();
    std::optional<ImageUv> thumbnail(const std::string& name) const;
    /// Wrapped into the box; notes it when it does not fit.
    /// `scale`: of the font.
    void text(ImDrawList& list,
              const Box& box,
              ImU32 color,
              const std::string& words,
              float scale = 1.0F);
    void line(ImDrawList& list, const PlacedText& placed, float scale);
    void graph(ImDrawList& list, const Box& box, const HudLine& line) const;
};

void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size_px, ImU32 color);

}  // namespace plumbline::app::ui
