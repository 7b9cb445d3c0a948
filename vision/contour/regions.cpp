#include "vision/contour/regions.h"

#include "vision/contour/corners.h"
#include "vision/contour/ink_parts.h"
#include "vision/contour/junctions.h"
#include "vision/contour/linking.h"
#include "vision/contour/region_map.h"
#include "vision/contour/rings.h"
#include "vision/contour/strokes.h"
#include "vision/prepare/paper.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double speck_part = 0.001;        // of the picture: a smaller region is a speck
constexpr double least_paper = 0.3;         // with less, the paper does not show the light
constexpr std::ptrdiff_t least_points = 4;  // of the rest that a stroke leaves of a border
constexpr double border_blur_px = 1.5;
constexpr double border_span_px = 8.0;
constexpr double calm = 1.0;  // grey levels of noise that need no smoothing

/// Returns a sigma that brings noise down to a grey level or two, but rounds no corner by a pixel.
double smoothing_for_noise(double noise) {
    constexpr double greatest_smoothing_px = 1.5;
    return noise > calm ? std::min(greatest_smoothing_px, 0.5 + 0.1 * noise) : 0.0;
}

Reach reach_of_borders() {
    Reach reach;  // all ends meet already; only the frame is near
    reach.junction_px = 0.5;
    reach.gap_px = 0.5;
    reach.blur_px = 0.8;
    return reach;
}

/// A picture in few colours, and which pixel has which.
struct FlatPicture {
    LabPicture lab;
    std::vector<cv::Vec3f> palette;
    cv::Mat1b map;
    cv::Mat1b soft;  // 255 on borders without a step
    double smoothing_px = 0.0;
};

/// Returns the colours that differ from the ground, but much less than others do.
cv::Mat1b pale_pixels(const cv::Mat1b& map, const std::vector<cv::Vec3f>& palette, uchar ground) {
    const double strongest = strongest_contrast(palette, ground);
    cv::Mat1b pale(map.size());
    std::ranges::transform(map, pale.begin(), [&](uchar colour) {
        const double contrast = cv::norm(palette[colour] - palette[ground]);
        return contrast > 0.0 && contrast <= palest * strongest ? uchar{255} : uchar{0};
    });
    return pale;
}

/// Finds the picture's regions after removing a grid behind them.
void find_regions(FlatPicture& flat, double greatest_width_px) {
    flat.map = region_map(flat.lab, flat.palette);
    const uchar ground = ground_of(flat.map);
    const cv::Mat1b pale = pale_pixels(flat.map, flat.palette, ground);
    cv::Mat1b grid;
    if (cv::countNonZero(pale) > 0) {  // most flat pictures have nothing pale to examine
        grid = grid_of(parts_of(pale, greatest_width_px).strokes, greatest_width_px);
    }
    if (!grid.empty()) {
        cv::Mat soft;  // its edges are paler still
        cv::dilate(grid, soft, cv::Mat::ones(3, 3, CV_8U));
        grid |= soft & (flat.map == ground);
        flat.lab = painted_over(flat.lab, grid);
        flat.map = region_map(flat.lab, flat.palette);
    }
    overgrow_specks(flat.map, static_cast<int>(speck_part * static_cast<double>(flat.lab.total())));
    flat.soft = join_fading(flat.map, flat.palette, flat.lab);
}

FlatPicture flat_picture(const LabPicture& lab, double noise, double greatest_width_px) {
    FlatPicture flat{lab, {}, {}, {}, smoothing_for_noise(noise)};
    if (flat.smoothing_px > 0.0) cv::GaussianBlur(lab, flat.lab, cv::Size(), flat.smoothing_px);
    const Paper paper(flat.lab);
    if (paper.part() >= least_paper) flat.lab = evenly_lit(flat.lab, paper);
    flat.palette = palette_of(flat.lab, noise);
    find_regions(flat, greatest_width_px);
    return flat;
}

/// Returns marks of any colour as ink on what lies beneath them.
Ink ink_of_marks(const cv::Mat1b& mask, const cv::Mat1f& contrast) {
    Ink ink;
    ink.mask = mask;
    ink.contrast = contrast;
    mask.convertTo(ink.darkness, CV_32F, 2.0 / 255.0);
    cv::GaussianBlur(ink.darkness, ink.darkness, cv::Size(), drawing_blur_px);
    return ink;
}

/// Returns strokes with a colour of their own, and whatever else is drawn as thin.
Ink ink_of_strokes(const FlatPicture& flat, const ThinParts& thin, const FineMarks& marks) {
    Ink ink = ink_of_marks(cv::Mat1b(cv::Mat(thin.strokes | marks.lines)), marks.contrast.clone());
    for (int y = 0; y < thin.map.rows; ++y) {
        for (int x = 0; x < thin.map.cols; ++x) {
            const auto own = static_cast<float>(
                cv::norm(flat.palette[flat.map(y, x)] - flat.palette[thin.map(y, x)]));
            ink.contrast(y, x) = std::max(ink.contrast(y, x), own);
        }
    }
    return ink;
}

