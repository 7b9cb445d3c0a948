#include "vision/contour/ink_parts.h"

#include "vision/contour/region_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int least_area_px = 8;  // less ink is a speck, less paper a pinhole
constexpr double clearly_wide = 1.25;
constexpr float alike_depth_share = 0.2F;   // of the depth: along a stroke
constexpr double most_ridges_alike = 0.55;  // of the ridges
constexpr double hair = 0.4;            // of the greatest width: always a stroke, however it swells
constexpr double still_a_stroke = 1.1;  // of the greatest width: strokes of a piece stay strokes
constexpr double where_two_meet = 2.05;
constexpr double stands_out_over_width = 5.0;  // for what stands out of a wide shape
constexpr double swollen = 1.5;  // of the usual width: the deepest place of such a stroke
constexpr double as_wide = 0.6;  // near its end, as a share of the width half-way
constexpr double least_tail_over_width = 1.0;  // less that stands out of a wide shape is its corner

/// Returns the part of a picture that holds all of a mask, with a rim outside it.
cv::Rect part_with(const cv::Mat1b& mask) {
    constexpr int rim_px = 2;
    const cv::Rect box = cv::boundingRect(mask);
    const cv::Rect around(box.tl() - cv::Point(rim_px, rim_px),
                          box.size() + cv::Size(2 * rim_px, 2 * rim_px));
    return box.empty() ? cv::Rect() : around & cv::Rect({}, mask.size());
}

/// Removes the pieces of a mask that are too small, by neighbours of 4 or of 8.
void drop_specks(cv::Mat1b& mask, int neighbours) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n = cv::connectedComponentsWithStats(mask, label, stats, centres, neighbours, CV_32S);
    for (int i = 1; i < n; ++i) {
        if (stats(i, cv::CC_STAT_AREA) >= least_area_px) continue;
        const cv::Rect box(stats(i, cv::CC_STAT_LEFT), stats(i, cv::CC_STAT_TOP),
                           stats(i, cv::CC_STAT_WIDTH), stats(i, cv::CC_STAT_HEIGHT));
        mask(box).setTo(0, label(box) == i);
    }
}

/// Returns half the width of the strokes of each piece: the median of the depths along its ridges;
/// 0 for a piece that is not a stroke.
std::vector<float> usual_depths(const cv::Mat1f& depth, const cv::Mat1i& piece, int pieces) {
    cv::Mat around;
    cv::dilate(depth, around, cv::Mat::ones(3, 3, CV_8U));
    std::vector<std::vector<float>> ridges(static_cast<std::size_t>(pieces));
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            if (piece(y, x) != 0 && depth(y, x) >= around.at<float>(y, x)) {
                ridges[static_cast<std::size_t>(piece(y, x))].push_back(depth(y, x));
            }
        }
    }
    std::vector<float> usual(ridges.size(), 0.0F);
    for (std::size_t i = 0; i < ridges.size(); ++i) {
        if (!ridges[i].empty()) {
            const float depth_px = median_of(ridges[i]);
            const auto alike = std::ranges::count_if(ridges[i], [depth_px](float each) {
                return std::abs(each - depth_px) <= alike_depth_share * depth_px + 0.5F;
            });
            // Towards the corners of a shape its ridges have every depth.
            usual[i] = static_cast<double>(alike) >=
                               most_ridges_alike * static_cast<double>(ridges[i].size())
                           ? depth_px
                           : 0.0F;
        }
    }
    return usual;
}

/// Returns where the ink is deeper than a stroke's, in places clearly so. Where two strokes of a
/// piece meet at a sharp angle, it is up to twice as deep as they are.
cv::Mat wide_cores(const InkParts& parts, const std::vector<float>& usual,
                   double greatest_width_px) {
    const cv::Mat1f& depth = parts.depth;
    const double half_px = 0.5 * greatest_width_px;
    const cv::Mat deep = depth > half_px;
    cv::Mat1i label;
    const int n = cv::connectedComponents(deep, label, 8, CV_32S);
    std::vector<uchar> is_wide(static_cast<std::size_t>(n), 0);
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            const auto usual_px =
                static_cast<double>(usual[static_cast<std::size_t>(parts.piece(y, x))]);
            const double met_px =
                usual_px <= still_a_stroke * half_px ? where_two_meet * usual_px : 0.0;
            if (label(y, x) != 0 &&
                static_cast<double>(depth(y, x)) > std::max(clearly_wide * half_px, met_px)) {
                is_wide[static_cast<std::size_t>(label(y, x))] = 255;
            }
        }
    }
    cv::Mat cores(depth.size(), CV_8U, cv::Scalar(0));
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            cores.at<uchar>(y, x) = is_wide[static_cast<std::size_t>(label(y, x))];
        }
    }
    return cores;
}

/// A part that stands out of a wide shape in one piece: how far it does, and how deep it is
/// half-way and near its end.
struct Tail {
    double reach_px = 0.0;
    double middle_px = 0.0;
    double far_px = 0.0;

