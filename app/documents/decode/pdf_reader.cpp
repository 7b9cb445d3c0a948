// One page of a PDF: its pixels, its words with their boxes, and its figures' texts.
#include "app/documents/decode/drawing_surface.h"
#include "app/documents/decode/page.h"
#include "app/documents/decode/pdf_words.h"
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poppler.h>

namespace touchline::decode {
namespace {

/// A text and its box; the box is empty if the document does not say. Places are in points of 1/72
/// inch from the upper left corner of the page.
struct PdfText {
    std::string text;
    PopplerRectangle box{};  // y1 above y2
};

struct PageSize {
    double width_pt = 0.0;
    double height_pt = 0.0;
};

constexpr int deepest = 50;
constexpr int most_elements = 20'000;  // a book of hundreds of pages

std::string taken(gchar* text) {
    const GlibText owned(text);
    return owned == nullptr ? std::string() : std::string(owned.get());
}

/// Walks over the elements of one page, in reading order, until `visit` returns false.
class StructureWalk {
  public:
    using Visit = std::function<bool(PopplerStructureElement*)>;

    StructureWalk(int page, Visit visit) : page_(page), visit_(std::move(visit)) {}

    void walk(PopplerDocument* document) {
        walk(Iter(poppler_structure_element_iter_new(document)), 0);
    }

  private:
    using Iter = Owned<PopplerStructureElementIter, poppler_structure_element_iter_free>;

    void walk(const Iter& at, int depth) {
        if (at == nullptr || depth > deepest) return;
        do {
            if (is_done_ || ++seen_ > most_elements) return;
            const Owned<PopplerStructureElement, g_object_unref> element(
                poppler_structure_element_iter_get_element(at.get()));
            if (element != nullptr && poppler_structure_element_get_page(element.get()) == page_)
                is_done_ = !visit_(element.get());
            walk(Iter(poppler_structure_element_iter_get_child(at.get())), depth + 1);
        } while (poppler_structure_element_iter_next(at.get()) != FALSE);
    }

