// One page of a PDF: its pixels, its words with their boxes, what was written of its figures.
#include "app/decode/formats.h"
#include "app/decode/machine_words.h"
#include "app/decode/pdf_parts.h"
#include "app/decode/sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace touchline::decode {
namespace {

constexpr double points_per_inch = 72.0;

/// Pixels per point: as asked for, or as many as the largest picture allows.
double scale_for(double width_pt, double height_pt, int dpi) {
    const double longer = std::max(width_pt, height_pt);
    const double most =
        0.99 *
        std::min(static_cast<double>(max_picture_side_px) / longer,
                 std::sqrt(static_cast<double>(max_picture_pixels) / (width_pt * height_pt)));
    return std::min(dpi / points_per_inch, most);
}

tl::unexpected<Error> refusal(const GlibOwned<GError>& error) {
    if (error != nullptr && g_error_matches(error.get(), POPPLER_ERROR, POPPLER_ERROR_ENCRYPTED))
        return failure("the PDF document is locked with a password; save it without one");
    return damaged("PDF", error != nullptr ? error->message : "");
}

/// Of points, as pixels; none where no pixel of the page is within.
std::optional<WordBox> pixels_in(const PopplerRectangle& box, double scale,
                                 const Picture& picture) {
    return pixels_within({scale * box.x1, scale * box.y1, scale * box.x2, scale * box.y2}, picture);
}

void add_word_box(const PopplerRectangle& box, double scale, Page& page) {
    const auto word = pixels_in(box, scale, page.picture);
    if (word && page.words.size() < max_word_boxes) page.words.push_back(*word);
}

void add_label(const PdfText& text, double scale, Page& page) {
    const double x = scale * (text.box.x1 + text.box.x2) / 2.0;
    const double y = scale * (text.box.y1 + text.box.y2) / 2.0;
    const bool is_on_page =
        x >= 0.0 && y >= 0.0 && x <= page.picture.width && y <= page.picture.height;
    if (is_on_page) page.told.labels.push_back({text.text, told_place(page.picture, x, y)});
}

/// What is written of the figures.
void tell_figures(const std::vector<PdfText>& figures, double scale, Page& page) {
    for (const PdfText& figure : figures) {
        if (figure.text.empty()) continue;
        if (!page.told.description.empty()) page.told.description += ' ';
        page.told.description += figure.text;
        if (figure.box.x1 < figure.box.x2) add_label(figure, scale, page);
    }
}

/// Where pictures are.
void add_figures(std::vector<PdfText> parts, PopplerPage* source, double scale, Page& page) {
    PageSize size;
    poppler_page_get_size(source, &size.width_pt, &size.height_pt);
    for (const PopplerRectangle& image : image_boxes(source)) parts.push_back({"", image});
    for (const PdfText& picture : pictures_in(std::move(parts), size))
        if (const auto box = pixels_in(picture.box, scale, page.picture))
            page.figures.push_back({*box, picture.text});
}

std::string title_of(PopplerDocument* document, PopplerPage* page) {
    std::string title = heading_of(document, page);
    if (!title.empty()) return title;
    const GlibOwned<gchar> own(poppler_document_get_title(document));
    return own == nullptr ? std::string() : of_a_person(own.get());
}

Result<Page> read_page(PopplerDocument* document, PopplerPage* source, const PageOrder& order) {
    double width_pt = 0.0;
    double height_pt = 0.0;
    poppler_page_get_size(source, &width_pt, &height_pt);
    if (!(width_pt > 0.0 && height_pt > 0.0) || !std::isfinite(width_pt * height_pt))
        return damaged("PDF", "the page has no size");
    const double scale = scale_for(width_pt, height_pt, order.dpi);
    Sheet sheet(std::max(1, static_cast<int>(std::lround(scale * width_pt))),
                std::max(1, static_cast<int>(std::lround(scale * height_pt))));
    sheet.whiten();
    cairo_scale(sheet.context(), scale, scale);
    poppler_page_render(source, sheet.context());
    auto picture = sheet.picture();
    if (!picture) return tl::unexpected(picture.error());
    Page page;
    page.picture = std::move(*picture);
    page.told.area = told_area(page.picture);
    page.told.title = title_of(document, source);
    std::vector<PdfText> figures = figures_of(document, source);
    tell_figures(figures, scale, page);
    add_figures(std::move(figures), source, scale, page);
    for (const PdfText& text : texts_of(source)) {
        add_label(text, scale, page);
        add_word_box(text.box, scale, page);
    }
    page.number = order.page;
    page.dpi = static_cast<int>(std::lround(points_per_inch * scale));
    return page;
}

}  // namespace

Result<Page> read_pdf(Bytes bytes, const PageOrder& order) {
    GError* problem = nullptr;
    const GlibOwned<GBytes> held(g_bytes_new_static(bytes.data(), bytes.size()));
    const GlibOwned<PopplerDocument> document(
        poppler_document_new_from_bytes(held.get(), nullptr, &problem));
    if (document == nullptr) return refusal(GlibOwned<GError>(problem));
    const int count = std::min(poppler_document_get_n_pages(document.get()), max_pages);
    if (count < 1) return damaged("PDF", "it has no page");
    if (order.page > count)
        return failure(fmt::format("the document has {} {}; choose one of them", count,
                                   count == 1 ? "page" : "pages"));
    const GlibOwned<PopplerPage> page(poppler_document_get_page(document.get(), order.page - 1));
    if (page == nullptr) return damaged("PDF", "the page is missing");
    auto read = read_page(document.get(), page.get(), order);
    if (read) read->count = count;
    return read;
}

}  // namespace touchline::decode
