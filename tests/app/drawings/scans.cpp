#include "tests/app/drawings/scans.h"

#include "config/types/angle.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/drawings/felt.h"
#include "tests/vision/pictures/chance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr Effects scanner{0.8, 3.0, 0.15, 80};

Result<cv::Mat> painted_pixels(const Drawing& drawing) {
    auto page = whole_page(drawing.file);
    if (!page) return tl::unexpected(page.error());
    return pixels_of(page->picture).clone();
}

Drawing with_file(const Drawing& drawing, const cv::Mat& bgr, std::string_view what) {
    const std::vector<std::byte> png =
        encoders::png({bgr.cols, bgr.rows, {bgr.data, bgr.data + 3 * bgr.total()}});
    Drawing scan = drawing;
    scan.name += fmt::format(", {}", what);
    scan.has_words_in_pixels = true;
    scan.file.clear();
    for (const std::byte byte : png) scan.file.push_back(static_cast<char>(byte));
    return scan;
}

/// How a sheet lies on its bed.
struct Bed {
    std::string_view name;
    bool is_dark = false;
    double free_left = 0.0;  // share of the picture's side between its frame and the sheet
    double free_top = 0.0;
    double free_right = 0.0;
    double free_bottom = 0.0;
    double most_turn_deg = 0.0;
    double shadow_mm = 0.0;
    double corner_mm = 0.0;  // radius of the sheet's corners
    bool has_holes = false;
};

constexpr std::array<Bed, 10> beds{{
    {"dark border on one side", true, 0.04},
    {"dark border on two sides", true, 0.03, 0.05},
    {"dark border on four sides", true, 0.03, 0.04, 0.05, 0.03},
    {"skewed on a dark bed", true, 0.09, 0.09, 0.09, 0.09, 5.0},
    {"skewed on a light bed", false, 0.09, 0.09, 0.09, 0.09, 5.0, 1.5},
    {"skewed into a corner of a light bed", false, 0.0, 0.0, 0.12, 0.12, 1.5, 1.5},
    {"a shadow beside it", false, 0.05, 0.05, 0.05, 0.05, 1.0, 3.0},
    {"punched, on a dark bed", true, 0.05, 0.05, 0.05, 0.05, 2.0, 0.0, 0.0, true},
    {"punched, without a bed", true, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, true},
    {"rounded, on a dark bed", true, 0.06, 0.06, 0.06, 0.06, 3.0, 0.0, 5.0},
}};

/// Maps millimetres of the sheet to those of the picture.
class Placing {
  public:
    Placing(const Bed& bed, double turn_deg)
        : wide_(1.0 - bed.free_left - bed.free_right),
          high_(1.0 - bed.free_top - bed.free_bottom),
          turn_rad_(radians(turn_deg)),
          middle_(drawing_sheet_mm.width * (bed.free_left + 0.5 * wide_),
                  drawing_sheet_mm.height * (bed.free_top + 0.5 * high_)) {}

    [[nodiscard]] cv::Point2d operator()(const cv::Point2d& mm) const {
        const double x = wide_ * (mm.x - 0.5 * drawing_sheet_mm.width);
        const double y = high_ * (mm.y - 0.5 * drawing_sheet_mm.height);
        const double c = std::cos(turn_rad_);
        const double s = std::sin(turn_rad_);
        return middle_ + cv::Point2d(c * x - s * y, s * x + c * y);
    }

    /// The two scales differ by a few hundredths, so a stroke gets their mean.
    [[nodiscard]] double of_width(double mm) const { return 0.5 * (wide_ + high_) * mm; }

    [[nodiscard]] std::vector<Polyline> of(std::vector<Polyline> lines) const {
        for (Polyline& line : lines)
            for (cv::Point2d& point : line.points) point = (*this)(point);
        return lines;
    }

    [[nodiscard]] cv::Rect2d around(const cv::Rect2d& r) const {
        cv::Point2d low(1e9, 1e9);
        cv::Point2d high = -low;
        for (const cv::Point2d& corner : {cv::Point2d(r.x, r.y), cv::Point2d(r.br().x, r.y), r.br(),
                                          cv::Point2d(r.x, r.br().y)}) {
            const cv::Point2d at = (*this)(corner);
            low = {std::min(low.x, at.x), std::min(low.y, at.y)};
            high = {std::max(high.x, at.x), std::max(high.y, at.y)};
        }
        return {low, high};
    }

    /// The same map between pixels, counted from the first pixel's corner.
    [[nodiscard]] cv::Matx23d in_pixels(double px_mm) const {
        const cv::Point2d o = (*this)({0.0, 0.0});
        const cv::Point2d x = (*this)({1.0, 0.0}) - o;
        const cv::Point2d y = (*this)({0.0, 1.0}) - o;
        return {x.x, y.x, o.x * px_mm, x.y, y.y, o.y * px_mm};
    }

  private:
    double wide_;
    double high_;
    double turn_rad_;
    cv::Point2d middle_;
};

