// Shows pictures beside what a hand gets of them at each detail, in one sheet:
//   contact_sheet [--area WxH] -o SHEET.png PICTURE...
// Each picture has a row: the picture, then detail 1 ... 5, the drawing area as a frame, words
// below.
#include "app/documents/decode/files.h"
#include "app/documents/decode/picture.h"
#include "vision/simplify/trace.h"

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double pixels_per_mm = 3.0;
constexpr int kText_px = 16;
constexpr int kRim_px = 6;

class Sheet {
  public:
    explicit Sheet(const Area& area)
        : area_(area),
          cell_(static_cast<int>(1000.0 * area.width_m * pixels_per_mm),
                static_cast<int>(1000.0 * area.height_m * pixels_per_mm)) {}

    void add(const std::string& path) {
        Result<Picture> picture = read_picture(path);
        if (!picture) {
            std::fprintf(stderr, "%s\n", picture.error().line.c_str());
            return;
        }
        const cv::Mat pixels(picture->height, picture->width, CV_8UC3, picture->bgr.data());
        cv::Mat3b row(cell_.height + kText_px + kRim_px, 6 * (cell_.width + kRim_px),
                      cv::Vec3b::all(255));
        put_picture(pixels, row);
        const Result<Found> found = find_lines(pixels, {.area = area_});
        for (int detail = 1; detail <= 5; ++detail) {
            const cv::Point at(detail * (cell_.width + kRim_px), 0);
            const Result<Trace> trace = found.and_then([&](const Found& lines) {
                return trace_lines(lines, {.area = area_, .detail = detail});
            });
            put_map(trace, detail, row, at);
        }
        rows_.push_back(row);
    }

    cv::Mat3b drawn() const {
        cv::Mat sheet;
        cv::vconcat(rows_, sheet);
        return sheet;
    }

    bool is_empty() const { return rows_.empty(); }

  private:
    void put_picture(const cv::Mat& pixels, cv::Mat3b& row) const {
        const double scale =
            std::min(1.0 * cell_.width / pixels.cols, 1.0 * cell_.height / pixels.rows);
        cv::Mat small;
        cv::resize(pixels, small, {}, scale, scale, cv::INTER_AREA);
        small.copyTo(row(cv::Rect((cell_.width - small.cols) / 2, (cell_.height - small.rows) / 2,
                                  small.cols, small.rows)));
    }

    void put_map(const Result<Trace>& trace, int detail, cv::Mat3b& row, cv::Point at) const {
        cv::rectangle(row, cv::Rect(at, cell_), {200, 200, 200});
        std::string words = fmt::format("detail {}: ", detail);
        if (!trace) {
            words += trace.error().line;
        } else {
            const SimplifyReport& report = trace->report.simplified;
            words += fmt::format("{}, {} parts, {:.0f} mm, {}, {} left out",
                                 name_of(trace->report.decision.picture_class), report.parts,
                                 report.line_mm, word_of(report.complexity), report.left_out);
            for (std::size_t i = 0; i < trace->map.outlines.size(); ++i) {
                put_outline(trace->map.outlines[i], i, row, at);
            }
        }
        cv::putText(row, words, at + cv::Point(2, cell_.height + 12), cv::FONT_HERSHEY_SIMPLEX,
                    0.38, {0, 0, 0}, 1, cv::LINE_AA);
    }

    void put_outline(const Outline& outline, std::size_t number, cv::Mat3b& row,
                     cv::Point at) const {
        static const std::vector<cv::Scalar> inks{{0, 0, 0},     {200, 60, 0},  {0, 0, 200},
                                                  {0, 130, 0},   {160, 0, 160}, {0, 120, 220},
                                                  {130, 130, 0}, {90, 90, 90}};
        constexpr int kShift = 4;
        std::vector<cv::Point> points;
        for (const Position& p : outline.points) {
            const ViewBoxPoint mm = to_view_box(p, view_box_of(area_));
            points.emplace_back(static_cast<int>((at.x + mm.u_mm * pixels_per_mm) * (1 << kShift)),
                                static_cast<int>((at.y + mm.v_mm * pixels_per_mm) * (1 << kShift)));
        }
        const cv::Scalar& ink = inks[number % inks.size()];
        cv::polylines(row, points, outline.is_closed, ink, 2, cv::LINE_AA, kShift);
        if (!outline.is_closed) {
            for (const cv::Point& end : {points.front(), points.back()}) {
                cv::circle(row, end, 4 << kShift, ink, cv::FILLED, cv::LINE_AA, kShift);
            }
        }
    }

    Area area_;
    cv::Size cell_;
    std::vector<cv::Mat3b> rows_;
};

int run(const std::vector<std::string>& arguments) {
    Area area;
    std::string output;
    std::vector<std::string> pictures;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "-o" && i + 1 < arguments.size()) {
            output = arguments[++i];
        } else if (arguments[i] == "--area" && i + 1 < arguments.size()) {
            double width_mm = 0.0;
            double height_mm = 0.0;
            if (std::sscanf(arguments[++i].c_str(), "%lfx%lf", &width_mm, &height_mm) == 2) {
                area = {width_mm / 1000.0, height_mm / 1000.0};
            }
        } else {
            pictures.push_back(arguments[i]);
        }
    }
    Sheet sheet(area);
    for (const std::string& picture : pictures) {
        sheet.add(picture);
    }
    if (output.empty() || sheet.is_empty()) {
        std::fprintf(stderr, "usage: contact_sheet [--area WxH] -o SHEET.png PICTURE...\n");
        return 2;
    }
    const cv::Mat3b drawn = sheet.drawn();
    Picture picture{drawn.cols, drawn.rows, {drawn.data, drawn.data + 3 * drawn.total()}};
    const Result<void> written = write_png(output, picture);
    if (!written) {
        std::fprintf(stderr, "%s\n", written.error().line.c_str());
    }
    return written ? 0 : 1;
}

}  // namespace
}  // namespace touchline

int main(int count, char** values) {
    return touchline::run({values + 1, values + count});
}
