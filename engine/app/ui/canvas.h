// Text, boxes and small images in pixels: Dear ImGui's drawing without its back ends' input, so
// that frames can be built, and looked at, without a window.
#pragma once

#include "engine/app/ui/hud_layout.h"
#include "engine/core/input_snapshot.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::app::ui {

class Menu;

/// Below or above panels and the menu.
enum class Layer : std::uint8_t { Below, Above };

class Canvas {
public:
    Canvas();
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Names of images and their files, for cards. Each is read when a page first shows it.
    void set_thumbnails(std::map<std::string, std::filesystem::path> files);

    /// For the size of the window and the setting; letters are made anew when theirs changes. True
    /// then: the texture that was made of them is old.
    bool resize(int width_px, int height_px, float content_scale, float setting);
    /// Those of the page that is open. As resize(): true when there is a new texture to make.
    bool load_thumbnails(const Menu& menu);

    float font_px() const;
    const TextSize& text_size() const;
    float width_px() const;
    float height_px() const;

    /// One frame: what the pointer does is for panels with things to choose in them, and so are the
    /// arrows, Enter and Escape while takes_keys().
    void begin(const InputSnapshot& input);
    /// A list of choices dropped down in the last frame.
    bool takes_keys() const;
    /// A panel of the last frame lies there.
    bool covers(float x_px, float y_px) const;
    void draw(const HudPanel& panel, float opacity, Layer layer = Layer::Below);
    void draw(const Menu& menu);
    void end();

    /// Texts of the last frame that did not fit the box they were drawn into.
    const std::vector<std::string>& cut_texts() const;

    struct Impl;

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::app::ui
