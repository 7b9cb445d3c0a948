#include "vision/contour/regions.h"

#include "vision/contour/corners.h"
#include "vision/contour/fading.h"
#include "vision/contour/grid_lines.h"
#include "vision/contour/ink_parts.h"
#include "vision/contour/junctions.h"
#include "vision/contour/linking.h"
#include "vision/contour/palette.h"
#include "vision/contour/region_borders.h"
#include "vision/contour/region_map.h"
#include "vision/contour/specks.h"
#include "vision/contour/strokes.h"
#include "vision/contour/thin_parts.h"
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

constexpr double kLeastPart = 0.001;  // of the picture: a smaller region is a speck
constexpr double kLeastPaper = 0.3;   // less, and the paper says nothing about the light
constexpr double kPictureBlur_px = 0.7;
constexpr std::ptrdiff_t kLeastPoints = 4;  // of what a stroke leaves of a border
constexpr double kBorderBlur_px = 1.5;
constexpr double kBorderSpan_px = 8.0;
constexpr double kCalm = 1.0;  // grey levels of noise that need no smoothing

/// Sigma that brings noise down to a grey level or two, but rounds no corner by a pixel.
double smoothing_for_noise(double noise) {
    constexpr double kGreatest_px = 1.5;
    return noise > kCalm ? std::min(kGreatest_px, 0.5 + 0.1 * noise) : 0.0;
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
    cv::Mat1b slight;  // 255 where regions are that may be dashes, and else are too small
    double smoothing_px = 0.0;
};

/// Each pixel of the mask in the colour of the nearest one outside.
LabPicture painted_over(const LabPicture& lab, const cv::Mat1b& mask) {
    cv::Mat1f apart;
    cv::Mat1i nearest;  // the same number for all that are nearest to one pixel outside
    cv::distanceTransform(mask, apart, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<cv::Vec3f> colours(lab.total() + 1);
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) == 0) {
                colours[static_cast<std::size_t>(nearest(y, x))] = lab(y, x);
            }
        }
    }
    LabPicture painted = lab.clone();
    for (int y = 0; y < mask.rows; ++y) {
        for (int x = 0; x < mask.cols; ++x) {
            if (mask(y, x) != 0) {
                painted(y, x) = colours[static_cast<std::size_t>(nearest(y, x))];
            }
        }
    }
    return painted;
}

/// The colours that differ from the ground, the commonest, but much less than others.
cv::Mat1b pale_pixels(const cv::Mat1b& map, const std::vector<cv::Vec3f>& palette) {
    std::vector<int> counts(palette.size(), 0);
    for (const uchar colour : map) {
        ++counts[colour];
    }
    const cv::Vec3f& ground =
        palette[static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin())];
    double strongest = 0.0;
    for (const cv::Vec3f& colour : palette) {
        strongest = std::max(strongest, cv::norm(colour - ground));
    }
    cv::Mat1b pale(map.size());
    std::ranges::transform(map, pale.begin(), [&](uchar colour) {
        const double contrast = cv::norm(palette[colour] - ground);
        return contrast > 0.0 && contrast <= kPalest * strongest ? uchar{255} : uchar{0};
    });
    return pale;
}

/// The picture's regions, once a grid behind them is gone.
void find_regions(FlatPicture& flat, double greatest_width_px) {
    flat.map = region_map(flat.lab, flat.palette);
    const cv::Mat1b pale = pale_pixels(flat.map, flat.palette);
    cv::Mat1b grid;
    if (cv::countNonZero(pale) > 0) {  // most flat pictures have nothing pale to look through
        grid = grid_of(parts_of(pale, greatest_width_px).strokes, greatest_width_px);
    }
    if (!grid.empty()) {
        flat.lab = painted_over(flat.lab, grid);
        flat.map = region_map(flat.lab, flat.palette);
    }
    flat.slight =
        without_specks(flat.map, flat.palette,
                       static_cast<int>(kLeastPart * static_cast<double>(flat.lab.total())));
    join_fading(flat.map, flat.palette, flat.lab);
}

FlatPicture flat_picture(const LabPicture& lab, double noise, double greatest_width_px) {
    FlatPicture flat{lab, {}, {}, {}, smoothing_for_noise(noise)};
    if (flat.smoothing_px > 0.0) {
        cv::GaussianBlur(lab, flat.lab, cv::Size(), flat.smoothing_px);
    }
    const Paper paper(flat.lab);
    if (paper.part() >= kLeastPaper) {
        flat.lab = evenly_lit(flat.lab, paper);
    }
    flat.palette = palette_of(flat.lab, noise);
    find_regions(flat, greatest_width_px);
    return flat;
}

