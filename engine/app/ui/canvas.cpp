#include "engine/app/ui/canvas_impl.h"
#include "engine/app/ui/ui_scale.h"
#include "engine/assets/image/image_import.h"
#include "engine/core/log.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <utility>

namespace plumbline::app::ui {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

// Latin, Greek and Cyrillic (key labels of other layouts), dashes and quotes, arrows.
constexpr std::array<ImWchar, 11> kLetters{
    0x20, 0x17F, 0x370, 0x3FF, 0x400, 0x52F, 0x2010, 0x203A, 0x2190, 0x2199, 0};

constexpr ImU32 kBar = IM_COL32(38, 92, 138, 200);
// What panels know of the keyboard, by GLFW's codes. Space is what Dear ImGui activates with.
constexpr std::array<std::pair<ImGuiKey_, int>, 6> kPanelKeys{{{ImGuiKey_UpArrow, 265},
                                                               {ImGuiKey_DownArrow, 264},
                                                               {ImGuiKey_Space, 257},
                                                               {ImGuiKey_Space, 335},
                                                               {ImGuiKey_Space, 32},
                                                               {ImGuiKey_Escape, kEscapeKey}}};

ImU32 color_of(Tone tone, float alpha) {
    constexpr std::array<ImU32, 5> kTones{IM_COL32(245, 245, 245, 0),
                                          IM_COL32(255, 209, 115, 0),
                                          IM_COL32(140, 230, 140, 0),
                                          IM_COL32(255, 125, 110, 0),
                                          IM_COL32(205, 205, 205, 0)};
    const auto a = static_cast<ImU32>(std::clamp(alpha, 0.0F, 1.0F) * 255.0F);
    return kTones[static_cast<std::size_t>(tone)] | a << IM_COL32_A_SHIFT;
}

void apply_style(float font_px) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.WindowRounding = 6.0F;
    style.FrameRounding = 4.0F;
    style.WindowBorderSize = 0.0F;
    style.WindowPadding = {10.0F, 8.0F};
    style.ScaleAllSizes(font_px / kUsualFont_px);
}

}  // namespace

Canvas::Canvas() : impl_(std::make_unique<Impl>()) {
    IMGUI_CHECKVERSION();
    impl_->context = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange | ImGuiConfigFlags_NavEnableKeyboard;
    for (const auto& [key, code] : kPanelKeys) io.KeyMap[key] = key;
    impl_->text_size.width_px = [impl = impl_.get()](const std::string& words) {
        const ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
        return font
            ->CalcTextSizeA(impl->font_px, FLT_MAX, 0.0F, words.data(), words.data() + words.size())
            .x;
    };
    impl_->text_size.height_px = [impl = impl_.get()](const std::string& words, float wrap_px) {
        if (words.empty()) return 0.0F;
        const ImFont* font = ImGui::GetIO().Fonts->Fonts[0];
        return font
            ->CalcTextSizeA(impl->font_px,
                            FLT_MAX,
                            std::max(1.0F, wrap_px),
                            words.data(),
                            words.data() + words.size())
            .y;
    };
}

Canvas::~Canvas() {
    ImGui::DestroyContext(impl_->context);
}

void Canvas::set_thumbnails(std::map<std::string, std::filesystem::path> files) {
    impl_->thumbnail_files = std::move(files);
}

bool Canvas::load_thumbnails(const Menu& menu) {
    if (!menu.open()) return false;
    bool is_new = false;
    for (const Line& line : menu.page().lines)
        for (const Cell& cell : line.cells)
            if (!cell.thumbnail.empty()) is_new |= impl_->load_thumbnail(cell.thumbnail);
    if (is_new && impl_->font_px > 0.0F) impl_->build_atlas();
    return is_new;
}

bool Canvas::Impl::load_thumbnail(const std::string& name) {
    const auto file = thumbnail_files.extract(name);
    if (file.empty()) return false;
    const Result<assets::ImageData> image = assets::import_image(file.mapped());
    if (!image) {
        log_note("no thumbnail for {}: {}", name, image.error().message);
        return false;
    }
    const std::uint32_t bytes = assets::bytes_per_pixel(image->format);
    constexpr std::uint32_t kLargest_px = 512;
    if (bytes < 3 || bytes > 4 || image->width > kLargest_px || image->height > kLargest_px)
        return false;
    Thumbnail thumbnail{.width = static_cast<int>(image->width),
                        .height = static_cast<int>(image->height)};
    thumbnail.rgba.reserve(image->bytes.size() / bytes * 4);
    for (std::size_t i = 0; i + bytes <= image->bytes.size(); i += bytes) {
        thumbnail.rgba.insert(thumbnail.rgba.end(), &image->bytes[i], &image->bytes[i] + 3);
        thumbnail.rgba.push_back(255);
    }
    thumbnails.emplace(name, std::move(thumbnail));
    return true;
}

