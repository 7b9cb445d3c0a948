// An author's text for people who cannot see the figures of a tagged PDF.
#include "app/decode/pdf_parts.h"

#include <functional>
#include <utility>

namespace touchline::decode {
namespace {

constexpr int deepest = 50;
constexpr int most_elements = 20'000;  // a book of hundreds of pages

std::string taken(gchar* text) {
    const GlibOwned<gchar> owned(text);
    return owned == nullptr ? std::string() : std::string(owned.get());
}

/// Walks over the elements of one page, in reading order, until `visit` returns false.
class StructureWalk {
  public:
    using Visit = std::function<bool(PopplerStructureElement*)>;

    StructureWalk(int page, Visit visit) : page_(page), visit_(std::move(visit)) {}

    void walk(PopplerDocument* document) {
        walk(GlibOwned<PopplerStructureElementIter>(poppler_structure_element_iter_new(document)),
             0);
    }

  private:
    void walk(const GlibOwned<PopplerStructureElementIter>& at, int depth) {
        if (at == nullptr || depth > deepest) return;
        do {
            if (is_done_ || ++seen_ > most_elements) return;
            const GlibOwned<PopplerStructureElement> element(
                poppler_structure_element_iter_get_element(at.get()));
            if (element != nullptr && poppler_structure_element_get_page(element.get()) == page_)
                is_done_ = !visit_(element.get());
            walk(GlibOwned<PopplerStructureElementIter>(
                     poppler_structure_element_iter_get_child(at.get())),
                 depth + 1);
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

}  // namespace touchline::decode
