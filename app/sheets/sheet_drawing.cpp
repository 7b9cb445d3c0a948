#include "app/sheets/sheet_drawing.h"

#include "config/types/utf8.h"

#include <memory>
#include <numbers>
#include <span>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pango/pangocairo.h>

namespace touchline {
namespace {

constexpr double points_per_mm = 72.0 / 25.4;

// Print is for eyes. Heat raises what is black: this blue holds no black where there are colours,
// and is a light grid of dots where there are none.
constexpr double print_red = 0.35;
constexpr double print_green = 0.6;
constexpr double print_blue = 1.0;

struct SheetSurfaceDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

    void operator()(cairo_t* context) const { cairo_destroy(context); }

    void operator()(PangoLayout* layout) const { g_object_unref(layout); }

    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};

using SheetSurface = std::unique_ptr<cairo_surface_t, SheetSurfaceDeleter>;
using SheetContext = std::unique_ptr<cairo_t, SheetSurfaceDeleter>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) noexcept {
    try {
        const auto added = std::as_bytes(std::span(data, size));
        auto& all = *static_cast<std::vector<std::byte>*>(bytes);
        all.insert(all.end(), added.begin(), added.end());
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void draw(cairo_t* cr, const SheetStroke& stroke) {
    cairo_set_line_width(cr, stroke.width_mm);
    cairo_new_path(cr);
    for (const PaperPoint& p : stroke.points) cairo_line_to(cr, p.x_mm, p.y_mm);
    if (stroke.is_closed || stroke.points.size() == 1) cairo_close_path(cr);
    cairo_stroke(cr);
}

void draw(cairo_t* cr, const BrailleBlock& block) {
    constexpr int dots = 6;
    for (const BrailleRow& row : block.rows)
        for (std::size_t cell = 0; cell < row.cells.size(); ++cell)
            for (int dot = 0; dot < dots; ++dot) {
                if ((unsigned{row.cells[cell]} >> static_cast<unsigned>(dot) & 1U) == 0) continue;
                const PaperPoint p = dot_place(row, cell, dot);
                cairo_new_path(cr);
                cairo_arc(cr, p.x_mm, p.y_mm, braille_dot_mm / 2.0, 0.0, 2.0 * std::numbers::pi);
                cairo_fill(cr);
            }
}

void draw(cairo_t* cr, const SheetPrint& print) {
    const std::unique_ptr<PangoLayout, SheetSurfaceDeleter> layout(pango_cairo_create_layout(cr));
    const std::unique_ptr<PangoFontDescription, SheetSurfaceDeleter> font(
        pango_font_description_new());
    pango_font_description_set_family_static(font.get(), "DejaVu Sans, sans-serif");
    constexpr double size_per_cap = 1.0 / 0.73;
    pango_font_description_set_absolute_size(font.get(), print.cap_mm * size_per_cap * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
    pango_layout_set_width(layout.get(), static_cast<int>(print.width_mm * PANGO_SCALE));
    pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
    const std::string text = utf8_of(print.text);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    cairo_set_source_rgb(cr, print_red, print_green, print_blue);
    const double base_mm =
        static_cast<double>(pango_layout_get_baseline(layout.get())) / PANGO_SCALE;
    cairo_move_to(cr, print.base.x_mm, print.base.y_mm - base_mm);
    pango_cairo_show_layout(cr, layout.get());
}

/// In millimetres.
void draw(cairo_t* cr, const PaperPage& page) {
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_source_rgb(cr, 0.0, 0.0, 0.0);
    for (const SheetStroke& stroke : page.strokes) draw(cr, stroke);
    for (const BrailleBlock& block : page.blocks) draw(cr, block);
    for (const SheetPrint& print : page.prints) draw(cr, print);
}

Result<void> finished(cairo_surface_t* surface, cairo_t* context) {
    cairo_status_t status = cairo_status(context);
    cairo_surface_finish(surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface);
    if (status == CAIRO_STATUS_SUCCESS) return {};
    return failure(std::string("the sheet could not be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

Result<std::vector<std::byte>> pdf_of(const TactileSheet& sheet, const std::string& title) {
    std::vector<std::byte> bytes;
    const SheetSurface surface(cairo_pdf_surface_create_for_stream(&append, &bytes, 1.0, 1.0));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, utf8_of(title).c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    const SheetContext context(cairo_create(surface.get()));
    for (const PaperPage& page : sheet.pages) {
        cairo_pdf_surface_set_size(surface.get(), page.size.width_mm * points_per_mm,
                                   page.size.height_mm * points_per_mm);
        cairo_identity_matrix(context.get());
        cairo_scale(context.get(), points_per_mm, points_per_mm);
        draw(context.get(), page);
        cairo_show_page(context.get());
    }
    return finished(surface.get(), context.get()).map([&] { return std::move(bytes); });
}

Result<std::vector<std::byte>> svg_of(const PaperPage& page) {
    std::vector<std::byte> bytes;
    const SheetSurface surface(cairo_svg_surface_create_for_stream(
        &append, &bytes, page.size.width_mm, page.size.height_mm));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
    const SheetContext context(cairo_create(surface.get()));
    draw(context.get(), page);
    return finished(surface.get(), context.get()).map([&] { return std::move(bytes); });
}

}  // namespace touchline