void Canvas::Impl::build_atlas() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    // Memory for what is there, not for the next power of two.
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    if (!thumbnails.empty()) atlas.TexDesiredWidth = 2048;
    std::error_code ignored;
    if (std::filesystem::exists(kFont, ignored)) {
        atlas.AddFontFromFileTTF(kFont, font_px, nullptr, kLetters.data());
    } else {
        ImFontConfig config;
        config.SizePixels = font_px;
        atlas.AddFontDefault(&config);
    }
    for (auto& [name, thumbnail] : thumbnails)
        thumbnail.place = atlas.AddCustomRectRegular(thumbnail.width, thumbnail.height);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    for (const auto& [name, thumbnail] : thumbnails) {
        const ImFontAtlasCustomRect* at = atlas.GetCustomRectByIndex(thumbnail.place);
        if (at == nullptr || !at->IsPacked()) continue;
        const std::size_t row = static_cast<std::size_t>(thumbnail.width) * 4;
        for (int y = 0; y < thumbnail.height; ++y) {
            const std::size_t to =
                (static_cast<std::size_t>(at->Y + y) * static_cast<std::size_t>(width) + at->X) * 4;
            std::copy_n(&thumbnail.rgba[static_cast<std::size_t>(y) * row], row, pixels + to);
        }
    }
    apply_style(font_px);
}

std::optional<ImageUv> Canvas::Impl::thumbnail(const std::string& name) const {
    const auto found = thumbnails.find(name);
    if (found == thumbnails.end() || found->second.place < 0) return std::nullopt;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const ImFontAtlasCustomRect* at = atlas.GetCustomRectByIndex(found->second.place);
    if (at == nullptr || !at->IsPacked()) return std::nullopt;
    ImageUv uv;
    atlas.CalcCustomRectUV(at, &uv.from, &uv.to);
    return uv;
}

bool Canvas::resize(int width_px, int height_px, float content_scale, float setting) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width_px), static_cast<float>(height_px)};
    const float wanted = font_size_px(io.DisplaySize.x, io.DisplaySize.y, content_scale, setting);
    if (wanted == impl_->font_px) return false;
    impl_->font_px = wanted;
    impl_->build_atlas();
    return true;
}

float Canvas::font_px() const {
    return impl_->font_px;
}

const TextSize& Canvas::text_size() const {
    return impl_->text_size;
}

float Canvas::width_px() const {
    return ImGui::GetIO().DisplaySize.x;
}

float Canvas::height_px() const {
    return ImGui::GetIO().DisplaySize.y;
}

void Canvas::begin(const InputSnapshot& input) {
    ImGuiIO& io = ImGui::GetIO();
    constexpr double kLongest_s = 0.25;
    const double elapsed_s = impl_->last_now_s < 0.0 ? 0.0 : input.now_s - impl_->last_now_s;
    impl_->last_now_s = input.now_s;
    io.DeltaTime = static_cast<float>(std::clamp(elapsed_s, 1e-3, kLongest_s));
    io.MousePos = {static_cast<float>(input.cursor_px[0]), static_cast<float>(input.cursor_px[1])};
    for (std::size_t i = 0; i < 3; ++i) io.MouseDown[i] = input.buttons[i];
    for (const DeviceEvent& event : input.events) {
        // A click shorter than a frame counts as down for one.
        if (event.kind == DeviceEventKind::MouseButton && event.pressed && event.code < 3)
            io.MouseDown[event.code] = true;
        if (event.kind == DeviceEventKind::Wheel && event.code < 2)
            io.MouseWheel += event.code == 0 ? 1.0F : -1.0F;
    }
    for (const auto& [key, code] : kPanelKeys) io.KeysDown[key] = false;
    for (const auto& [key, code] : kPanelKeys) {
        // A press shorter than a frame counts as down for one.
        const bool pressed = std::ranges::any_of(input.events, [code = code](const DeviceEvent& e) {
            return e.kind == DeviceEventKind::Key && e.pressed && e.code == code;
        });
        if (takes_keys() && (pressed || input.keys[static_cast<std::size_t>(code)]))
            io.KeysDown[key] = true;
    }
    impl_->cut.clear();
    ImGui::NewFrame();
}