    int page_;
    Visit visit_;
    int seen_ = 0;
    bool is_done_ = false;
};

bool is_heading(PopplerStructureElementKind kind) {
    return kind == POPPLER_STRUCTURE_ELEMENT_HEADING ||
           (kind >= POPPLER_STRUCTURE_ELEMENT_HEADING_1 &&
            kind <= POPPLER_STRUCTURE_ELEMENT_HEADING_6);
}

constexpr double least_side_pt = 28.0;  // 1 cm
constexpr double fills_page = 0.9;      // of the page's area: a scan of it, or its background
constexpr double touching_pt = 1.0;
constexpr std::size_t most_parts = 1000;

bool is_finite(const PopplerRectangle& box) {
    return std::isfinite(box.x1) && std::isfinite(box.y1) && std::isfinite(box.x2) &&
           std::isfinite(box.y2);
}

PopplerRectangle on_page(const PopplerRectangle& box, const PageSize& page) {
    return {std::clamp(std::min(box.x1, box.x2), 0.0, page.width_pt),
            std::clamp(std::min(box.y1, box.y2), 0.0, page.height_pt),
            std::clamp(std::max(box.x1, box.x2), 0.0, page.width_pt),
            std::clamp(std::max(box.y1, box.y2), 0.0, page.height_pt)};
}

bool touch(const PopplerRectangle& a, const PopplerRectangle& b) {
    return a.x1 <= b.x2 + touching_pt && b.x1 <= a.x2 + touching_pt && a.y1 <= b.y2 + touching_pt &&
           b.y1 <= a.y2 + touching_pt;
}

bool fills(const PopplerRectangle& box, const PageSize& page) {
    return (box.x2 - box.x1) * (box.y2 - box.y1) >= fills_page * page.width_pt * page.height_pt;
}

bool decorates(const PopplerRectangle& box) {
    return std::min(box.x2 - box.x1, box.y2 - box.y1) < least_side_pt;
}

void absorb(PdfText& whole, const PdfText& part) {
    whole.box = {std::min(whole.box.x1, part.box.x1), std::min(whole.box.y1, part.box.y1),
                 std::max(whole.box.x2, part.box.x2), std::max(whole.box.y2, part.box.y2)};
    if (part.text.empty() || whole.text.find(part.text) != std::string::npos) return;
    if (!whole.text.empty()) whole.text += ' ';
    whole.text += part.text;
}

std::vector<PdfText> joined_once(const std::vector<PdfText>& parts) {
    std::vector<PdfText> wholes;
    for (const PdfText& part : parts) {
        const auto whole = std::ranges::find_if(
            wholes, [&part](const PdfText& one) { return touch(one.box, part.box); });
        if (whole == wholes.end()) {
            wholes.push_back(part);
        } else {
            absorb(*whole, part);
        }
    }
    return wholes;
}

/// Programs cut a picture into strips, and draw its mask over it, so this joins all of them.
std::vector<PdfText> joined(std::vector<PdfText> parts) {
    for (std::size_t before = parts.size() + 1; parts.size() < before;) {
        before = parts.size();
        parts = joined_once(parts);
    }
    return parts;
}

/// The marked figures of a page, with their author's text for people who cannot see them. They
/// have boxes if the page has as many images.
std::vector<PdfText> figures_of(PopplerDocument* document, PopplerPage* page,
                                const std::vector<PopplerRectangle>& images) {
    std::vector<PdfText> figures;
    StructureWalk walk(poppler_page_get_index(page), [&](PopplerStructureElement* element) {
        if (poppler_structure_element_get_kind(element) == POPPLER_STRUCTURE_ELEMENT_FIGURE)
            figures.push_back({taken(poppler_structure_element_get_alt_text(element)), {}});
        return true;
    });
    walk.walk(document);
    // poppler gives no box of a figure, so the images' boxes serve if there are as many.
    for (std::size_t i = 0; images.size() == figures.size() && i < figures.size(); ++i)
        figures[i].box = images[i];
    return figures;
}

/// The first heading of a page; empty if none is marked.
std::string heading_of(PopplerDocument* document, PopplerPage* page) {
    std::string heading;
    StructureWalk walk(poppler_page_get_index(page), [&](PopplerStructureElement* element) {
        if (!is_heading(poppler_structure_element_get_kind(element))) return true;
        heading = taken(
            poppler_structure_element_get_text(element, POPPLER_STRUCTURE_GET_TEXT_RECURSIVE));
        return heading.empty();
    });
    walk.walk(document);
    return heading;
}

/// The pictures among images and figures, from the top of the page down. Parts that touch are
/// one picture. Leaves out what is smaller than 1 cm or fills the page. At most max_figures.
std::vector<PdfText> pictures_in(std::vector<PdfText> parts, const PageSize& page) {
    if (parts.size() > most_parts) parts.resize(most_parts);
    std::erase_if(parts, [](const PdfText& part) { return !is_finite(part.box); });
    for (PdfText& part : parts) part.box = on_page(part.box, page);
    std::erase_if(parts, [&page](const PdfText& part) {
        return fills(part.box, page) || !(part.box.x1 < part.box.x2 && part.box.y1 < part.box.y2);
    });
    std::vector<PdfText> pictures = joined(std::move(parts));
    std::erase_if(pictures, [&page](const PdfText& picture) {
        return decorates(picture.box) || fills(picture.box, page);
    });
    std::ranges::sort(pictures, [](const PdfText& a, const PdfText& b) {
        return std::pair(a.box.y1, a.box.x1) < std::pair(b.box.y1, b.box.x1);
    });
    if (pictures.size() > max_figures) pictures.resize(max_figures);
    return pictures;
}

constexpr double points_per_inch = 72.0;

/// The scale of a page: pixels per unit, and the same in pixels per inch.
struct Scale {
    double px_per_unit = 1.0;
    double dpi = points_per_inch;
};

/// The wanted scale, or as many pixels as the largest picture allows. A hand feels every page
/// at the same size, so a page smaller than A5 counts as A5, and one larger than A2 as A2.
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

void tell_figures(const std::vector<PdfText>& figures, double scale, Page& page) {
    for (const PdfText& figure : figures) {
        if (figure.text.empty()) continue;
        if (!page.told.description.empty()) page.told.description += ' ';
        page.told.description += figure.text;
        if (figure.box.x1 < figure.box.x2) add_label(figure.text, box_of(figure.box, scale), page);
    }
}

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
        const double contrast = contrast_of(text, ink_, page_.picture);
        if (contrast == 0.0 && !looks_written(text, page_.picture)) return;
        if (!is_told(text, contrast)) add_label(text.text, text.box, page_);
        told_.push_back(&text);
        for (const DrawnWord& word : text.words) add_boxes(text, word, contrast > 0.0);
    }

  private:
    /// True if the text is a repetition: a shadow or bold letters drawn twice lie where their
    /// text does; a watermark may be anywhere.
    bool is_told(const DrawnText& text, double contrast) const {
        constexpr double pale = 110.0;  // levels
        const bool is_everywhere = text.is_slanted || (contrast > 0.0 && contrast < pale);
        return std::ranges::any_of(told_, [&](const DrawnText* told) {
            return told->text == text.text && (is_everywhere || meet(told->box, text.box));
        });
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
    const DrawingSurface sheet(std::max(1, static_cast<int>(std::lround(scale * size.width_pt))),
                               std::max(1, static_cast<int>(std::lround(scale * size.height_pt))));
    cairo_set_source_rgb(sheet.context(), 1.0, 1.0, 1.0);  // poppler draws as on paper
    cairo_paint(sheet.context());
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
    const Owned<PopplerDocument, g_object_unref> document(
        poppler_document_new_from_bytes(held.get(), nullptr, &problem));
    if (document == nullptr) return refusal(GlibError(problem));
    const int count = std::min(poppler_document_get_n_pages(document.get()), max_pages);
    if (count < 1) return damaged("PDF", "it has no page");
    if (order.page > count)
        return failure(fmt::format("the document has {} {}; choose one of them", count,
                                   count == 1 ? "page" : "pages"));
    const Owned<PopplerPage, g_object_unref> page(
        poppler_document_get_page(document.get(), order.page - 1));
    if (page == nullptr) return damaged("PDF", "the page is missing");
    auto read = read_page(document.get(), page.get(), bytes, order);
    if (read) read->count = count;
    return read;
}

}  // namespace touchline::decode