/// Strokes of any colour as ink on what lies beneath them.
Ink ink_of_strokes(const FlatPicture& flat, const ThinParts& thin) {
    Ink ink;
    ink.mask = thin.strokes;
    thin.strokes.convertTo(ink.darkness, CV_32F, 2.0 / 255.0);
    cv::GaussianBlur(ink.darkness, ink.darkness, cv::Size(), kPictureBlur_px);
    ink.contrast = cv::Mat1f(thin.map.size());
    for (int y = 0; y < thin.map.rows; ++y) {
        for (int x = 0; x < thin.map.cols; ++x) {
            ink.contrast(y, x) = static_cast<float>(
                cv::norm(flat.palette[flat.map(y, x)] - flat.palette[thin.map(y, x)]));
        }
    }
    return ink;
}

/// What of the lines lies outside a mask, in pieces; a ring that does as a whole stays one.
std::vector<Chain> outside(const std::vector<Chain>& lines, const cv::Mat& mask) {
    std::vector<Chain> kept;
    for (const Chain& line : lines) {
        const auto is_inside = [&](const EdgePoint& p) {
            const cv::Point at(std::clamp(cvRound(p.at.x), 0, mask.cols - 1),
                               std::clamp(cvRound(p.at.y), 0, mask.rows - 1));
            return mask.at<uchar>(at) != 0;
        };
        std::vector<EdgePoint> points = line.points;
        const auto first = std::ranges::find_if(points, is_inside);
        if (first == points.end()) {
            kept.push_back(line);
            continue;
        }
        if (line.is_closed) {
            std::ranges::rotate(points, first);
        }
        for (auto from = points.begin(); from != points.end();) {
            from = std::find_if_not(from, points.end(), is_inside);
            const auto to = std::find_if(from, points.end(), is_inside);
            if (to - from > kLeastPoints) {
                kept.push_back({{from, to}, false});
            }
            from = to;
        }
    }
    return kept;
}

/// Ends of borders that a stroke has cut meet its middle line, ends of strokes that stop at an area
/// meet its border.
std::vector<Chain> joined(std::vector<Chain> lines, std::size_t strokes, cv::Size size,
                          double greatest_width_px) {
    JunctionSet junctions(kBorderBlur_px, kBorderSpan_px);
    const PointGrid grid(lines, size, greatest_width_px);
    std::set<std::pair<double, double>> met;
    std::set<std::pair<double, double>> twice;
    const auto end_point = [&](EndId end) {
        const std::vector<EdgePoint>& points = lines[chain_of(end)].points;
        return is_back(end) ? points.back().at : points.front().at;
    };
    for (EndId end = 0; end < 2 * lines.size(); ++end) {
        const cv::Point2d at = end_point(end);
        if (!met.insert({at.x, at.y}).second) {
            twice.insert({at.x, at.y});
        }
    }
    for (EndId end = 0; end < 2 * lines.size(); ++end) {
        const cv::Point2d at = end_point(end);
        const bool is_on_frame =
            at.x < 0.0 || at.y < 0.0 || at.x > size.width - 1.0 || at.y > size.height - 1.0;
        if (lines[chain_of(end)].is_closed || is_on_frame || twice.contains({at.x, at.y})) {
            continue;
        }
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
        if (host) {
            junctions.add_meeting(end, *host);
        }
    }
    return junctions.assembled(std::move(lines));
}

/// Lines on what is slight are so themselves.
void mark_slight(std::vector<Chain>& lines, const cv::Mat1b& slight) {
    if (cv::countNonZero(slight) == 0) {
        return;
    }
    cv::Mat1b near_slight;  // a border runs between two pixels
    cv::dilate(slight, near_slight, cv::Mat::ones(3, 3, CV_8U));
    for (Chain& line : lines) {
        const cv::Point2d& middle = line.points[line.points.size() / 2].at;
        const cv::Point at(std::clamp(cvRound(middle.x), 0, slight.cols - 1),
                           std::clamp(cvRound(middle.y), 0, slight.rows - 1));
        if (near_slight(at) != 0) {
            line.of = LineOf::slight;
        }
    }
}

}  // namespace

std::vector<Chain> region_lines(const LabPicture& lab, double noise, double greatest_width_px) {
    const FlatPicture flat = flat_picture(lab, noise, greatest_width_px);
    const ThinParts thin = thin_parts_of(flat.map, greatest_width_px);
    std::vector<Chain> lines = stroke_lines(ink_of_strokes(flat, thin), greatest_width_px);
    const std::size_t strokes = lines.size();
    cv::Mat near_strokes;
    cv::dilate(thin.strokes, near_strokes, cv::Mat::ones(3, 3, CV_8U));
    std::vector<Chain> borders =
        linked(outside(region_borders(thin.map, flat.lab, flat.palette), near_strokes), lab.size(),
               reach_of_borders())
            .chains;
    for (Chain& line : borders) {
        line = with_sharp_corners(line, std::hypot(flat.smoothing_px, kPictureBlur_px));
    }
    std::ranges::move(borders, std::back_inserter(lines));
    if (strokes > 0) {
        lines = joined(std::move(lines), strokes, lab.size(), greatest_width_px);
    }
    mark_slight(lines, flat.slight);
    return lines;
}

}  // namespace touchline
