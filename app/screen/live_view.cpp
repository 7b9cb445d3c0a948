#include "app/screen/live_view.h"

#include "app/screen/marks.h"
#include "app/screen/paint.h"
#include "app/screen/panel.h"
#include "app/session/first_feel.h"

#include <cmath>
#include <vector>

#include <epoxy/gl.h>

namespace touchline {

namespace {

constexpr std::int64_t panel_period_ns = 200'000'000;

Canvas canvas_for(const Rect& rect) {
    return {static_cast<int>(rect.width), static_cast<int>(rect.height)};
}

/// The rectangle in its own pixels.
Rect at_origin(const Rect& rect) {
    return {0.0, 0.0, rect.width, rect.height};
}

}  // namespace

void LiveView::draw(const Renderers& renderers, const FrameContent& content, int width_px,
                    int height_px, std::int64_t now_ns) {
    if (width_px != width_px_ || height_px != height_px_) lay_out_again(width_px, height_px);
    update_picture(content.shown);
    update_panel(content.status, now_ns);
    update_overlay(content);
    if (content.shown.scene) update_outlines(*content.shown.scene, content.hand.level);
    update_boxes(content);
    update_hand(content.hand);
    is_stale_ = false;

    glViewport(0, 0, width_px_, height_px_);
    // The two opaque layers cover the whole screen: no clearing, and without blending software
    // drawing copies them.
    glDisable(GL_BLEND);
    renderers.images.draw(picture_);
    glEnable(GL_BLEND);
    for (const StrokeBuffer* strokes : {&boxes_, &outlines_, &hand_})
        renderers.strokes.draw(*strokes, width_px_, height_px_);
    if (!painted_message_.empty()) renderers.images.draw(overlay_);
    glDisable(GL_BLEND);
    renderers.images.draw(panel_);
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
    paint_frame(canvas.context(), area_rect(area, local), unit_px());
    upload(picture_, canvas, layout_.picture);
    view_ = view_of(area, layout_.picture);
    painted_picture_ = shown.picture;
    outlined_level_ = -1.0;
}

void LiveView::update_panel(const Status& status, std::int64_t now_ns) {
    if (!is_stale_ && (status == painted_status_ || now_ns - panel_ns_ < panel_period_ns)) return;
    const Canvas canvas = canvas_for(layout_.panel);
    paint_panel(canvas.context(), at_origin(layout_.panel), status, cap_px_);
    upload(panel_, canvas, layout_.panel);
    painted_status_ = status;
    panel_ns_ = now_ns;
}

void LiveView::update_overlay(const FrameContent& content) {
    const std::string& message = content.status.message;
    if (!is_stale_ && message == painted_message_) return;
    painted_message_ = message;
    if (painted_message_.empty()) return;
    const Canvas canvas = canvas_for(layout_.picture);
    const Rect rect = at_origin(layout_.picture);
    if (!message.empty()) paint_message(canvas.context(), rect, message, cap_px_);
    upload(overlay_, canvas, layout_.picture);
}

void LiveView::update_outlines(const Scene& scene, double level) {
    constexpr double least_change = 1.0 / 32.0;  // of a level: less moves no line by a pixel
    const bool is_same_scene = outlined_version_ == scene.map_version && outlined_level_ >= 0.0;
    if (is_same_scene && std::abs(level - outlined_level_) < least_change) return;
    strokes_.clear();
    add_outlines(strokes_, view_, scene.curves, level, 1.5 * unit_px());
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
        add_boxes(strokes_, view_, boxes, 0.75 * unit_px());
    }
    boxes_.upload(strokes_);
}

void LiveView::update_hand(const HandState& hand) {
    strokes_.clear();
    add_hand(strokes_, view_, hand, proxy_radius_m, unit_px());
    hand_.upload(strokes_);
}

}  // namespace touchline
