#include "vision/contour/frame.h"

#include "vision/contour/iso_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr double kFrameOverLine = 0.7;   // a half disc is 0.64, a horizon 1
constexpr double kLeastRoundness = 0.6;  // round a corner every way is long

/// The frame as a closed way, clockwise from its upper left corner.
class Frame {
  public:
    explicit Frame(cv::Size picture) : width_(picture.width), height_(picture.height) {}

    double length_px() const { return 2.0 * (width_ + height_); }

    /// Returns how far along the way a point on it lies.
    std::optional<double> place_of(const cv::Point2d& p) const {
        const double to_right = p.x + 0.5;
        const double to_bottom = p.y + 0.5;
        if (p.y == -0.5) {
            return to_right;
        }
        if (p.x == width_ - 0.5) {
            return width_ + to_bottom;
        }
        if (p.y == height_ - 0.5) {
            return 2.0 * width_ + height_ - to_right;
        }
        return p.x == -0.5 ? std::optional(length_px() - to_bottom) : std::nullopt;
    }

    /// Returns the way ahead from one place to another.
    double ahead(double from, double to) const {
        return std::fmod(to - from + length_px(), length_px());
    }

    /// Returns the corners between a place and another `way_px` further on, in this order.
    std::vector<cv::Point2d> corners_after(double from, double way_px) const {
        struct Corner {
            double ahead_px;
            cv::Point2d at;
        };

        const double right = width_ - 0.5;
        const double bottom = height_ - 0.5;
        std::array<Corner, 4> corners{{{ahead(from, 0.0), {-0.5, -0.5}},
                                       {ahead(from, width_), {right, -0.5}},
                                       {ahead(from, width_ + height_), {right, bottom}},
                                       {ahead(from, 2.0 * width_ + height_), {-0.5, bottom}}}};
        std::ranges::sort(corners, {}, &Corner::ahead_px);
        std::vector<cv::Point2d> passed;
        for (const Corner& corner : corners) {
            if (corner.ahead_px > 0.0 && corner.ahead_px < way_px) {
                passed.push_back(corner.at);
            }
        }
        return passed;
    }

  private:
    double width_;
    double height_;
};

/// Returns 1 for a disc, 0.77 for a quarter of one, 0.54 for half a square, less for a sliver.
double roundness(const Chain& ring) {
    const double length = length_of(ring);
    return 4.0 * std::numbers::pi * std::abs(area_within(ring)) / (length * length);
}

/// Returns the chain with the frame between its ends, the shorter way.
std::optional<Chain> closed_along(const Frame& frame, const Chain& chain) {
    const std::optional<double> front = frame.place_of(chain.points.front().at);
    const std::optional<double> back = frame.place_of(chain.points.back().at);
    if (!front || !back) {
        return std::nullopt;
    }
    const double clockwise = frame.ahead(*back, *front);
    const bool is_clockwise = clockwise <= frame.length_px() / 2.0;
    const double way_px = is_clockwise ? clockwise : frame.length_px() - clockwise;
    std::vector<cv::Point2d> corners = frame.corners_after(is_clockwise ? *back : *front, way_px);
    if (!is_clockwise) {
        std::ranges::reverse(corners);
    }
    Chain closed = chain;
    closed.is_closed = true;
    for (const cv::Point2d& at : corners) {
        closed.points.push_back({at, chain.points.back().strength, true});
    }
    const bool is_mostly_line = way_px < kFrameOverLine * length_of(chain);
    const bool is_round = corners.size() == 1 && roundness(closed) > kLeastRoundness;
    return is_mostly_line || is_round ? std::optional(closed) : std::nullopt;
}

}  // namespace

std::optional<cv::Point2d> exit_near(const cv::Point2d& from, const cv::Point2d& way,
                                     cv::Size picture, double far_px) {
    const double right = picture.width - 0.5;
    const double bottom = picture.height - 0.5;
    const double side_x = way.x < 0.0 ? -0.5 : right;
    const double side_y = way.y < 0.0 ? -0.5 : bottom;
    const double to_x = way.x != 0.0 ? (side_x - from.x) / way.x : far_px;
    const double to_y = way.y != 0.0 ? (side_y - from.y) / way.y : far_px;
    if (std::min(to_x, to_y) >= far_px) {
        return std::nullopt;
    }
    if (to_x < to_y) {
        return cv::Point2d(side_x, std::clamp(from.y + to_x * way.y, -0.5, bottom));
    }
    return cv::Point2d(std::clamp(from.x + to_y * way.x, -0.5, right), side_y);
}

void close_along_frame(std::vector<Chain>& chains, cv::Size picture) {
    const Frame frame(picture);
    for (Chain& chain : chains) {
        if (!chain.is_closed && chain.points.size() > 2) {
            if (std::optional<Chain> closed = closed_along(frame, chain)) {
                chain = std::move(*closed);
            }
        }
    }
}

}  // namespace touchline