/// Returns dashes and dots in a row among what is too small for an area; the rest are letters and
/// specks.
std::vector<Chain> broken_lines(const FineMarks& marks, double greatest_width_px) {
    if (cv::countNonZero(marks.bits) == 0) return {};
    std::vector<Chain> lines = with_dashes_joined(
        stroke_lines(ink_of_marks(marks.bits, marks.contrast), greatest_width_px),
        greatest_width_px / widest_stroke_mm);
    std::erase_if(lines, [](const Chain& line) { return line.of == LineOf::edge; });
    return lines;
}

/// Returns the parts of the lines outside a mask; a ring that is wholly outside stays one.
std::vector<Chain> outside(const std::vector<Chain>& lines, const cv::Mat& mask) {
    std::vector<Chain> kept;
    for (const Chain& line : lines) {
        const auto is_inside = [&](const EdgePoint& p) {
            return mask.at<uchar>(pixel_at(p.at, mask.size())) != 0;
        };
        std::vector<EdgePoint> points = line.points;
        const auto first = std::ranges::find_if(points, is_inside);
        if (first == points.end()) {
            kept.push_back(line);
            continue;
        }
        if (line.is_closed) std::ranges::rotate(points, first);
        for (auto from = points.begin(); from != points.end();) {
            from = std::find_if_not(from, points.end(), is_inside);
            const auto to = std::find_if(from, points.end(), is_inside);
            if (to - from > least_points) kept.push_back({{from, to}, false});
            from = to;
        }
    }
    return kept;
}

/// Makes ends of borders that a stroke has cut meet its middle line, and ends of strokes that stop
/// at an area meet its border.
std::vector<Chain> joined(std::vector<Chain> lines, std::size_t strokes, cv::Size size,
                          double greatest_width_px) {
    JunctionSet junctions(border_blur_px, border_span_px);
    const PointGrid grid(lines, size, greatest_width_px);
    std::set<PointKey> met;
    std::set<PointKey> twice;
    for (EndId end = 0; end < 2 * lines.size(); ++end) {
        const PointKey place = key_of(point_at(lines, end).at);
        if (!met.insert(place).second) twice.insert(place);
    }
    for (EndId end = 0; end < 2 * lines.size(); ++end) {
        const cv::Point2d at = point_at(lines, end).at;
        const bool is_on_frame =
            at.x < 0.0 || at.y < 0.0 || at.x > size.width - 1.0 || at.y > size.height - 1.0;
        if (lines[chain_of(end)].is_closed || is_on_frame || twice.contains(key_of(at))) continue;
        const bool is_stroke = chain_of(end) < strokes;
        double nearest_px =
            is_stroke ? lines[chain_of(end)].width_px + 3.0 : 0.5 * greatest_width_px + 3.0;
        std::optional<PointRef> host;
        grid.near(at, nearest_px, [&](const PointRef& ref) {
            const double apart_px = distance(lines[ref.chain].points[ref.index].at, at);
            if ((ref.chain < strokes) != is_stroke && apart_px < nearest_px) {
                nearest_px = apart_px;
                host = ref;
            }
        });
        if (host) junctions.add_meeting(end, *host);
    }
    return junctions.assembled(std::move(lines));
}

}  // namespace

std::vector<Chain> region_lines(const LabPicture& lab, double noise, double greatest_width_px) {
    const FlatPicture flat = flat_picture(lab, noise, greatest_width_px);
    const ThinParts thin = thin_parts_of(flat.map, greatest_width_px);
    const FineMarks marks = fine_marks(flat.lab, {thin.map, flat.palette}, thin.strokes, noise,
                                       flat.smoothing_px, greatest_width_px);
    const Ink ink = ink_of_strokes(flat, thin, marks);
    std::vector<Chain> lines = stroke_lines(ink, greatest_width_px);
    std::ranges::move(broken_lines(marks, greatest_width_px), std::back_inserter(lines));
    const std::size_t strokes = lines.size();
    cv::Mat no_border;
    cv::dilate(ink.mask, no_border, cv::Mat::ones(3, 3, CV_8U));
    no_border |= flat.soft;
    std::vector<Chain> borders =
        linked(outside(region_borders(thin.map, flat.lab, flat.palette), no_border), lab.size(),
               reach_of_borders())
            .chains;
    for (Chain& line : borders) {
        line = with_sharp_corners(line, std::hypot(flat.smoothing_px, drawing_blur_px));
    }
    if (strokes == 0) return borders;
    std::ranges::move(borders, std::back_inserter(lines));
    return joined(std::move(lines), strokes, lab.size(), greatest_width_px);
}

}  // namespace touchline
