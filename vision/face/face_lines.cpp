#include "vision/face/face_lines.h"

#include "vision/contour/gradient.h"
#include "vision/simplify/shaping.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

// Turns measured on photographs: tests/lab/bench/vision/faces_and_names.md.
constexpr double near_profile = -0.02;
constexpr double turned_away = 0.15;

// The openings of closed eyes and mouths, in their widths.
constexpr double closed_mouth = 0.07;
constexpr double closed_eye = 0.12;

using Points = std::span<const std::size_t>;

constexpr std::array<std::size_t, 36> oval{
    10,  338, 297, 332, 284, 251, 389, 356, 454, 323, 361, 288, 397, 365, 379, 378, 400, 377,
    152, 148, 176, 149, 150, 136, 172, 58,  132, 93,  234, 127, 162, 21,  54,  103, 67,  109};
constexpr std::array<std::size_t, 6> nose_ridge{168, 6, 197, 195, 5, 4};
constexpr std::array<std::size_t, 9> nostril_points{129, 64, 98, 97, 2, 326, 327, 294, 358};

/// These points run from the top of the forehead over nose and lips to the chin.
constexpr std::array<std::size_t, 26> middle_of_face{10, 151, 9,  8,  168, 6,   197, 195, 5,
                                                     4,  1,   19, 94, 2,   164, 0,   11,  12,
                                                     15, 16,  17, 18, 200, 199, 175, 152};

/// A slit between two lines that begin and end in its corners.
struct Slit {
    Points upper;
    Points lower;
};

constexpr std::array<std::size_t, 9> left_upper_lid{33, 246, 161, 160, 159, 158, 157, 173, 133};
constexpr std::array<std::size_t, 9> left_lower_lid{33, 7, 163, 144, 145, 153, 154, 155, 133};
constexpr std::array<std::size_t, 9> right_upper_lid{362, 398, 384, 385, 386, 387, 388, 466, 263};
constexpr std::array<std::size_t, 9> right_lower_lid{362, 382, 381, 380, 374, 373, 390, 249, 263};
constexpr std::array<std::size_t, 11> upper_lip{78, 191, 80, 81, 82, 13, 312, 311, 310, 415, 308};
constexpr std::array<std::size_t, 11> lower_lip{78, 95, 88, 178, 87, 14, 317, 402, 318, 324, 308};
constexpr std::array<std::size_t, 5> left_brow_top{70, 63, 105, 66, 107};
constexpr std::array<std::size_t, 5> left_brow_bottom{46, 53, 52, 65, 55};
constexpr std::array<std::size_t, 5> right_brow_top{336, 296, 334, 293, 300};
constexpr std::array<std::size_t, 5> right_brow_bottom{285, 295, 282, 283, 276};

constexpr Slit left_eye_slit{left_upper_lid, left_lower_lid};
constexpr Slit right_eye_slit{right_upper_lid, right_lower_lid};
constexpr Slit mouth_slit{upper_lip, lower_lip};
constexpr Slit left_brow_slit{left_brow_top, left_brow_bottom};
constexpr Slit right_brow_slit{right_brow_top, right_brow_bottom};

/// Draws a line through points of the mesh. They are the corners of a net, which a hand must not
/// feel: the line runs smoothly between them, and is sharp only in fixed ones.
Chain smooth(Chain line) {
    const double apart_px = length_of(line) / static_cast<double>(line.points.size());
    if (!(apart_px > 0.0)) return line;
    return shaped(line, {apart_px / 8.0, 0.5 * apart_px, 2.0 * apart_px});
}

Chain through(const FaceMesh& mesh, Points points, bool is_closed) {
    Chain line{{}, is_closed};
    for (const std::size_t i : points) line.points.push_back({mesh[i]});
    return smooth(std::move(line));
}

/// Returns the middle of a slit as one line.
Chain middle_line(const FaceMesh& mesh, const Slit& slit) {
    Chain line;
    for (std::size_t i = 0; i < slit.upper.size(); ++i) {
        line.points.push_back({0.5 * (mesh[slit.upper[i]] + mesh[slit.lower[i]])});
    }
    return smooth(std::move(line));
}

/// Returns the ring from its first corner on, with both fixed again: smoothing forgets corners
/// where a wide open slit hardly turns.
Chain with_corners(Chain ring, cv::Point2d first, cv::Point2d second) {
    const auto nearest = [&ring](cv::Point2d corner) {
        return std::ranges::min_element(
            ring.points, {}, [corner](const EdgePoint& p) { return distance(p.at, corner); });
    };
    nearest(second)->is_fixed = true;
    const auto start = nearest(first);
    start->is_fixed = true;
    std::ranges::rotate(ring.points, start);
    return ring;
}

