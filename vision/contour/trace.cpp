#include "vision/contour/trace.h"

#include "config/types/map_frame.h"
#include "vision/contour/corners.h"
#include "vision/contour/edge_lines.h"
#include "vision/contour/linking.h"
#include "vision/contour/ranking.h"
#include "vision/contour/sampling.h"
#include "vision/contour/scale.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace touchline {
namespace {

constexpr double kWorkingPixels = 1e6;  // 0.1 mm a pixel on a drawing area of 116 x 84 mm
constexpr double kPhotoPixels = 3e5;    // finer edges of a photo are texture, and cost
constexpr double kPhotoSmoothing_px = 2.0;
constexpr double kShortest_m = 0.004;  // 4 mm of line: the smallest feature worth a finger's time
constexpr double kShortest_px = 8.0;  // shorter lines are pixels, whatever their size on the device
constexpr double kSpacing_m = 0.0002;  // points no denser than the hand's device resolves
constexpr double kSpacing_px = 1.0;
constexpr double kPictureBlur_px = 0.8;  // sigma, of lens and sampling

std::string size_of(const cv::Mat& picture) {
    return std::to_string(picture.cols) + " x " + std::to_string(picture.rows);
}

/// The picture at working size, with what it says about itself.
struct Working {
    LabPicture lab;
    double noise = 0.0;
    double smoothing_px = 0.0;
};

Working measured(const cv::Mat& picture) {
    Working working;
    working.lab = to_lab(picture);
    working.noise = noise_of(working.lab);
    working.smoothing_px = smoothing_for(working.lab, working.noise);
    return working;
}

Working prepared(const cv::Mat& picture) {
    const cv::Mat small = reduced(picture, kWorkingPixels);
    Working working = measured(small);
    if (working.smoothing_px >= kPhotoSmoothing_px &&
        static_cast<double>(small.total()) > kPhotoPixels) {
        return measured(reduced(small, kPhotoPixels));
    }
    return working;
}

/// Where working pixels lie in W.
class Placement {
  public:
    Placement(const cv::Mat& picture, cv::Size working, const Area& area)
        : area_(area),
          mm_per_pixel_(1000.0 *
                        std::min(area.width_m / picture.cols, area.height_m / picture.rows)),
          mm_per_column_(mm_per_pixel_ * picture.cols / working.width),
          mm_per_row_(mm_per_pixel_ * picture.rows / working.height),
          left_mm_(500.0 * area.width_m - 0.5 * mm_per_pixel_ * picture.cols),
          top_mm_(500.0 * area.height_m - 0.5 * mm_per_pixel_ * picture.rows) {}

    double picture_pixels_per_metre() const { return 1000.0 / mm_per_pixel_; }

    double metres_per_working_pixel() const { return 0.5e-3 * (mm_per_column_ + mm_per_row_); }

    Position in_w(cv::Point2d at) const {
        return canonical_point(left_mm_ + (at.x + 0.5) * mm_per_column_,
                               top_mm_ + (at.y + 0.5) * mm_per_row_, area_);
    }

