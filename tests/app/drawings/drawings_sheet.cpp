// Shows drawings beside what a hand gets of them: drawings_sheet -o SHEET.png NUMBER:SEED ... ;
// --files FOLDER writes one file of each kind there. Numbers count the features of SVG, then the
// kinds of charts; pdf:SEED is a page of PDF, and pdfNUMBER:SEED a drawing written as one.
#include "app/documents/decode/files.h"
#include "app/documents/decode/picture.h"
#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/pdf_drawings.h"
#include "tests/app/drawings/svg_drawings.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace touchline {
namespace {

testing::Drawing drawing_of(int number, int seed) {
    const int features = testing::svg_feature_count();
    return number < features ? testing::svg_drawing(number, seed)
                             : testing::chart_drawing(number - features, seed);
}

int write_files(const std::string& folder) {
    const int count = testing::svg_feature_count() + testing::chart_kind_count();
    for (int number = 0; number < count; ++number)
        std::ofstream(fmt::format("{}/{:02}.svg", folder, number)) << drawing_of(number, 0).file;
    for (int page = 0; page < testing::pdf_page_count(); ++page)
        std::ofstream(fmt::format("{}/page-{}.pdf", folder, page)) << testing::pdf_page(page).file;
    return 0;
}

/// Returns the drawing that an argument asks for.
std::optional<testing::Drawing> asked_for(const char* argument) {
    int number = 0;
    int seed = 0;
    if (std::sscanf(argument, "%d:%d", &number, &seed) == 2) return drawing_of(number, seed);
    if (std::sscanf(argument, "pdf:%d", &seed) == 1) return testing::pdf_page(seed);
    if (std::sscanf(argument, "pdf%d:%d", &number, &seed) == 2)
        return testing::as_pdf(drawing_of(number, seed), seed);
    return std::nullopt;
}

cv::Mat row_of(const testing::Drawing& drawing) {
    const auto felt = testing::felt_of(drawing, 5, testing::usual_tolerance_mm);
    if (!felt) {
        fmt::print("{}: {}\n", drawing.name, felt.error().line);
        return testing::sheet_of(drawing, {});
    }
    fmt::print(
        "{}: {:.1f} % of what is seen is felt, {:.1f} % of what is felt is seen, {} outlines\n",
        drawing.name, 100.0 * felt->seen.share(), 100.0 * felt->felt.share(),
        felt->map.outlines.size());
    return testing::sheet_of(drawing, *felt);
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    if (argc == 3 && std::strcmp(argv[1], "--files") == 0) return write_files(argv[2]);
    std::vector<cv::Mat> rows;
    for (int i = 3; i < argc; ++i)
        if (const auto drawing = asked_for(argv[i])) rows.push_back(row_of(*drawing));
    if (rows.empty()) return 2;
    cv::Mat sheet;
    cv::vconcat(rows, sheet);
    const Picture picture{sheet.cols, sheet.rows, {sheet.data, sheet.data + 3 * sheet.total()}};
    if (const auto written = write_png(argv[2], picture); !written) {
        fmt::print("{}\n", written.error().line);
        return 1;
    }
    return 0;
}