Chain ring_round(const FaceMesh& mesh, const Slit& slit) {
    Chain line{{}, true};
    for (const std::size_t i : slit.upper) line.points.push_back({mesh[i]});
    line.points.front().is_fixed = line.points.back().is_fixed = true;
    for (std::size_t i = slit.lower.size() - 2; i > 0; --i) {
        line.points.push_back({mesh[slit.lower[i]]});
    }
    return with_corners(smooth(std::move(line)), mesh[slit.upper.front()], mesh[slit.upper.back()]);
}

/// Returns height over width.
double opening_of(const FaceMesh& mesh, const Slit& slit) {
    const std::size_t middle = slit.upper.size() / 2;
    const double width_px = distance(mesh[slit.upper.front()], mesh[slit.upper.back()]);
    return distance(mesh[slit.upper[middle]], mesh[slit.lower[middle]]) / std::max(width_px, 1e-9);
}

/// Returns a ring if it is open, else one line.
Chain line_of(const FaceMesh& mesh, const Slit& slit, double closed) {
    return opening_of(mesh, slit) < closed ? middle_line(mesh, slit) : ring_round(mesh, slit);
}

/// Returns the grey level that this share of the levels is darker than; nothing if there are none.
std::optional<double> level_at(std::vector<uchar> levels, double share) {
    if (levels.empty()) return std::nullopt;
    return static_cast<double>(quantile(std::move(levels), share));
}

/// Returns the grey levels within a ring, as far as it lies in the picture.
std::vector<uchar> greys_within(const cv::Mat3b& picture, const std::vector<cv::Point2d>& ring) {
    std::vector<cv::Point> points(ring.begin(), ring.end());
    const cv::Rect box = cv::boundingRect(points) & cv::Rect({}, picture.size());
    if (box.empty()) return {};
    for (cv::Point& p : points) p -= box.tl();
    cv::Mat1b is_within(box.size(), uchar{0});
    cv::fillPoly(is_within, points, cv::Scalar(255));
    cv::Mat1b grey;
    cv::cvtColor(picture(box), grey, cv::COLOR_BGR2GRAY);
    std::vector<uchar> levels;
    for (int y = 0; y < grey.rows; ++y) {
        for (int x = 0; x < grey.cols; ++x) {
            if (is_within(y, x) != 0) levels.push_back(grey(y, x));
        }
    }
    return levels;
}

/// The signs that tell an eye from a lens, in grey levels of the cheek below it.
struct EyeSigns {
    double light_around = 0.0;  // level that a quarter of everything round the eye exceeds
    double contrast = 0.0;      // within the eye, without a tenth at either end
};

std::optional<EyeSigns> eye_signs(const cv::Mat3b& picture, const FaceMesh& mesh,
                                  const Slit& slit) {
    constexpr double beside = 0.15;  // of the eye's width: what counts as round it, at its sides
    constexpr double above_and_below = 0.4;  // likewise, above and below
    constexpr double light_quantile = 0.75;
    constexpr double left_out = 0.1;
    const cv::Point2d from = mesh[slit.upper.front()];
    const cv::Point2d along = mesh[slit.upper.back()] - from;
    const cv::Point2d down(-along.y, along.x);
    const auto at = [&](double x, double y) { return from + x * along + y * down; };
    std::vector<cv::Point2d> eye;
    std::vector<cv::Point2d> below;
    for (const EdgePoint& p : ring_round(mesh, slit).points) {
        eye.push_back(p.at);
        below.push_back(p.at + down);
    }
    const std::vector<uchar> within = greys_within(picture, eye);
    const auto cheek = level_at(greys_within(picture, below), 0.5);
    const std::vector<uchar> around =
        greys_within(picture, {at(-beside, -above_and_below), at(1.0 + beside, -above_and_below),
                               at(1.0 + beside, above_and_below), at(-beside, above_and_below)});
    const auto light = level_at(around, light_quantile);
    const auto bright = level_at(within, 1.0 - left_out);
    const auto dark = level_at(within, left_out);
    if (!cheek || !light || !bright || !dark) return std::nullopt;
    const double unit = std::max(1.0, *cheek);
    return EyeSigns{*light / unit, (*bright - *dark) / unit};
}