/// The sheet's own shape in pixels of the drawing: rounded, with holes; 255 inside. real: a
/// millimetre of paper at the hand.
cv::Mat form_of(const Bed& bed, double real, cv::Size size) {
    const double px_mm = size.width / drawing_sheet_mm.width;
    const int r = static_cast<int>(bed.corner_mm * px_mm);
    cv::Mat form(size, CV_8U, cv::Scalar(255));
    if (r > 0) {
        form.setTo(0);
        form(cv::Rect(r, 0, size.width - 2 * r, size.height)).setTo(255);
        form(cv::Rect(0, r, size.width, size.height - 2 * r)).setTo(255);
        for (const cv::Point& at :
             {cv::Point(r, r), cv::Point(size.width - 1 - r, r), cv::Point(r, size.height - 1 - r),
              cv::Point(size.width - 1 - r, size.height - 1 - r)})
            cv::circle(form, at, r, cv::Scalar(255), cv::FILLED, cv::LINE_AA);
    }
    if (bed.has_holes)  // 6 mm across, 80 mm apart, 12 mm from the edge of an A4 or A5 sheet
        for (const double side : {-0.5, 0.5})
            cv::circle(form,
                       cv::Point(cvRound(12.0 * real * px_mm),
                                 cvRound(0.5 * size.height + 80.0 * side * real * px_mm)),
                       cvRound(3.0 * real * px_mm), cv::Scalar(0), cv::FILLED, cv::LINE_AA);
    return form;
}

cv::Mat on_bed(const cv::Mat& sheet, const Bed& bed, const Placing& placing, Chance& chance) {
    const double px_mm = sheet.cols / drawing_sheet_mm.width;
    const cv::Matx23d way = placing.in_pixels(px_mm);
    const double real = drawing_sheet_mm.width / (chance.coin() ? 297.0 : 210.0);
    cv::Mat there;
    cv::Mat form;
    cv::warpAffine(sheet, there, way, sheet.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::warpAffine(form_of(bed, real, sheet.size()), form, way, sheet.size(), cv::INTER_LINEAR,
                   cv::BORDER_CONSTANT, cv::Scalar(0));
    const double grey = bed.is_dark ? chance.between(15.0, 90.0) : chance.between(205.0, 232.0);
    cv::Mat3f light(sheet.size(), cv::Vec3f(static_cast<float>(grey + chance.between(-6.0, 6.0)),
                                            static_cast<float>(grey),
                                            static_cast<float>(grey + chance.between(-6.0, 6.0))));
    cv::Mat1f inside;
    form.convertTo(inside, CV_32F, 1.0 / 255.0);
    if (bed.shadow_mm > 0.0) {  // darkest beside the sheet, to its lower right
        cv::Mat1f shadow;
        const double shift = 0.5 * bed.shadow_mm * px_mm;
        cv::warpAffine(inside, shadow, cv::Matx23d(1, 0, shift, 0, 1, shift), inside.size());
        cv::GaussianBlur(shadow, shadow, cv::Size(), 0.5 * shift);
        for (int y = 0; y < light.rows; ++y)
            for (int x = 0; x < light.cols; ++x) light(y, x) *= 1.0F - 0.55F * shadow(y, x);
    }
    cv::Mat3f drawn;
    there.convertTo(drawn, CV_32F);
    for (int y = 0; y < light.rows; ++y)
        for (int x = 0; x < light.cols; ++x)
            light(y, x) = inside(y, x) * drawn(y, x) + (1.0F - inside(y, x)) * light(y, x);
    cv::Mat out;
    light.convertTo(out, CV_8U);
    return out;
}

}  // namespace

Result<Drawing> as_pixels(const Drawing& drawing, const Effects& effects) {
    return painted_pixels(drawing).map(
        [&](const cv::Mat& bgr) { return with_file(drawing, seen(bgr, effects), "as pixels"); });
}

Result<Drawing> scanned(const Drawing& drawing, int seed) {
    Effects effects = scanner;
    effects.seed = seed;
    return painted_pixels(drawing).map(
        [&](const cv::Mat& bgr) { return with_file(drawing, seen(bgr, effects), "scanned"); });
}

int bed_kind_count() {
    return static_cast<int>(beds.size());
}

Result<Drawing> scanned_on_bed(const Drawing& drawing, int kind, int seed) {
    const Bed& bed = beds[static_cast<std::size_t>(kind)];
    Chance chance(900'000 + 1000 * kind + seed);
    const Placing placing(bed, chance.between(-bed.most_turn_deg, bed.most_turn_deg));
    Drawing moved = drawing;
    for (Paint& paint : moved.paints) {
        paint.lines = placing.of(std::move(paint.lines));
        paint.width_mm = placing.of_width(paint.width_mm);
        for (std::vector<Polyline>& clip : paint.clips) clip = placing.of(std::move(clip));
    }
    for (cv::Rect2d& rect : moved.unjudged) rect = placing.around(rect);
    Effects effects = scanner;
    effects.seed = seed;
    return painted_pixels(drawing).map([&](const cv::Mat& bgr) {
        return with_file(moved, seen(on_bed(bgr, bed, placing, chance), effects), bed.name);
    });
}

}  // namespace touchline::testing