    /// A corner, however sharp, grows narrower all the way; a stroke does not.
    [[nodiscard]] bool is_stroke(double least_px) const {
        return reach_px >= least_px && far_px >= as_wide * middle_px;
    }
};

/// Returns the wide parts of the ink, with the corners round them. Tails that are strokes stay
/// strokes.
cv::Mat1b wide_part(const cv::Mat1b& mask, const InkParts& parts, const std::vector<float>& usual,
                    double greatest_width_px) {
    const cv::Mat core = wide_cores(parts, usual, greatest_width_px);
    if (cv::countNonZero(core) == 0) return cv::Mat1b(mask.size(), uchar{0});
    const cv::Mat1f from_core = depth_of(~core);
    const double half_px = 0.5 * greatest_width_px;
    cv::Mat wide = (from_core <= half_px + 1.0) & mask;
    const cv::Mat1b rest = cv::Mat(mask & ~wide);
    const cv::Rect part = part_with(rest);
    if (part.empty()) return wide;
    cv::Mat1i label;
    const int n = cv::connectedComponents(rest(part), label, 8, CV_32S);
    std::vector<Tail> tails(static_cast<std::size_t>(n));
    const auto for_each = [&](auto&& visit) {
        for (int y = 0; y < label.rows; ++y) {
            const int* row = label[y];
            for (int x = 0; x < label.cols; ++x) {
                if (row[x] != 0) {
                    visit(part.tl() + cv::Point(x, y), tails[static_cast<std::size_t>(row[x])]);
                }
            }
        }
    };
    for_each([&](const cv::Point& p, Tail& tail) {
        tail.reach_px = std::max(tail.reach_px, static_cast<double>(from_core(p)));
    });
    for_each([&](const cv::Point& p, Tail& tail) {
        const double along =
            (static_cast<double>(from_core(p)) - half_px) / (tail.reach_px - half_px);
        const auto depth_px = static_cast<double>(parts.depth(p));
        if (along > 0.4 && along < 0.6) {
            tail.middle_px = std::max(tail.middle_px, depth_px);
        } else if (along > 0.75 && along < 0.9) {
            tail.far_px = std::max(tail.far_px, depth_px);
        }
    });
    const double least_px = (0.5 + least_tail_over_width) * greatest_width_px;
    for_each([&](const cv::Point& p, const Tail& tail) {
        if (!tail.is_stroke(least_px)) wide.at<uchar>(p) = 255;
    });
    return wide;
}

/// Strokes that swell and shrink are shapes, however narrow, such as a star of rays; only the
/// finest are not. A part that stands out of a wide shape is judged by itself, and is a stroke if
/// it is long and even.
void add_swelling(InkParts& parts, const cv::Mat1b& mask, const std::vector<float>& usual_of_piece,
                  double greatest_width_px) {
    const cv::Mat1b rest = cv::Mat(mask & ~parts.shapes);
    const cv::Rect part = part_with(rest);
    if (part.empty()) return;
    const cv::Mat1f depth = parts.depth(part);
    const cv::Mat1i piece = parts.piece(part);
    cv::Mat1b shapes = parts.shapes(part);
    cv::Mat1i label;
    const int n = cv::connectedComponents(rest(part), label, 8, CV_32S);
    const std::vector<float> usual = usual_depths(depth, label, n);

    struct Stroke {
        float deepest_px = 0.0F;
        int pixels = 0;
        bool is_of_a_stroke = false;  // its whole piece is a stroke
    };

    std::vector<Stroke> strokes(usual.size());
    const auto of = [&](int y, int x) { return static_cast<std::size_t>(label(y, x)); };
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) {
            Stroke& stroke = strokes[of(y, x)];
            stroke.deepest_px = std::max(stroke.deepest_px, depth(y, x));
            ++stroke.pixels;
            stroke.is_of_a_stroke = usual_of_piece[static_cast<std::size_t>(piece(y, x))] > 0;
        }
    }
    const double hair_px = std::max(1.0, 0.5 * hair * greatest_width_px) + 0.5;
    std::vector<uchar> shape(strokes.size(), 0);
    for (std::size_t i = 1; i < strokes.size(); ++i) {
        const double width_px = 2.0 * static_cast<double>(usual[i]);
        const auto deepest_px = static_cast<double>(strokes[i].deepest_px);
        const bool is_long = strokes[i].pixels >= stands_out_over_width * width_px * width_px;
        const bool is_even = deepest_px <= 0.5 * swollen * width_px + 0.5;
        const bool is_stroke =
            width_px > 0.0 && ((is_long && is_even) || strokes[i].is_of_a_stroke);
        shape[i] = !is_stroke && deepest_px > hair_px ? 255 : 0;
    }
    for (int y = 0; y < depth.rows; ++y) {
        for (int x = 0; x < depth.cols; ++x) shapes(y, x) |= shape[of(y, x)];
    }
}