bool Canvas::takes_keys() const {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

bool Canvas::covers(float x_px, float y_px) const {
    const ImVector<ImGuiWindow*>& windows = ImGui::GetCurrentContext()->Windows;
    return std::any_of(windows.begin(), windows.end(), [&](const ImGuiWindow* window) {
        return window->Active && !window->Hidden &&
               (window->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
               window->OuterRectClipped.Contains({x_px, y_px});
    });
}

void Canvas::Impl::text(
    ImDrawList& list, const Box& box, ImU32 color, const std::string& words, float scale) {
    if (words.empty()) return;
    constexpr float kSlack_px = 1.5F;
    const float width = scale * text_size.width_px(words);
    const float height = scale * text_size.height_px(words, box.width / scale);
    const bool breaks = words.find(' ') != std::string::npos;
    if (height > box.height + kSlack_px || (!breaks && width > box.width + kSlack_px))
        cut.push_back(words);
    list.AddText(ImGui::GetIO().Fonts->Fonts[0],
                 font_px * scale,
                 {std::floor(box.x), std::floor(box.y)},
                 color,
                 words.data(),
                 words.data() + words.size(),
                 std::max(1.0F, box.width + 0.5F));
}

void Canvas::draw(const HudPanel& panel, float opacity, Layer layer) {
    if (panel.texts.empty()) return;
    ImDrawList& list =
        layer == Layer::Above ? *ImGui::GetForegroundDrawList() : *ImGui::GetBackgroundDrawList();
    float strongest = 0.0F;
    for (const PlacedText& text : panel.texts) strongest = std::max(strongest, text.line.alpha);
    list.AddRectFilled({panel.box.x, panel.box.y},
                       {panel.box.right(), panel.box.bottom()},
                       IM_COL32(12, 12, 16, static_cast<int>(opacity * strongest * 255.0F)),
                       impl_->font_px * 0.3F);
    for (const PlacedText& text : panel.texts) impl_->line(list, text, panel.scale);
}

void Canvas::Impl::line(ImDrawList& list, const PlacedText& placed, float scale) {
    const HudLine& line = placed.line;
    const Box& box = placed.box;
    const ImU32 color = color_of(line.tone, line.alpha);
    if (line.share > 0.0F)
        list.AddRectFilled({box.x, box.y},
                           {box.x + box.width * std::min(line.share, 1.0F), box.bottom()},
                           kBar,
                           scale * font_px * 0.15F);
    if (!line.graph.empty()) graph(list, box, line);
    Box words = box;
    if (!line.value.empty()) {
        const float width = std::ceil(scale * text_size.width_px(line.value)) + 1.0F;
        words.width = std::max(1.0F, box.width - width - scale * font_px);
        text(list, {box.right() - width, box.y, width, box.height}, color, line.value, scale);
    }
    text(list, words, color, line.text, scale);
}

void Canvas::Impl::graph(ImDrawList& list, const Box& box, const HudLine& line) const {
    constexpr std::size_t kColumns = 120;
    const float gap = font_px * 0.2F;
    const float top = box.y + gap;
    const float height = box.height - 2 * gap;
    list.AddRectFilled({box.x, top}, {box.right(), top + height}, IM_COL32(0, 0, 0, 110));
    const float column = box.width / static_cast<float>(kColumns);
    // The latest stands at the right edge.
    const std::size_t empty = kColumns - std::min(kColumns, line.graph.size());
    for (std::size_t i = 0; i < line.graph.size() && i < kColumns; ++i) {
        const float value = line.graph[i];
        const float share = std::clamp(value / line.graph_top, 0.0F, 1.0F);
        const float x = box.x + column * static_cast<float>(empty + i);
        const bool over = line.graph_budget > 0.0F && value > line.graph_budget;
        list.AddRectFilled({x, top + height * (1.0F - share)},
                           {x + std::max(1.0F, column), top + height},
                           color_of(over ? Tone::Head : Tone::Good, 0.8F));
    }
    if (line.graph_budget <= 0.0F || line.graph_budget > line.graph_top) return;
    const float y = top + height * (1.0F - line.graph_budget / line.graph_top);
    list.AddLine({box.x, y}, {box.right(), y}, IM_COL32(255, 255, 255, 170));
    const std::string budget = fmt::format("{:.1f} ms", line.graph_budget);
    list.AddText(ImGui::GetIO().Fonts->Fonts[0],
                 font_px * 0.75F,
                 {box.x + gap, std::max(top, y - font_px * 0.8F)},
                 IM_COL32(255, 255, 255, 200),
                 budget.c_str());
}

void Canvas::end() {
    ImGui::Render();
}

const std::vector<std::string>& Canvas::cut_texts() const {
    return impl_->cut;
}

}  // namespace plumbline::app::ui
