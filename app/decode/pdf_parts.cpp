// An author's text for people who cannot see the figures of a tagged PDF.
#include "app/decode/pdf_parts.h"

#include "app/decode/drawing_surface.h"
#include "app/decode/page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace touchline::decode {
namespace {

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
            const GlibObject<PopplerStructureElement> element(
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

/// Joins each part to the first that it touches.
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

}  // namespace

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

}  // namespace touchline::decode
