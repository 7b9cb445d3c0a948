#include "app/screen/kiosk_screen.h"

#include "app/screen/marks.h"
#include "app/session/proxy_radius.h"

#include <cmath>

#include <epoxy/gl.h>

namespace touchline {

namespace {

constexpr double units_a_cap = 14.0;  // thin lines per capital's height

}  // namespace

Result<KioskScreen> KioskScreen::make(double cap_px) {
    auto images = ImageRenderer::make();
    if (!images) return tl::unexpected(images.error());
    auto strokes = StrokeRenderer::make();
    if (!strokes) return tl::unexpected(strokes.error());
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are multiplied by alpha
    return KioskScreen(cap_px, {std::move(*images), std::move(*strokes)});
}

KioskScreen::KioskScreen(double cap_px, Renderers renderers)
    : cap_px_(cap_px), renderers_(std::move(renderers)), live_(cap_px), layers_(cap_px) {}

void KioskScreen::draw(const FrameContent& content, int width_px, int height_px,
                       std::int64_t now_ns) {
    is_live_ = true;
    live_.draw(renderers_, content, width_px, height_px, now_ns);
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
    if (picture_.is_filled()) renderers_.images.draw(picture_);
    if (layers_.has_marks()) {
        update_outlines(content.hand.level, now_ns);
        update_hand(content.hand);
        glEnable(GL_BLEND);
        for (const StrokeBuffer* strokes : {&outlines_, &hand_})
            renderers_.strokes.draw(*strokes, width_px, height_px);
        glDisable(GL_BLEND);
    }
    renderers_.images.draw(sheet_);
    if (captions_.is_filled()) renderers_.images.draw(captions_);
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
    constexpr double least_change = 1.0 / 32.0;  // of a level; less moves no line by a pixel
    const ScreenContent& shown = layers_.shown();
    const bool is_new = outlined_version_ != layers_.picture().version;
    const bool is_moved = std::abs(level - level_) >= least_change;
    if (!is_new && !(is_moved && outline_pace_.may_change(now_ns))) return;
    strokes_.clear();
    if (shown.shown.scene)
        add_outlines(strokes_, layers_.view(), shown.shown.scene->curves, level,
                     2.0 * cap_px_ / units_a_cap, palette_of(shown.palette));
    outlines_.upload(strokes_);
    outlined_version_ = layers_.picture().version;
    level_ = level;
    outline_pace_.changed(now_ns);
}

void KioskScreen::update_hand(const HandState& hand) {
    strokes_.clear();
    add_hand(strokes_, layers_.view(), hand, proxy_radius_m, cap_px_ / units_a_cap,
             palette_of(layers_.shown().palette));
    hand_.upload(strokes_);
}

}  // namespace touchline
