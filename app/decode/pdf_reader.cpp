// One page of a PDF: its pixels, its words with their boxes, and its figures' texts.
#include "app/decode/drawing_surface.h"
#include "app/decode/formats.h"
#include "app/decode/machine_words.h"
#include "app/decode/pdf_parts.h"
#include "app/decode/pdf_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace touchline::decode {
namespace {

constexpr double points_per_inch = 72.0;

/// The scale of a page: pixels per unit, and the same in pixels per inch.
struct Scale {
    double px_per_unit = 1.0;
    double dpi = points_per_inch;
};

/// The wanted scale, or as many pixels as the largest picture allows. A hand feels every page at
/// the same size, so a page smaller than A5 counts as A5, and one larger than A2 as A2.
Scale scale_for(const PageSize& page, double user_unit, int dpi) {
    constexpr double least_longer_in = 8.0;
    constexpr double most_longer_in = 24.0;
    const double longer = std::max(page.width_pt, page.height_pt);
    const double longer_in = longer * user_unit / points_per_inch;
    const double counts_as = std::clamp(longer_in, least_longer_in, most_longer_in) / longer;
    const double most = 0.99 * std::min(static_cast<double>(max_picture_side_px) / longer,
                                        std::sqrt(static_cast<double>(max_picture_pixels) /
                                                  (page.width_pt * page.height_pt)));
    const double px_per_unit = std::min(dpi * counts_as, most);
    return {px_per_unit, px_per_unit / counts_as};
}

tl::unexpected<Error> refusal(const GlibError& error) {
    if (error != nullptr && g_error_matches(error.get(), POPPLER_ERROR, POPPLER_ERROR_ENCRYPTED))
        return failure("the PDF document is locked with a password; save it without one");
    return damaged("PDF", error != nullptr ? error->message : "");
}

PopplerRectangle points_of(const TextBox& box, double scale) {
    return {box.left / scale, box.top / scale, box.right / scale, box.bottom / scale};
}

TextBox box_of(const PopplerRectangle& box, double scale) {
    return {scale * box.x1, scale * box.y1, scale * box.x2, scale * box.y2};
}

void add_word_box(const TextBox& box, Page& page) {
    const auto word = pixels_within(box, page.picture);
    if (word && page.words.size() < max_word_boxes) page.words.push_back(*word);
}

void add_label(const std::string& text, const TextBox& box, Page& page) {
    const double x = (box.left + box.right) / 2.0;
    const double y = (box.top + box.bottom) / 2.0;
    const bool is_on_page =
        x >= 0.0 && y >= 0.0 && x <= page.picture.width && y <= page.picture.height;
    if (is_on_page) page.told.labels.push_back({text, told_place(page.picture, x, y)});
}

/// Adds the figures' texts.
void tell_figures(const std::vector<PdfText>& figures, double scale, Page& page) {
    for (const PdfText& figure : figures) {
        if (figure.text.empty()) continue;
        if (!page.told.description.empty()) page.told.description += ' ';
        page.told.description += figure.text;
        if (figure.box.x1 < figure.box.x2) add_label(figure.text, box_of(figure.box, scale), page);
    }
}

/// Adds the places of pictures.
void add_figures(std::vector<PdfText> parts, const std::vector<PopplerRectangle>& images,
                 const PageSize& size, double scale, Page& page) {
    for (const PopplerRectangle& image : images) parts.push_back({"", image});
    for (const PdfText& picture : pictures_in(std::move(parts), size))
        if (const auto box = pixels_within(box_of(picture.box, scale), page.picture))
            page.figures.push_back({*box, picture.text});
}

/// The texts that a visitor could see, once each.
class Texts {
  public:
    Texts(const LetterInk& ink, Page& page) : ink_(ink), page_(page) {}

    void add(const DrawnText& text) {
        const double contrast = painting_of(text, ink_, page_.picture).contrast;
        if (contrast == 0.0 && !looks_written(text, page_.picture)) return;
        if (!is_told(text, contrast)) add_label(text.text, text.box, page_);
        told_.push_back(&text);
        for (const DrawnWord& word : text.words) add_boxes(text, word, contrast > 0.0);
    }

