#include "app/screen/screen_layers.h"

#include "app/screen/paint.h"

#include <algorithm>

namespace touchline {

namespace {

constexpr std::int64_t least_sign_ns = 1'000'000'000;  // a shorter time would be unreadable
constexpr std::int64_t preview_period_ns = 100'000'000;
constexpr std::int64_t panel_period_ns = 200'000'000;  // else its numbers cannot be read

/// Gives the layer a new canvas whose coordinates are the screen's.
void renew(StillLayer& layer, const Rect& rect) {
    layer.rect = rect;
    layer.canvas = Canvas(std::max(static_cast<int>(rect.width), 1),
                          std::max(static_cast<int>(rect.height), 1));
    cairo_translate(layer.canvas.context(), -rect.x, -rect.y);
    ++layer.version;
}

bool wants_picture(const ScreenContent& content) {
    if (content.screen.view == ScreenView::picture) return true;
    return content.screen.view == ScreenView::camera && content.is_preview_on;
}

/// Compares size, colours and curtain, which screen and captions share.
bool is_same_style(const ScreenContent& a, const ScreenContent& b) {
    return a.text_size == b.text_size && a.palette == b.palette && a.is_curtain == b.is_curtain &&
           a.language.code() == b.language.code();
}

/// Compares all that has a place of its own: not the focus, nor what follows from it.
bool is_same_list(const ScreenContent& a, const ScreenContent& b) {
    return a.screen.title == b.screen.title && a.screen.text == b.screen.text &&
           a.screen.view == b.screen.view && a.screen.items == b.screen.items &&
           a.screen.way == b.screen.way && a.pictures == b.pictures;
}

bool is_same_picture(const ScreenContent& a, const ScreenContent& b) {
    if (wants_picture(a) != wants_picture(b)) return false;
    if (a.screen.view != ScreenView::picture) return true;
    return a.shown.picture == b.shown.picture && a.shown.scene == b.shown.scene;
}

bool is_same_screen(const ScreenContent& a, const ScreenContent& b) {
    return is_same_style(a, b) && is_same_picture(a, b) && is_same_list(a, b) &&
           a.screen == b.screen && a.live.has_value() == b.live.has_value() &&
           a.switches == b.switches;
}

}  // namespace

void ScreenLayers::update(const ScreenContent& content, int width_px, int height_px,
                          std::int64_t now_ns) {
    take_sign(content.sound_sign, now_ns);
    const bool is_resized = width_px != width_px_ || height_px != height_px_;
    width_px_ = width_px;
    height_px_ = height_px;
    if (is_resized || (content.is_curtain && !shown_.is_curtain)) {
        show_screen(content, now_ns);
        show_captions(content, now_ns);
    }
    update_screen(content, now_ns);
    if (shown_.is_curtain) return;
    update_captions(content, now_ns);
    update_preview(content, now_ns);
    update_panel(content, now_ns);
}

void ScreenLayers::take_sign(const std::string& sign, std::int64_t now_ns) {
    if (!sign.empty()) {
        sign_ = sign;
        sign_ns_ = now_ns;
    } else if (now_ns - sign_ns_ >= least_sign_ns) {
        sign_.clear();
    }
}

bool ScreenLayers::is_screen_due(const ScreenContent& content, std::int64_t now_ns) const {
    if (!screen_pace_.may_change(now_ns)) return false;
    return is_same_style(content, shown_) || caption_pace_.may_change(now_ns);
}

void ScreenLayers::update_screen(const ScreenContent& content, std::int64_t now_ns) {
    const bool has_changed = !is_same_screen(content, shown_);
    const bool has_turned =
        !has_changed && !shown_.is_curtain &&
        (pages_now(shown_.screen, now_ns) != pages_ || title_page_now(now_ns) != title_page_);
    if (!(has_changed || has_turned) || !is_screen_due(content, now_ns)) return;
    if (has_turned) {
        screen_pace_.changed(now_ns);
        return turn_pages(now_ns);
    }
    const bool is_restyled = !is_same_style(content, shown_);
    show_screen(content, now_ns);
    if (is_restyled) show_captions(content, now_ns);
}

void ScreenLayers::show_screen(const ScreenContent& content, std::int64_t now_ns) {
    const TextSizes sizes = text_sizes(content.text_size, normal_cap_px_, width_px_, height_px_);
    const Arrangement arrangement =
        arrange(width_px_, height_px_, sizes, {wants_picture(content), content.live.has_value()});
    const bool is_laid_out = arrangement == arrangement_ && sizes == sizes_ &&
                             is_same_style(content, shown_) && screen_pace_.has_changed() &&
                             is_same_list(content, shown_);
    const bool is_painted = is_laid_out && is_same_picture(content, shown_);
    if (!is_laid_out) screen_ns_ = now_ns;
    focus_ns_ = now_ns;
    const std::string caption = shown_.caption;
    const std::string sign = shown_.sound_sign;
    shown_ = content;
    shown_.caption = caption;  // captions change at times of their own
    shown_.sound_sign = sign;
    sizes_ = sizes;
    arrangement_ = arrangement;
    screen_pace_.changed(now_ns);
    if (content.is_curtain) return paint_curtain();
    if (!is_laid_out) {
        cairo_t* const cr = sheet_.canvas.context();
        header_layout_ =
            lay_out_header(cr, content.screen, arrangement.header, sizes, content.language);
        sheet_layout_ =
            lay_out_sheet(cr, content.screen, arrangement.sheet, sizes, !content.pictures.empty());
        paint_panel_layer();
    }
    turn_pages(now_ns);
    if (captions_.rect.width > 0.0) paint_caption_layer();  // its keys may be others
    if (!is_painted) paint_picture_layer();
}

SheetPages ScreenLayers::pages_now(const SpokenScreen& screen, std::int64_t now_ns) const {
    return sheet_pages(sheet_layout_, screen.focus, now_ns - screen_ns_, now_ns - focus_ns_);
}

std::size_t ScreenLayers::title_page_now(std::int64_t now_ns) const {
    const std::vector<SheetPage>& pages = header_layout_.title.pages;
    return page_at(pages, {0, pages.size()}, now_ns - screen_ns_);
}

void ScreenLayers::turn_pages(std::int64_t now_ns) {
    pages_ = pages_now(shown_.screen, now_ns);
    title_page_ = title_page_now(now_ns);
    paint_pages();
}

void ScreenLayers::paint_pages() {
    const Palette& palette = palette_of(shown_.palette);
    renew(header_, arrangement_.header);
    paint_header(header_.canvas.context(), header_layout_, shown_.screen, title_page_, palette,
                 shown_.language);
    renew(sheet_, arrangement_.sheet);
    paint_sheet(sheet_.canvas.context(), sheet_layout_,
                face_of(sheet_layout_, shown_.screen, pages_), shown_.pictures, palette);
}

void ScreenLayers::update_captions(const ScreenContent& content, std::int64_t now_ns) {
    const bool is_same = content.caption == shown_.caption && sign_ == shown_.sound_sign &&
                         caption_page_now(now_ns) == caption_page_;
    if (!is_same && caption_pace_.may_change(now_ns)) show_captions(content, now_ns);
}

void ScreenLayers::show_captions(const ScreenContent& content, std::int64_t now_ns) {
    caption_pace_.changed(now_ns);
    if (content.caption != shown_.caption) caption_ns_ = now_ns;
    shown_.caption = content.caption;
    shown_.sound_sign = sign_;
    if (shown_.is_curtain) return;
    caption_layout_ = lay_out_caption(captions_.canvas.context(), shown_.caption,
                                      arrangement_.captions, sizes_, shown_.language);
    caption_page_ = caption_page_now(now_ns);
    paint_caption_layer();
}

std::size_t ScreenLayers::caption_page_now(std::int64_t now_ns) const {
    const std::vector<SheetPage>& pages = caption_layout_.text.pages;
    return page_at(pages, {0, pages.size()}, now_ns - caption_ns_);
}

void ScreenLayers::paint_caption_layer() {
    renew(captions_, arrangement_.captions);
    CaptionFace face{caption_page_, shown_.sound_sign, {}};
    if (!shown_.has_ended) face.keys = legend_of(shown_.screen, shown_.switches, shown_.language);
    paint_captions(captions_.canvas.context(), caption_layout_, face, palette_of(shown_.palette));
}

void ScreenLayers::update_preview(const ScreenContent& content, std::int64_t now_ns) {
    const bool is_shown = shown_.screen.view == ScreenView::camera && picture_.rect.width > 0.0;
    if (!is_shown || content.preview == shown_.preview) return;
    if (now_ns - preview_ns_ < preview_period_ns) return;
    preview_ns_ = now_ns;
    shown_.preview = content.preview;
    paint_picture_layer();
}

void ScreenLayers::paint_picture_layer() {
    renew(picture_, arrangement_.picture);
    const Palette& palette = palette_of(shown_.palette);
    cairo_t* const cr = picture_.canvas.context();
    const Rect& rect = arrangement_.picture;
    const Area area = shown_.shown.scene ? shown_.shown.scene->area : Area{};
    view_ = view_of(area, rect.width > 0.0 ? rect
                                           : Rect{0.0, 0.0, static_cast<double>(width_px_),
                                                  static_cast<double>(height_px_)});
    if (rect.width <= 0.0) return;
    fill(cr, rect, {palette.background});
    if (shown_.screen.view == ScreenView::camera) {
        if (shown_.preview) paint_preview(cr, rect, *shown_.preview);
        return;
    }
    if (shown_.shown.picture)
        paint_picture(cr, view_, area, *shown_.shown.picture, palette.picture_alpha);
    paint_frame(cr, area_rect(area, view_), std::max(0.07 * sizes_.normal_px, 1.0), palette.frame);
}

void ScreenLayers::update_panel(const ScreenContent& content, std::int64_t now_ns) {
    const bool is_shown = content.live && shown_.live && panel_.rect.width > 0.0;
    if (!is_shown || content.live == shown_.live) return;
    if (now_ns - panel_ns_ < panel_period_ns) return;
    panel_ns_ = now_ns;
    shown_.live = content.live;
    paint_panel_layer();
}

void ScreenLayers::paint_panel_layer() {
    renew(panel_, arrangement_.panel);
    if (!shown_.live) return;
    paint_live(panel_.canvas.context(), panel_.rect, *shown_.live, sizes_.cap_px,
               palette_of(shown_.palette), shown_.language);
}

void ScreenLayers::paint_curtain() {
    constexpr Colour black{0.0, 0.0, 0.0};
    constexpr Colour dim{0.6, 0.6, 0.6};  // 7:1
    const Rect all{0.0, 0.0, static_cast<double>(width_px_), static_cast<double>(height_px_)};
    renew(sheet_, all);
    for (StillLayer* layer : {&header_, &captions_, &picture_, &panel_}) renew(*layer, {});
    cairo_t* const cr = sheet_.canvas.context();
    fill(cr, all, {black});
    const Rect band = arrange(width_px_, height_px_, sizes_, {}).captions;
    const double margin_px = 0.5 * sizes_.normal_px;
    const TurnedText line = turned_text(
        cr, shown_.language.text("screen", "The screen is off. Settings, Screen turns it on."),
        {band.x + margin_px, band.y, band.width - 2.0 * margin_px, band.height}, {sizes_.normal_px},
        1.0);
    paint_turned(cr, line, 0, dim);
}

bool ScreenLayers::has_marks() const {
    return !shown_.is_curtain && shown_.screen.view == ScreenView::picture &&
           picture_.rect.width > 0.0;
}

}  // namespace touchline
