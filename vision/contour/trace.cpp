#include "vision/contour/trace.h"

#include "vision/contour/photo_lines.h"
#include "vision/contour/placement.h"
#include "vision/contour/ranking.h"
#include "vision/contour/sampling.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace touchline {
namespace {

constexpr double kSpacing_m = 0.0002;  // points no denser than the hand's device resolves
constexpr double kSpacing_px = 1.0;
constexpr std::size_t kGrainOutlines = 20;

std::string size_of(const cv::Mat& picture) {
    return std::to_string(picture.cols) + " x " + std::to_string(picture.rows);
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

Result<Trace> traced(const cv::Mat& picture, const TraceOptions& options) {
    Trace trace;
    trace.map.area = area_of(view_box_of(options.area));
    TraceReport& report = trace.report;
    report.pixels_per_metre =
        Placement(picture.size(), picture.size(), trace.map.area).picture_pixels_per_metre();
    const double longer_side_mm =
        1000.0 * std::max(picture.cols, picture.rows) / report.pixels_per_metre;
    Result<PhotoLines> found = photo_lines(picture, longer_side_mm, options.edge_model);
    if (!found) {
        return tl::unexpected(found.error());
    }
    if (found->chains.empty()) {
        return failure(nothing_found(picture));
    }
    const Placement placement(picture.size(), found->size, trace.map.area);
    report.working_scale = static_cast<double>(found->size.width) / picture.cols;
    report.noise = found->noise;
    report.smoothing_px = found->smoothing_px;
    report.low = found->low;
    report.high = found->high;
    report.lines_found = found->lines_found;
    report.gaps_closed = found->gaps_closed;
    report.junctions = found->junctions;
    report.specks_dropped = found->specks_dropped;
    trace.edge_strength = found->edge_strength;
    std::vector<RankedOutline> order =
        ranked(std::move(found->chains), found->high, placement.metres_per_working_pixel());
    if (found->is_grain) {
        keep_some_grain(order, report);
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