  private:
    /// True if the text is a repetition: a shadow or bold letters drawn twice lie where their text
    /// does; a watermark may be anywhere.
    bool is_told(const DrawnText& text, double contrast) const {
        constexpr double pale = 110.0;  // levels
        const bool is_everywhere = text.is_slanted || (contrast > 0.0 && contrast < pale);
        return std::ranges::any_of(told_, [&](const DrawnText* told) {
            return told->text == text.text && (is_everywhere || meet(told->box, text.box));
        });
    }

    static bool meet(const TextBox& a, const TextBox& b) {
        return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    }

    /// Takes the boxes of letters for a slanted word, whose own box holds much that is not the
    /// word.
    void add_boxes(const DrawnText& text, const DrawnWord& word, bool is_inked) {
        const auto add = [&](const TextBox& box) {
            add_word_box(is_inked ? inked(box, ink_) : box, page_);
        };
        if (!text.is_slanted) return add(word.box);
        for (const TextBox& letter : word.letters) add(letter);
    }

    const LetterInk& ink_;
    Page& page_;
    std::vector<const DrawnText*> told_;
};

std::string title_of(PopplerDocument* document, PopplerPage* page) {
    std::string title = heading_of(document, page);
    if (!title.empty()) return title;
    const GlibText own(poppler_document_get_title(document));
    return own == nullptr ? std::string() : of_a_person(own.get());
}

Result<Picture> picture_of(PopplerPage* source, const PageSize& size, double scale) {
    DrawingSurface sheet(std::max(1, static_cast<int>(std::lround(scale * size.width_pt))),
                         std::max(1, static_cast<int>(std::lround(scale * size.height_pt))));
    sheet.whiten();
    cairo_scale(sheet.context(), scale, scale);
    poppler_page_render(source, sheet.context());
    return sheet.picture();
}

Result<Page> read_page(PopplerDocument* document, PopplerPage* source, Bytes bytes,
                       const PageOrder& order) {
    PageSize size;
    poppler_page_get_size(source, &size.width_pt, &size.height_pt);
    if (!(size.width_pt > 0.0 && size.height_pt > 0.0) ||
        !std::isfinite(size.width_pt * size.height_pt))
        return damaged("PDF", "the page has no size");
    PdfProgram program(bytes);
    const Scale drawn_at = scale_for(size, program.user_unit(order.page), order.dpi);
    const double scale = drawn_at.px_per_unit;
    auto picture = picture_of(source, size, scale);
    if (!picture) return tl::unexpected(picture.error());
    Page page;
    page.picture = std::move(*picture);
    page.told.area = told_area(page.picture);
    page.told.title = title_of(document, source);
    const DrawnPage drawn = program.drawn(order.page, scale);
    std::vector<PopplerRectangle> images;
    for (const TextBox& image : drawn.images) images.push_back(points_of(image, scale));
    std::vector<PdfText> figures = figures_of(document, source, images);
    tell_figures(figures, scale, page);
    add_figures(std::move(figures), images, size, scale, page);
    const std::vector<DrawnText> texts = texts_in(drawn.letters);
    Texts seen(drawn.ink, page);
    for (const DrawnText& text : texts) seen.add(text);
    page.number = order.page;
    page.dpi = static_cast<int>(std::lround(drawn_at.dpi));
    return page;
}

}  // namespace

Result<Page> read_pdf(Bytes bytes, const PageOrder& order) {
    GError* problem = nullptr;
    const Owned<GBytes, g_bytes_unref> held(g_bytes_new_static(bytes.data(), bytes.size()));
    const GlibObject<PopplerDocument> document(
        poppler_document_new_from_bytes(held.get(), nullptr, &problem));
    if (document == nullptr) return refusal(GlibError(problem));
    const int count = std::min(poppler_document_get_n_pages(document.get()), max_pages);
    if (count < 1) return damaged("PDF", "it has no page");
    if (order.page > count)
        return failure(fmt::format("the document has {} {}; choose one of them", count,
                                   count == 1 ? "page" : "pages"));
    const GlibObject<PopplerPage> page(poppler_document_get_page(document.get(), order.page - 1));
    if (page == nullptr) return damaged("PDF", "the page is missing");
    auto read = read_page(document.get(), page.get(), bytes, order);
    if (read) read->count = count;
    return read;
}

}  // namespace touchline::decode
