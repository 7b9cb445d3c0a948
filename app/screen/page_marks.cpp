#include "app/screen/page_marks.h"

#include <algorithm>

namespace touchline {

std::string page_words(std::size_t page, std::size_t pages, const Language& language) {
    if (pages < 2) return {};
    return language.text("page", "Page {0} of {1}",
                         {std::to_string(page + 1), std::to_string(pages)});
}

std::string place_words(std::size_t item, std::size_t items, const Language& language) {
    return language.text("screen", "{0} of {1}", {std::to_string(item + 1), std::to_string(items)});
}

bool are_beside(cairo_t* cr, double width_px, LineStyle style, const std::string& place,
                const std::string& page) {
    return line_width_px(cr, style, place) + style.cap_px + line_width_px(cr, style, page) <=
           width_px;
}

int rows_of_marks(cairo_t* cr, std::size_t items, double width_px, LineStyle style,
                  const Language& language) {
    // Long names at the largest size need tens of pages each; a long list mostly has short ones.
    const std::size_t pages = std::max<std::size_t>(99, 3 * items);
    return are_beside(cr, width_px, style, place_words(items, items, language),
                      page_words(pages, pages, language))
               ? 1
               : 2;
}

}  // namespace touchline