/// Which of a pair are on the side that the face shows.
struct Sides {
    bool left = true;
    bool right = true;
};

Sides sides_of(const FaceTurn& turn) {
    const bool is_turned_away = turn.narrower_share < turned_away;
    return {!is_turned_away || !turn.is_left_narrower, !is_turned_away || turn.is_left_narrower};
}

/// Returns the half of a mouth that is seen from the side, as one line.
Chain half_mouth(const FaceMesh& mesh, bool is_left) {
    constexpr std::size_t half_mouth_points = 6;
    return middle_line(mesh, is_left ? Slit{mouth_slit.upper.first(half_mouth_points),
                                            mouth_slit.lower.first(half_mouth_points)}
                                     : Slit{mouth_slit.upper.last(half_mouth_points),
                                            mouth_slit.lower.last(half_mouth_points)});
}

}  // namespace

FaceTurn turn_of(const FaceMesh& mesh) {
    const double tilt_rad = tilt_of(mesh);
    const cv::Point2d across(std::cos(tilt_rad), std::sin(tilt_rad));
    const double left_px = across.dot(mesh[1] - mesh[234]);
    const double right_px = across.dot(mesh[454] - mesh[1]);
    const double width_px = std::max(1e-6, left_px + right_px);
    return {std::clamp(std::min(left_px, right_px) / width_px, -1.0, 0.5), left_px < right_px};
}

bool shows_eyes(const cv::Mat3b& picture, const FaceMesh& mesh) {
    constexpr double shaded = 0.55;
    constexpr double uniform = 0.25;
    const Sides sides = sides_of(turn_of(mesh));
    double light_around = 0.0;
    double contrast = 0.0;
    int eyes = 0;
    for (const auto& [slit, is_there] :
         {std::pair(left_eye_slit, sides.left), std::pair(right_eye_slit, sides.right)}) {
        const auto signs = is_there ? eye_signs(picture, mesh, slit) : std::nullopt;
        if (!signs) continue;
        light_around += signs->light_around;
        contrast += signs->contrast;
        ++eyes;
    }
    return eyes == 0 || light_around >= shaded * eyes || contrast >= uniform * eyes;
}

std::vector<PartLine> face_lines(const FaceMesh& mesh, bool has_eyes) {
    const FaceTurn turn = turn_of(mesh);
    const bool is_profile = turn.narrower_share < near_profile;
    const Sides sides = sides_of(turn);
    std::vector<PartLine> lines;
    const auto add = [&](bool is_shown, FacePart part, const auto& line) {
        if (is_shown) lines.push_back({part, line()});
    };
    add(!is_profile, FacePart::face, [&] { return through(mesh, oval, true); });
    add(has_eyes && sides.left, FacePart::left_eye,
        [&] { return line_of(mesh, left_eye_slit, closed_eye); });
    add(has_eyes && sides.right, FacePart::right_eye,
        [&] { return line_of(mesh, right_eye_slit, closed_eye); });
    add(true, FacePart::mouth, [&] {
        return is_profile ? half_mouth(mesh, sides.left) : line_of(mesh, mouth_slit, closed_mouth);
    });
    add(!is_profile, FacePart::nose, [&] { return through(mesh, nose_ridge, false); });
    add(sides.left, FacePart::left_brow, [&] { return middle_line(mesh, left_brow_slit); });
    add(sides.right, FacePart::right_brow, [&] { return middle_line(mesh, right_brow_slit); });
    const Points nostrils(nostril_points);
    const Points shown = sides.left && sides.right ? nostrils
                         : sides.left              ? nostrils.first(6)
                                                   : nostrils.last(6);
    add(!is_profile, FacePart::nostrils, [&] { return through(mesh, shown, false); });
    return lines;
}

std::vector<std::vector<cv::Point2d>> face_halves(const FaceMesh& mesh) {
    std::vector<cv::Point2d> middle;  // from the forehead to the chin
    for (const std::size_t i : middle_of_face) middle.push_back(mesh[i]);
    std::vector<cv::Point2d> left = middle;
    std::vector<cv::Point2d> right = middle;
    constexpr std::size_t chin = oval.size() / 2;
    for (std::size_t k = 1; k < chin; ++k) {
        left.push_back(mesh[oval[chin + k]]);
        right.push_back(mesh[oval[chin - k]]);
    }
    return {left, right};
}

}  // namespace touchline