/// Returns the pieces of a mask that are strokes all over, except for parts that run along the
/// picture's edge, which a frame leaves over.
cv::Mat wholly_thin(const InkParts& parts, double greatest_width_px) {
    struct Piece {
        int pixels = 0;
        int on_edge = 0;
        bool has_shape = false;
    };

    std::vector<Piece> pieces(static_cast<std::size_t>(parts.pieces));
    const auto is_edge = [](int at, int size) { return at == 0 || at == size - 1; };
    for (int y = 0; y < parts.piece.rows; ++y) {
        for (int x = 0; x < parts.piece.cols; ++x) {
            Piece& piece = pieces[static_cast<std::size_t>(parts.piece(y, x))];
            ++piece.pixels;
            piece.on_edge += is_edge(y, parts.piece.rows) || is_edge(x, parts.piece.cols) ? 1 : 0;
            piece.has_shape = piece.has_shape || parts.shapes(y, x) != 0;
        }
    }
    pieces.front().has_shape = true;  // what is not part of the mask
    cv::Mat thin(parts.piece.size(), CV_8U);
    std::ranges::transform(parts.piece, thin.begin<uchar>(), [&](int number) {
        const Piece& piece = pieces[static_cast<std::size_t>(number)];
        const bool is_rim = greatest_width_px * piece.on_edge >= piece.pixels;
        return piece.has_shape || is_rim ? uchar{0} : uchar{255};
    });
    return thin;
}

/// The number of pixels of a colour, and the box around them.
struct ColourExtent {
    int pixels = 0;
    cv::Rect box;
};

std::array<ColourExtent, most_colours> extents_of(const cv::Mat1b& map) {
    std::array<ColourExtent, most_colours> extents{};
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            ColourExtent& extent = extents[map(y, x)];
            if (extent.pixels++ == 0) {
                extent.box = {x, y, 1, 1};
                continue;
            }
            const int left = std::min(extent.box.x, x);
            const int right = std::max(extent.box.br().x, x + 1);
            extent.box = {left, extent.box.y, right - left, y + 1 - extent.box.y};
        }
    }
    return extents;
}

}  // namespace

cv::Mat1f depth_of(const cv::Mat& mask) {
    cv::Mat1f depth;
    cv::distanceTransform(mask, depth, cv::DIST_L2, 5);
    return depth;
}

InkParts parts_of(const cv::Mat1b& ink, double greatest_width_px) {
    const cv::Rect box = part_with(ink);
    InkParts parts{cv::Mat1b(ink.size(), uchar{0}), cv::Mat1b(ink.size(), uchar{0}),
                   cv::Mat1f(ink.size(), 0.0F), cv::Mat1i(ink.size(), 0), 1};
    if (box.empty()) return parts;
    cv::Mat1b mask = ink(box).clone();
    drop_specks(mask, 8);
    cv::Mat1b paper = cv::Mat(~mask);
    drop_specks(paper, 4);  // pinholes lie where two strokes begin to part
    const InkParts inside = parts_of_clean(cv::Mat(~paper), greatest_width_px);
    inside.strokes.copyTo(parts.strokes(box));
    inside.shapes.copyTo(parts.shapes(box));
    inside.depth.copyTo(parts.depth(box));
    inside.piece.copyTo(parts.piece(box));
    parts.pieces = inside.pieces;
    return parts;
}

InkParts parts_of_clean(const cv::Mat1b& mask, double greatest_width_px) {
    InkParts parts;
    parts.depth = depth_of(mask);
    parts.pieces = cv::connectedComponents(mask, parts.piece, 8, CV_32S);
    const std::vector<float> usual = usual_depths(parts.depth, parts.piece, parts.pieces);
    parts.shapes = wide_part(mask, parts, usual, greatest_width_px);
    add_swelling(parts, mask, usual, greatest_width_px);
    parts.strokes = cv::Mat(mask & ~parts.shapes);
    return parts;
}

ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px) {
    const auto extents = extents_of(map);
    const int ground = ground_of(map);
    cv::Mat thin(map.size(), CV_8U, cv::Scalar(0));
    for (int colour = 0; colour < static_cast<int>(most_colours); ++colour) {
        const ColourExtent& extent = extents[static_cast<std::size_t>(colour)];
        if (extent.pixels == 0) continue;
        // Adds a rim of other colours, so that the box's sides are not taken for more of the
        // colour.
        const cv::Rect box =
            (extent.box + cv::Size(4, 4) - cv::Point(2, 2)) & cv::Rect({}, map.size());
        const cv::Mat mask = map(box) == colour;
        const InkParts parts = parts_of_clean(mask, greatest_width_px);
        cv::Mat here = thin(box);
        here |= colour == ground ? wholly_thin(parts, greatest_width_px) : cv::Mat(parts.strokes);
    }
    ThinParts found{parts_of(thin, greatest_width_px).strokes, map.clone()};
    overgrow(found.map, found.strokes);
    return found;
}

}  // namespace touchline
