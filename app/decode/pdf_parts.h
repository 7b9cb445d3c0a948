// Private to app/decode: what a page of a PDF holds beside its pixels. Places are in points of 1/72
// inch from the upper left corner of the page. Threads: one document, one thread.
#pragma once

#include <string>
#include <vector>

#include <poppler.h>

namespace touchline::decode {

/// A text and its box; the box is empty if the document does not say.
struct PdfText {
    std::string text;
    PopplerRectangle box{};  // y1 above y2
};

/// The marked figures of a page, with their author's text for people who cannot see them. They have
/// boxes if the page has as many images.
[[nodiscard]] std::vector<PdfText> figures_of(PopplerDocument* document, PopplerPage* page,
                                              const std::vector<PopplerRectangle>& images);

struct PageSize {
    double width_pt = 0.0;
    double height_pt = 0.0;
};

/// The pictures among images and figures, from the top of the page down. Parts that touch are one
/// picture. Leaves out what is smaller than 1 cm or fills the page. At most max_figures.
[[nodiscard]] std::vector<PdfText> pictures_in(std::vector<PdfText> parts, const PageSize& page);

/// The first heading of a page; empty if none is marked.
[[nodiscard]] std::string heading_of(PopplerDocument* document, PopplerPage* page);

}  // namespace touchline::decode
