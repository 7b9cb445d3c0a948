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

constexpr double least_level_change = 1.0 / 32.0;          // less moves no line by a pixel
constexpr std::int64_t longest_unseen_ns = 2'000'000'000;  // whatever took the display's pixels

/// The width of a thin line beside capitals of this height.
double unit_px(double cap_px) {
    return cap_px / 14.0;
}

}  // namespace

Result<KioskScreen> KioskScreen::make(double cap_px) {
    auto renderer = Renderer::make();
    if (!renderer) return tl::unexpected(renderer.error());
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are multiplied by alpha
    return KioskScreen(cap_px, std::move(*renderer));
}

KioskScreen::KioskScreen(double cap_px, Renderer renderer)
    : cap_px_(cap_px), renderer_(std::move(renderer)), layers_(cap_px) {}

bool KioskScreen::draw(const ScreenContent& content, int width_px, int height_px,
                       std::int64_t now_ns) {
    layers_.update(content, width_px, height_px, now_ns);
    bool is_new = upload_layers(width_px, height_px);
    if (layers_.has_marks())
        is_new = update_marks(content, now_ns) || is_new;
    else
        trail_.clear();
    if (!is_new && drawn_ns_ && now_ns - *drawn_ns_ < longest_unseen_ns) return false;
    drawn_ns_ = now_ns;
    draw_all();
    return true;
}

void KioskScreen::draw_all() {
    glViewport(0, 0, width_px_, height_px_);
    // Opaque layers cover the whole screen, so no clearing is needed, and without blending software
    // drawing copies them. Words come last, so that no mark lies over a letter.
    glDisable(GL_BLEND);
    if (images_.front().is_filled()) renderer_.draw(images_.front());
    if (layers_.has_marks()) {
        glEnable(GL_BLEND);
        for (const StrokeBuffer* strokes : {&boxes_, &outlines_, &pen_, &hand_})
            renderer_.draw(*strokes, width_px_, height_px_);
        glDisable(GL_BLEND);
    }
    for (std::size_t i = 1; i < layer_count; ++i)
        if (images_[i].is_filled()) renderer_.draw(images_[i]);
}

bool KioskScreen::update_marks(const ScreenContent& content, std::int64_t now_ns) {
    const HandState& hand = content.hand;
    // Visitors see the finest lines, the staff those that are felt.
    const bool are_outlines_new = update_outlines(layers_.shown().live ? hand.level : 0.0, now_ns);
    const bool are_boxes_new = update_boxes(hand);
    const bool is_pen_new = update_pen(content.stroke);
    return update_hand(hand, now_ns) || are_outlines_new || are_boxes_new || is_pen_new;
}

bool KioskScreen::upload_layers(int width_px, int height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    bool is_new = upload(0, layers_.picture());
    std::size_t image = 1;
    for (const StillLayer* layer : layers_.words()) is_new = upload(image++, *layer) || is_new;
    return is_new;
}

bool KioskScreen::upload(std::size_t image, const StillLayer& layer) {
    if (versions_.at(image) == layer.version) return false;
    versions_.at(image) = layer.version;
    if (layer.rect.width <= 0.0) {
        images_.at(image).clear();
        return true;
    }
    images_.at(image).upload(layer.canvas, static_cast<int>(layer.rect.x),
                             static_cast<int>(layer.rect.y), width_px_, height_px_);
    return true;
}

bool KioskScreen::update_outlines(double level, std::int64_t now_ns) {
    const ScreenContent& shown = layers_.shown();
    const bool is_new = outlined_version_ != layers_.picture().version;
    const bool is_moved = std::abs(level - level_) >= least_level_change;
    if (!is_new && !(is_moved && outline_pace_.may_change(now_ns))) return false;
    strokes_.clear();
    if (shown.shown.scene)
        add_outlines(strokes_, layers_.view(), shown.shown.scene->curves, level,
                     2.0 * unit_px(cap_px_), palette_of(shown.palette));
    (void)outlines_.upload(strokes_);
    outlined_version_ = layers_.picture().version;
    level_ = level;
    outline_pace_.changed(now_ns);
    return true;
}

bool KioskScreen::update_boxes(const HandState& hand) {
    const ScreenContent& shown = layers_.shown();
    strokes_.clear();
    if (shown.live && shown.live->shows_boxes && shown.shown.scene) {
        const Scene& scene = *shown.shown.scene;
        std::vector<ErrorBox> boxes;
        const int level = static_cast<int>(std::ceil(hand.level));
        scene.tree.boundary_section(scene.curves, hand.p_WH, level, boxes);
        add_boxes(strokes_, layers_.view(), boxes, 0.75 * unit_px(cap_px_),
                  palette_of(shown.palette));
    }
    return boxes_.upload(strokes_);
}

bool KioskScreen::update_pen(const std::vector<Position>& stroke_W) {
    strokes_.clear();
    add_pen(strokes_, layers_.view(), stroke_W, unit_px(cap_px_),
            palette_of(layers_.shown().palette));
    return pen_.upload(strokes_);
}

bool KioskScreen::update_hand(const HandState& hand, std::int64_t now_ns) {
    const Palette& palette = palette_of(layers_.shown().palette);
    const double line_px = unit_px(cap_px_);
    trail_.add(hand.p_WH, now_ns);
    strokes_.clear();
    trail_.add_to(strokes_, layers_.view(), 3.0 * line_px, palette.proxy);
    add_hand(strokes_, layers_.view(), hand, proxy_radius_m, line_px, palette);
    return hand_.upload(strokes_);
}

}  // namespace touchline
