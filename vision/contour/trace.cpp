#include "vision/contour/trace.h"

#include "vision/contour/corners.h"
#include "vision/contour/double_edges.h"
#include "vision/contour/edge_lines.h"
#include "vision/contour/edge_strength.h"
#include "vision/contour/linking.h"
#include "vision/contour/placement.h"
#include "vision/contour/ranking.h"
#include "vision/contour/sampling.h"
#include "vision/contour/scale.h"
#include "vision/contour/texture.h"

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
constexpr double kGap_m = 0.0032;     // lines that lie closer are felt as one
constexpr double kLongestTexture_m = 0.02;
constexpr double kSmallestTexture_m = 0.02;
constexpr double kSpacing_m = 0.0002;  // points no denser than the hand's device resolves
constexpr double kSpacing_px = 1.0;
constexpr double kGrain =
    1.0;  // grey levels; more noise than that in an otherwise empty picture is its content
constexpr std::size_t kGrainOutlines = 20;
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
    if (report.over_budget > 0 && report.warning.empty()) {
        report.warning =
            "the picture has " + std::to_string(order.size()) +
            " outlines, more than can be felt; only the " +
            std::to_string(order.size() - static_cast<std::size_t>(report.over_budget)) +
            " strongest are used";
    }
}

/// Grain says nothing by being felt whole: a few lines of it show what there is.
void keep_some_grain(std::vector<RankedOutline>& order, TraceReport& report) {
    const std::size_t kept = std::min(order.size(), kGrainOutlines);
    report.over_budget = static_cast<int>(order.size() - kept);
    report.warning = "nothing in the picture stands out from its grain; of " +
                     std::to_string(report.lines_found) + " lines in the grain only the " +
                     std::to_string(kept) + " strongest are used";
    order.resize(kept);
}

/// The outlines that these thresholds give.
std::vector<Chain> outlines_of(const GradientField& field, const Hysteresis& limits,
                               double smoothing_px, double metres_per_px, Trace& trace) {
    TraceReport& report = trace.report;
    const cv::Size size = field.strength.size();
    std::vector<Chain> lines = edge_lines(field, limits);
    report.low = limits.low;
    report.high = limits.high;
    report.lines_found = static_cast<int>(lines.size());
    trace.edge_strength = edge_strength(lines, size, limits.high);
    const double shortest_px = std::max(kShortest_px, kShortest_m / metres_per_px);
    Linked network = linked(std::move(lines), size, reach_for(size, smoothing_px, shortest_px));
    report.gaps_closed = network.gaps_closed;
    report.junctions = network.junctions;
    if (smoothing_px >= kPhotoSmoothing_px) {
        const double gap_px = kGap_m / metres_per_px;
        network.chains = with_double_edges_merged(std::move(network.chains), size, gap_px);
        network.chains = with_textures_outlined(
            std::move(network.chains), size,
            {gap_px, kLongestTexture_m / metres_per_px, kSmallestTexture_m / metres_per_px});
    }
    report.specks_dropped = drop_specks(network.chains, shortest_px);
    const double blur_px = std::hypot(smoothing_px, kPictureBlur_px);
    for (Chain& chain : network.chains) {
        chain = with_sharp_corners(chain, blur_px);
    }
    return std::move(network.chains);
}

Result<Trace> traced(const cv::Mat& picture, const TraceOptions& options) {
    const Working working = prepared(picture);
    const double smoothing_px = working.smoothing_px;
    const GradientField field = colour_gradient(working.lab, smoothing_px);
    Trace trace;
    trace.map.area = area_of(view_box_of(options.area));
    const Placement placement(picture.size(), working.lab.size(), trace.map.area);
    const double metres_per_px = placement.metres_per_working_pixel();
    trace.report.working_scale = static_cast<double>(working.lab.cols) / picture.cols;
    trace.report.pixels_per_metre = placement.picture_pixels_per_metre();
    trace.report.noise = working.noise;
    trace.report.smoothing_px = smoothing_px;

    bool is_grain = false;
    std::vector<Chain> outlines =
        outlines_of(field, thresholds_for(field, working.noise, smoothing_px), smoothing_px,
                    metres_per_px, trace);
    if (outlines.empty() && working.noise >= kGrain) {
        outlines = outlines_of(field, grain_thresholds(field), smoothing_px, metres_per_px, trace);
        is_grain = true;
    }
    if (outlines.empty()) {
        return failure(nothing_found(picture));
    }
    std::vector<RankedOutline> order =
        ranked(std::move(outlines), trace.report.high, metres_per_px);
    if (is_grain) {
        keep_some_grain(order, trace.report);
    }
    fill_map(order, placement, options.detail, trace);
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
        const std::string why = e.what();
        return failure("the picture could not be traced, because of " +
                       why.substr(0, why.find('\n')) + "; try a smaller one");
    }
}

}  // namespace touchline
