#include "vision/prepare/side_evidence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int samples = 48;              // a side
constexpr double corner_share = 0.04;    // at either end: corners are rounded, bent, held
constexpr double apart_px = 2.5;         // of the two looks, to either side of the line
constexpr double least_levels = 6.0;     // brighter inside, at least, and ...
constexpr double least_contrast = 0.07;  // ... by this share of the brightness inside
constexpr int rough_slack_px = 2;
constexpr double beyond_px = 3.0;   // of the slack, that the search for the steepest edge reaches
constexpr double distant_px = 7.0;  // where contrast is taken: beyond the grain of a texture
constexpr double stray_px = 1.5;
constexpr int least_seen = samples / 5;  // of a side, or nothing is known of it
constexpr double least_edges = 1.0 / 3;  // of what is seen

/// Interpolates bilinearly; the point must be in the picture.
double at(const cv::Mat1b& light, cv::Point2d p) {
    const int x = std::min(static_cast<int>(p.x), light.cols - 2);
    const int y = std::min(static_cast<int>(p.y), light.rows - 2);
    const double fx = p.x - x;
    const double fy = p.y - y;
    return (1 - fy) * ((1 - fx) * light(y, x) + fx * light(y, x + 1)) +
           fy * ((1 - fx) * light(y + 1, x) + fx * light(y + 1, x + 1));
}

bool is_within(const cv::Mat1b& light, cv::Point2d p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x <= light.cols - 1.0 && p.y <= light.rows - 1.0;
}

struct Side {
    cv::Point2d from;
    cv::Point2d along;   // to the other corner
    cv::Point2d inward;  // unit

    [[nodiscard]] cv::Point2d sample(int i) const {
        const double t = corner_share + (1.0 - 2.0 * corner_share) * (i + 0.5) / samples;
        return from + along * t;
    }
};

Side side_of(const Quad& quad, std::size_t i) {
    const cv::Point2d along = quad[(i + 1) % 4] - quad[i];
    const double length_px = std::max(cv::norm(along), 1e-9);
    return {quad[i], along, cv::Point2d(-along.y, along.x) / length_px};
}

/// Returns how much brighter it is inside of p than outside; negative if it is darker.
double rise(const cv::Mat1b& light, const Side& side, cv::Point2d p) {
    const double inside = at(light, p + side.inward * apart_px);
    const double outside = at(light, p - side.inward * apart_px);
    return inside - outside >= std::max(least_levels, least_contrast * inside) ? inside - outside
                                                                               : -1.0;
}

bool can_look(const cv::Mat1b& light, const Side& side, cv::Point2d p, double reach_px) {
    return is_within(light, p + side.inward * (apart_px + reach_px)) &&
           is_within(light, p - side.inward * (apart_px + reach_px));
}

/// Returns where on the normal through p the light rises most steeply, in pixels from p; nothing if
/// it does not rise, or if the steepest place may lie beyond the reach.
std::optional<double> edge_near(const cv::Mat1b& light, const Side& side, cv::Point2d p,
                                double reach_px) {
    const int steps = static_cast<int>(reach_px);
    const auto slope = [&](double t) {
        return at(light, p + side.inward * (t + 1.0)) - at(light, p + side.inward * (t - 1.0));
    };
    int best = 0;
    double steepest = 0.0;
    for (int t = -steps; t <= steps; ++t) {
        const double here = slope(t);
        if (here <= steepest) continue;
        steepest = here;
        best = t;
    }
    if (std::abs(best) == steps || rise(light, side, p + side.inward * best) <= 0.0)
        return std::nullopt;
    const double before = slope(best - 1.0);
    const double after = slope(best + 1.0);
    const double bend = before - 2.0 * steepest + after;
    return best + (bend < 0.0 ? std::clamp((before - after) / (2.0 * bend), -0.5, 0.5) : 0.0);
}

Line fitted(const std::vector<cv::Point2f>& points, cv::DistanceTypes distance) {
    cv::Vec4f line;
    cv::fitLine(points, line, distance, 0, 0.01, 0.01);
    return {{line[2], line[3]}, {line[0], line[1]}};
}

