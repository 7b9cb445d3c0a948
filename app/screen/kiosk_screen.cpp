#include "app/screen/kiosk_screen.h"

#include "app/screen/marks.h"
#include "app/screen/paint.h"
#include "app/visit/proxy_radius.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <epoxy/gl.h>

namespace touchline {
namespace {

constexpr std::int64_t panel_period_ns = 200'000'000;
constexpr double least_level_change = 1.0 / 32.0;  // less moves no line by a pixel

Canvas canvas_for(const Rect& rect) {
    return {static_cast<int>(rect.width), static_cast<int>(rect.height)};
}

/// The same size at (0, 0).
Rect at_origin(const Rect& rect) {
    return {0.0, 0.0, rect.width, rect.height};
}

/// The width of a thin line beside capitals of this height.
double unit_px(double cap_px) {
    return cap_px / 14.0;
}

}  // namespace

void LiveView::draw(const Renderer& renderer, const FrameContent& content, int width_px,
                    int height_px, std::int64_t now_ns) {
    if (width_px != width_px_ || height_px != height_px_) lay_out_again(width_px, height_px);
    update_picture(content.shown);
    update_panel(content, now_ns);
    update_overlay(content);
    if (content.shown.scene) update_outlines(*content.shown.scene, content.hand.level);
    update_boxes(content);
    update_hand(content.hand);
    is_stale_ = false;

    glViewport(0, 0, width_px_, height_px_);
    // The two opaque layers cover the whole screen, so no clearing is needed, and without blending
    // software drawing copies them.
    glDisable(GL_BLEND);
    renderer.draw(picture_);
    glEnable(GL_BLEND);
    for (const StrokeBuffer* strokes : {&boxes_, &outlines_, &hand_})
        renderer.draw(*strokes, width_px_, height_px_);
    if (!painted_message_.empty()) renderer.draw(overlay_);
    glDisable(GL_BLEND);
    renderer.draw(panel_);
}

void LiveView::lay_out_again(int width_px, int height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    layout_ = lay_out(width_px, height_px);
    view_ = view_of(Area{}, layout_.picture);
    is_stale_ = true;
}

void LiveView::upload(ImageLayer& layer, const Canvas& canvas, const Rect& rect) const {
    layer.upload(canvas, static_cast<int>(rect.x), static_cast<int>(rect.y), width_px_, height_px_);
}

void LiveView::update_picture(const ShownScene& shown) {
    if (!is_stale_ && shown.picture == painted_picture_) return;
    const Area area = shown.scene ? shown.scene->area : Area{};
    const View local = view_of(area, at_origin(layout_.picture));
    const Canvas canvas = canvas_for(layout_.picture);
    fill(canvas.context(), at_origin(layout_.picture), {white_on_black.background});
    if (shown.picture) paint_picture(canvas.context(), local, area, *shown.picture);
    paint_frame(canvas.context(), area_rect(area, local), unit_px(cap_px_));
    upload(picture_, canvas, layout_.picture);
    view_ = view_of(area, layout_.picture);
    painted_picture_ = shown.picture;
    outlined_level_ = -1.0;
}

void LiveView::update_panel(const FrameContent& content, std::int64_t now_ns) {
    const bool is_same = content.status == painted_status_ && content.timing == painted_timing_;
    if (!is_stale_ && (is_same || now_ns - panel_ns_ < panel_period_ns)) return;
    const Canvas canvas = canvas_for(layout_.panel);
    cairo_t* const cr = canvas.context();
    Rect rect = at_origin(layout_.panel);
    fill(cr, rect, {white_on_black.background});
    if (content.timing) rect.height = paint_timing_below(cr, rect, content);
    paint_panel(cr, rect, content.status, cap_px_);
    upload(panel_, canvas, layout_.panel);
    painted_status_ = content.status;
    painted_timing_ = content.timing;
    panel_ns_ = now_ns;
}

double LiveView::paint_timing_below(cairo_t* cr, const Rect& rect,
                                    const FrameContent& content) const {
    constexpr double share = 0.35;  // of the panel's height, at most
    const double cap_px =
        cap_px_ * std::min(1.0, share * rect.height / timing_chart_height_px(cap_px_));
    const double height_px = timing_chart_height_px(cap_px) + cap_px;
    const Rect chart{rect.x + cap_px, rect.y + rect.height - height_px, rect.width - 2.0 * cap_px,
                     height_px};
    paint_timing(cr, chart, *content.timing, cap_px, white_on_black, content.language);
    return rect.height - height_px;
}

void LiveView::update_overlay(const FrameContent& content) {
    const std::string& message = content.status.message;
    if (!is_stale_ && message == painted_message_) return;
    painted_message_ = message;
    if (message.empty()) return;
    const Canvas canvas = canvas_for(layout_.picture);
    const Rect rect = at_origin(layout_.picture);
    paint_message(canvas.context(), rect, message, cap_px_);
    upload(overlay_, canvas, layout_.picture);
}

void LiveView::update_outlines(const Scene& scene, double level) {
    const bool is_same_scene = outlined_version_ == scene.map_version && outlined_level_ >= 0.0;
    if (is_same_scene && std::abs(level - outlined_level_) < least_level_change) return;
    strokes_.clear();
    add_outlines(strokes_, view_, scene.curves, level, 1.5 * unit_px(cap_px_));
    outlines_.upload(strokes_);
    outlined_version_ = scene.map_version;
    outlined_level_ = level;
}

void LiveView::update_boxes(const FrameContent& content) {
    strokes_.clear();
    if (content.shows_boxes && content.shown.scene) {
        const Scene& scene = *content.shown.scene;
        std::vector<ErrorBox> boxes;
        const int level = static_cast<int>(std::ceil(content.hand.level));
        scene.tree.boundary_section(scene.curves, content.hand.p_WH, level, boxes);
        add_boxes(strokes_, view_, boxes, 0.75 * unit_px(cap_px_));
    }
    boxes_.upload(strokes_);
}

void LiveView::update_hand(const HandState& hand) {
    strokes_.clear();
    add_hand(strokes_, view_, hand, proxy_radius_m, unit_px(cap_px_));
    hand_.upload(strokes_);
}

Result<KioskScreen> KioskScreen::make(double cap_px) {
    auto renderer = Renderer::make();
    if (!renderer) return tl::unexpected(renderer.error());
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are multiplied by alpha
    return KioskScreen(cap_px, std::move(*renderer));
}

KioskScreen::KioskScreen(double cap_px, Renderer renderer)
    : cap_px_(cap_px), renderer_(std::move(renderer)), live_(cap_px), layers_(cap_px) {}

void KioskScreen::draw(const FrameContent& content, int width_px, int height_px,
                       std::int64_t now_ns) {
    is_live_ = true;
    live_.draw(renderer_, content, width_px, height_px, now_ns);
}

void KioskScreen::draw(const ScreenContent& content, int width_px, int height_px,
                       std::int64_t now_ns) {
    is_live_ = false;
    layers_.update(content, width_px, height_px, now_ns);
    upload_layers(width_px, height_px);
    glViewport(0, 0, width_px, height_px);
    // Opaque layers cover the whole screen, so no clearing is needed, and without blending software
    // drawing copies them. Sheet and captions come last, so that no mark lies over a letter.
    glDisable(GL_BLEND);
    if (picture_.is_filled()) renderer_.draw(picture_);
    if (layers_.has_marks()) {
        update_outlines(content.hand.level, now_ns);
        update_hand(content.hand);
        glEnable(GL_BLEND);
        for (const StrokeBuffer* strokes : {&outlines_, &hand_})
            renderer_.draw(*strokes, width_px, height_px);
        glDisable(GL_BLEND);
    }
    renderer_.draw(sheet_);
    if (captions_.is_filled()) renderer_.draw(captions_);
}

const View& KioskScreen::view() const {
    return is_live_ ? live_.view() : layers_.view();
}

void KioskScreen::upload_layers(int width_px, int height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    upload(sheet_, sheet_version_, layers_.sheet());
    upload(captions_, captions_version_, layers_.captions());
    upload(picture_, picture_version_, layers_.picture());
}

void KioskScreen::upload(ImageLayer& image, std::uint64_t& version, const StillLayer& layer) const {
    if (version == layer.version) return;
    version = layer.version;
    if (layer.rect.width <= 0.0) return image.clear();
    image.upload(layer.canvas, static_cast<int>(layer.rect.x), static_cast<int>(layer.rect.y),
                 width_px_, height_px_);
}

void KioskScreen::update_outlines(double level, std::int64_t now_ns) {
    const ScreenContent& shown = layers_.shown();
    const bool is_new = outlined_version_ != layers_.picture().version;
    const bool is_moved = std::abs(level - level_) >= least_level_change;
    if (!is_new && !(is_moved && outline_pace_.may_change(now_ns))) return;
    strokes_.clear();
    if (shown.shown.scene)
        add_outlines(strokes_, layers_.view(), shown.shown.scene->curves, level,
                     2.0 * unit_px(cap_px_), palette_of(shown.palette));
    outlines_.upload(strokes_);
    outlined_version_ = layers_.picture().version;
    level_ = level;
    outline_pace_.changed(now_ns);
}

void KioskScreen::update_hand(const HandState& hand) {
    strokes_.clear();
    add_hand(strokes_, layers_.view(), hand, proxy_radius_m, unit_px(cap_px_),
             palette_of(layers_.shown().palette));
    hand_.upload(strokes_);
}

}  // namespace touchline
