// All pictures of the gallery side by side, as app/documents/gallery/all-pictures.png, and their
// table in app/documents/gallery/README.md:
//   gallery_sheet
#include "app/documents/decode/files.h"
#include "app/documents/decode/picture.h"
#include "config/types/map_frame.h"
#include "tests/app/documents/gallery/pictures.h"

#include <cstdio>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double pixels_per_mm = 2.0;
constexpr int columns = 7;
constexpr int words_px = 16;
constexpr int rim_px = 6;

/// Draws one picture in its frame, with its file's name below.
void draw(const ShippedPicture& picture, cv::Mat1b cell) {
    const cv::Rect frame(0, 0, cell.cols - rim_px, cell.rows - rim_px - words_px);
    cv::rectangle(cell, frame, 200);
    constexpr int shift = 4;
    for (const Outline& outline : picture.map.outlines) {
        std::vector<cv::Point> points;
        for (const Position p : outline.points) {
            const ViewBoxPoint mm = to_view_box(p, view_box_of(picture.map.area));
            points.emplace_back(static_cast<int>(mm.u_mm * pixels_per_mm * (1 << shift)),
                                static_cast<int>(mm.v_mm * pixels_per_mm * (1 << shift)));
        }
        cv::polylines(cell, points, outline.is_closed, 0, 2, cv::LINE_AA, shift);
    }
    cv::putText(cell, picture.name, cv::Point(2, frame.height + 12), cv::FONT_HERSHEY_SIMPLEX, 0.4,
                0, 1, cv::LINE_AA);
}

cv::Mat1b sheet_of(const std::vector<ShippedPicture>& pictures) {
    const cv::Size cell(
        static_cast<int>(1000.0 * Area{}.width_m * pixels_per_mm) + rim_px,
        static_cast<int>(1000.0 * Area{}.height_m * pixels_per_mm) + words_px + rim_px);
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    cv::Mat1b sheet(rows * cell.height, columns * cell.width, static_cast<unsigned char>(255));
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const int column = static_cast<int>(i) % columns;
        const int row = static_cast<int>(i) / columns;
        draw(pictures[i], sheet(cv::Rect({column * cell.width, row * cell.height}, cell)));
    }
    return sheet;
}

Result<void> write_all() {
    const std::string folder = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/";
    const cv::Mat1b sheet = sheet_of(shipped_pictures());
    const auto drawn = write_png(folder + "all-pictures.png",
                                 GreyView{sheet.cols, sheet.rows, {sheet.data, sheet.total()}});
    if (!drawn) return drawn;
    const auto readme = read_text(folder + "README.md");
    if (!readme) return tl::unexpected(readme.error());
    return write_whole_file(folder + "README.md", with_table(*readme, table_of_pictures()));
}

}  // namespace
}  // namespace touchline

int main() {
    const auto written = touchline::write_all();
    if (!written) std::fprintf(stderr, "%s\n", written.error().line.c_str());
    return written ? 0 : 1;
}