  private:
    Area area_;
    double mm_per_pixel_;
    double mm_per_column_;
    double mm_per_row_;
    double left_mm_;
    double top_mm_;
};

cv::Mat strength_picture(const std::vector<Chain>& chains, cv::Size size, double high) {
    constexpr int kReach = 28;  // points either way: about 20 pixels
    constexpr double kExtent_px = 30.0;
    cv::Mat1b picture(size, uchar{0});
    for (const Chain& chain : chains) {
        const int n = static_cast<int>(chain.points.size());
        const double extent = 1.0 - std::exp(-length_of(chain) / kExtent_px);
        std::vector<double> sum(chain.points.size() + 1, 0.0);
        for (std::size_t i = 0; i < chain.points.size(); ++i) {
            sum[i + 1] = sum[i] + chain.points[i].strength;
        }
        for (int i = 0; i < n; ++i) {
            const int from = std::max(0, i - kReach);
            const int to = std::min(n, i + kReach + 1);
            const double mean =
                (sum[static_cast<std::size_t>(to)] - sum[static_cast<std::size_t>(from)]) /
                (to - from);
            const double r = mean / high * extent;
            const cv::Point2d at = chain.points[static_cast<std::size_t>(i)].at;
            uchar& pixel = picture(cvRound(at.y), cvRound(at.x));
            pixel = std::max(pixel, cv::saturate_cast<uchar>(255.0 * r / (1.0 + r)));
        }
    }
    return picture;
}

Reach reach_for(cv::Size size, double smoothing_px, double shortest_px) {
    constexpr double kGapOverDiagonal = 0.02;
    constexpr double kLeastGap_px = 6.0;
    Reach reach;
    reach.junction_px = 2.5 * smoothing_px + 2.0;
    reach.gap_px = std::max(kLeastGap_px, kGapOverDiagonal * std::hypot(size.width, size.height));
    reach.blur_px = 1.5 * smoothing_px;
    reach.shortest_px = shortest_px;
    return reach;
}

int drop_specks(std::vector<Chain>& chains, double shortest_px) {
    return static_cast<int>(
        std::erase_if(chains, [&](const Chain& c) { return length_of(c) < shortest_px; }));
}

Result<void> check(const cv::Mat& picture, const TraceOptions& options) {
    if (picture.empty()) {
        return failure(
            "no outline found, because the picture has no pixels; choose another picture");
    }
    if (picture.type() != CV_8UC3 && picture.type() != CV_8UC1) {
        return failure("the picture is neither 8-bit colour nor 8-bit grey; convert it first");
    }
    constexpr double kLargest_m = 10.0;
    const auto is_size = [](double metres) { return metres > 1e-3 && metres <= kLargest_m; };
    if (!is_size(options.area.width_m) || !is_size(options.area.height_m)) {
        return failure("the drawing area must be between 1 mm and 10 m on each side");
    }
    if (options.detail < 1 || options.detail > 5) {
        return failure("detail is " + std::to_string(options.detail) + "; it must be 1 to 5");
    }
    return {};
}

std::string nothing_found(const cv::Mat& picture) {
    if (picture.total() <= 64) {
        return "no outline found, because the picture is only " + size_of(picture) +
               " pixels; use a larger one";
    }
    return "no outline found, because nothing in the picture stands out from its background; use "
           "a picture with more contrast";
}

Outline outline_of(const RankedOutline& ranked, const Placement& placement, double spacing_px) {
    const Chain line = resampled(ranked.chain, spacing_px);
    Outline outline;
    outline.is_closed = line.is_closed;
    outline.weight = ranked.salience;
    outline.detail = ranked.detail;
    for (const EdgePoint& point : line.points) {
        const Position p = placement.in_w(point.at);
        if (outline.points.empty() || !(outline.points.back() == p)) {
            outline.points.push_back(p);
        }
    }
    return outline;
}

void fill_map(const std::vector<RankedOutline>& order, const Placement& placement, int detail,
              Trace& trace) {
    const double spacing_px =
        std::max(kSpacing_px, kSpacing_m / placement.metres_per_working_pixel());
    TraceReport& report = trace.report;
    for (const RankedOutline& ranked : order) {
        if (ranked.detail > static_cast<int>(kDetailBudgets.size())) {
            ++report.over_budget;
        } else if (ranked.detail > detail) {
            ++report.over_detail;
        } else {
            trace.map.outlines.push_back(outline_of(ranked, placement, spacing_px));
            Outline& outline = trace.map.outlines.back();
            outline.id = "outline-" + std::to_string(trace.map.outlines.size());
            report.points += static_cast<int>(outline.points.size());
        }
    }
    report.outlines = static_cast<int>(trace.map.outlines.size());
    if (report.over_budget > 0) {
        report.warning =
            "the picture has " + std::to_string(order.size()) +
            " outlines, more than can be felt; only the " +
            std::to_string(order.size() - static_cast<std::size_t>(report.over_budget)) +
            " strongest are used";
    }
}

Result<Trace> traced(const cv::Mat& picture, const TraceOptions& options) {
    const Working working = prepared(picture);
    const GradientField field = colour_gradient(working.lab, working.smoothing_px);
    const Hysteresis limits = thresholds_for(field, working.noise, working.smoothing_px);
    std::vector<Chain> chains = edge_lines(field, limits);

    Trace trace;
    trace.map.area = area_of(view_box_of(options.area));
    const Placement placement(picture, working.lab.size(), trace.map.area);
    TraceReport& report = trace.report;
    report.working_scale = static_cast<double>(working.lab.cols) / picture.cols;
    report.pixels_per_metre = placement.picture_pixels_per_metre();
    report.noise = working.noise;
    report.smoothing_px = working.smoothing_px;
    report.low = limits.low;
    report.high = limits.high;
    report.lines_found = static_cast<int>(chains.size());
    trace.edge_strength = strength_picture(chains, working.lab.size(), limits.high);
    const double metres_per_px = placement.metres_per_working_pixel();
    const double shortest_px = std::max(kShortest_px, kShortest_m / metres_per_px);
    Linked network = linked(std::move(chains), working.lab.size(),
                            reach_for(working.lab.size(), working.smoothing_px, shortest_px));
    chains = std::move(network.chains);
    report.gaps_closed = network.gaps_closed;
    report.junctions = network.junctions;
    report.specks_dropped = drop_specks(chains, shortest_px);
    const double blur_px = std::hypot(working.smoothing_px, kPictureBlur_px);
    for (Chain& chain : chains) {
        chain = with_sharp_corners(chain, blur_px);
    }
    if (chains.empty()) {
        return failure(nothing_found(picture));
    }
    fill_map(ranked(std::move(chains), limits.high, metres_per_px), placement, options.detail,
             trace);
    return trace;
}

}  // namespace

Result<Trace> trace_outlines(const cv::Mat& picture, const TraceOptions& options) {
    try {
        if (const Result<void> usable = check(picture, options); !usable) {
            return tl::unexpected(usable.error());
        }
        return traced(picture, options);
    } catch (const std::exception& e) {  // OpenCV reports lack of memory this way
        return failure(std::string("the picture could not be traced: ") + e.what());
    }
}

}  // namespace touchline