/// Strays are removed twice, because they still affect the first fit.
std::optional<Line> line_of(std::vector<cv::Point2f> points, int seen) {
    const auto is_enough = [&](const std::vector<cv::Point2f>& some) {
        return static_cast<double>(some.size()) >= least_edges * seen;
    };
    if (!is_enough(points)) return std::nullopt;
    Line line = fitted(points, cv::DIST_WELSCH);
    for (const double limit_px : {2.0 * stray_px, stray_px}) {
        std::vector<cv::Point2f> near;
        std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](cv::Point2f p) {
            return std::abs(line.direction.cross(cv::Point2d(p) - line.point)) < limit_px;
        });
        if (!is_enough(near)) return std::nullopt;
        line = fitted(near, cv::DIST_L2);
    }
    return line;
}

template <class Supports>
QuadEvidence gathered(const cv::Mat1b& light, const Quad& quad, double reach_px,
                      Supports supports) {
    QuadEvidence evidence;
    for (std::size_t i = 0; i < 4; ++i) {
        const Side side = side_of(quad, i);
        int visible = 0;
        int supported = 0;
        for (int k = 0; k < samples; ++k) {
            const cv::Point2d p = side.sample(k);
            if (!can_look(light, side, p, reach_px)) continue;
            ++visible;
            supported += supports(side, p) ? 1 : 0;
        }
        evidence[i].visible = static_cast<double>(visible) / samples;
        evidence[i].support = visible > 0 ? static_cast<double>(supported) / visible : 0.0;
    }
    return evidence;
}

/// Returns the mean over the side.
double contrast_of(const cv::Mat1b& light, const Side& side) {
    double sum = 0.0;
    int looks = 0;
    for (int k = 0; k < samples; ++k) {
        const cv::Point2d p = side.sample(k);
        if (!can_look(light, side, p, distant_px)) continue;
        sum += at(light, p + side.inward * distant_px) - at(light, p - side.inward * distant_px);
        ++looks;
    }
    return looks > 0 ? sum / looks : 0.0;
}

}  // namespace

QuadEvidence rough_evidence(const cv::Mat1b& light, const Quad& quad) {
    return gathered(light, quad, rough_slack_px, [&](const Side& side, cv::Point2d p) {
        for (int t = -rough_slack_px; t <= rough_slack_px; ++t)
            if (rise(light, side, p + side.inward * t) > 0.0) return true;
        return false;
    });
}

QuadEvidence exact_evidence(const cv::Mat1b& light, const Quad& quad, double slack_px) {
    const double reach_px = std::ceil(slack_px) + beyond_px;
    QuadEvidence evidence = gathered(light, quad, reach_px, [&](const Side& side, cv::Point2d p) {
        const auto edge = edge_near(light, side, p, reach_px);
        return edge && std::abs(*edge) <= slack_px;
    });
    for (std::size_t i = 0; i < 4; ++i) evidence[i].contrast = contrast_of(light, side_of(quad, i));
    return evidence;
}

std::optional<Quad> refined(const cv::Mat1b& light, const Quad& quad, double reach_px) {
    std::array<Line, 4> lines;
    for (std::size_t i = 0; i < 4; ++i) {
        const Side side = side_of(quad, i);
        std::vector<cv::Point2f> edges;
        int visible = 0;
        for (int k = 0; k < samples; ++k) {
            const cv::Point2d p = side.sample(k);
            if (!can_look(light, side, p, reach_px)) continue;
            ++visible;
            if (const auto edge = edge_near(light, side, p, reach_px))
                edges.emplace_back(p + side.inward * *edge);
        }
        const auto line = visible < least_seen
                              ? std::optional(line_through(quad[i], quad[(i + 1) % 4]))
                              : line_of(std::move(edges), visible);
        if (!line) return std::nullopt;
        lines[i] = *line;
    }
    return quad_of(lines);
}

}  // namespace touchline
