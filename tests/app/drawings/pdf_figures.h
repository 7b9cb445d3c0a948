// Figures for PDF pages, each around one feature of the format.
// Threads: pure functions of the chance.
#pragma once

#include "tests/app/drawings/pdf_sheet.h"

#include <span>
#include <string_view>

namespace touchline::testing {

struct PdfFigure {
    std::string_view name;
    void (*draw)(PdfSheet&, Chance&, const cv::Point2d& centre);
};

/// Returns figures with a radius of 15 mm around their centre.
[[nodiscard]] std::span<const PdfFigure> pdf_figures();

}  // namespace touchline::testing
