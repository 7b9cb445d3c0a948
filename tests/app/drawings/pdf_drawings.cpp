#include "tests/app/drawings/pdf_drawings.h"

#include "tests/app/drawings/pdf_figures.h"

#include <fmt/format.h>

namespace touchline::testing {
namespace {

constexpr int columns = 3;
constexpr int figure_rows = 2;

}  // namespace

int pdf_page_count() {
    const int cells = columns * figure_rows;
    return (static_cast<int>(pdf_figures().size()) + cells - 1) / cells;
}

Drawing pdf_page(int number) {
    Chance chance(900'000 + number);
    PdfSheet sheet(chance);
    std::string names;
    for (int cell = 0; cell < columns * figure_rows; ++cell) {
        const auto kind = static_cast<std::size_t>(columns * figure_rows * number + cell);
        const PdfFigure& figure = pdf_figures()[kind % pdf_figures().size()];
        figure.draw(sheet, chance,
                    {sheet_mm.width * (cell % columns + 0.5) / columns,
                     sheet_mm.height * (cell / columns + 0.5) / figure_rows});
        names += fmt::format("{}{}", names.empty() ? "" : ", ", figure.name);
    }
    Drawing out = sheet.drawing();
    out.kind = "page";
    out.name = fmt::format("page {}: {}", number, names);
    return out;
}

Drawing as_pdf(const Drawing& drawing, int seed) {
    Chance chance(seed);
    PdfSheet sheet(chance);
    for (const Paint& paint : drawing.paints) sheet.paint(paint);
    if (chance.coin()) sheet.say("Figure 3", {3.0, 82.0}, 3.0);
    Drawing out = sheet.drawing();
    out.kind = drawing.kind;
    out.name = drawing.name + ", as PDF";
    out.unjudged = drawing.unjudged;
    return out;
}

}  // namespace touchline::testing
