#include "vision/prepare/page_candidates.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int level_step = 12;        // grey levels between thresholds
constexpr double least_share = 0.03;  // of the picture
constexpr double frame_margin_px = 2.5;
constexpr int most_corners = 8;
constexpr double beyond = 5.0;  // a fifth of the picture further out

using Contour = std::vector<cv::Point>;

/// Returns the outline of the region's hull, coarser and coarser until it has at most four corners
/// or has become as coarse as a side may be.
Contour polygon_of(const Contour& region) {
    Contour hull;
    cv::convexHull(region, hull);
    const double length_px = cv::arcLength(hull, true);
    Contour polygon;
    for (double share = 0.01; share < 0.06; share *= 1.4) {
        cv::approxPolyDP(hull, polygon, share * length_px, true);
        if (polygon.size() <= 4) break;
    }
    return polygon;
}

bool is_on_frame(cv::Point a, cv::Point b, cv::Size size) {
    const auto both = [](int p, int q, double least, double most) {
        return (p < least && q < least) || (p > most && q > most);
    };
    return both(a.x, b.x, frame_margin_px, size.width - 1 - frame_margin_px) ||
           both(a.y, b.y, frame_margin_px, size.height - 1 - frame_margin_px);
}

/// Returns the frame's line beside which this side runs, moved out of the picture, because the page
/// ends somewhere beyond.
Line beyond_frame(cv::Point a, cv::Point b, cv::Size size) {
    const cv::Point2d middle = (cv::Point2d(a) + cv::Point2d(b)) / 2.0;
    const cv::Point2d centre((size.width - 1) / 2.0, (size.height - 1) / 2.0);
    const bool is_upright = std::abs(a.x - b.x) < std::abs(a.y - b.y);
    const cv::Point2d out(
        is_upright ? std::copysign(size.width / beyond, middle.x - centre.x) : 0.0,
        is_upright ? 0.0 : std::copysign(size.height / beyond, middle.y - centre.y));
    return {middle + out, is_upright ? cv::Point2d(0.0, 1.0) : cv::Point2d(1.0, 0.0)};
}

/// Sides along the frame are where the picture ends, not the page. If only a corner was cut off,
/// the neighbours of such a side are extended until they meet; otherwise the page ends beyond the
/// frame.
void add_pages(const Contour& polygon, cv::Size size, std::vector<Quad>& quads) {
    std::vector<Line> own;
    std::vector<Line> all;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const cv::Point a = polygon[i];
        const cv::Point b = polygon[(i + 1) % polygon.size()];
        const bool is_frame = is_on_frame(a, b, size);
        if (!is_frame) own.push_back(line_through(a, b));
        all.push_back(is_frame ? beyond_frame(a, b, size) : line_through(a, b));
    }
    const auto add = [&](const std::vector<Line>& sides) {
        if (sides.size() != 4) return;
        const auto quad = quad_of({sides[0], sides[1], sides[2], sides[3]});
        if (quad && is_sheet_like(*quad)) quads.push_back(ordered(*quad));
    };
    add(own);
    if (own.size() != all.size() && own.size() >= 2) add(all);
}

constexpr std::size_t most_lines = 9;  // in a direction
constexpr double same_angle_rad = 5.0 * CV_PI / 180;
constexpr double same_place_px = 6.0;
constexpr double least_gap_share = 0.15;  // of the picture's shorter side, between opposite sides

struct Straight {
    double rho_px;
    double theta_rad;

    [[nodiscard]] Line line() const {
        const cv::Point2d normal(std::cos(theta_rad), std::sin(theta_rad));
        return {normal * rho_px, {-normal.y, normal.x}};
    }
};

/// Returns the angle between two undirected lines, 0 ... pi/2.
double angle_between(double a, double b) {
    const double d = std::abs(std::remainder(a - b, CV_PI));
    return d;
}

double distance(const Line& line, cv::Point2d point) {
    return std::abs(line.direction.cross(point - line.point));
}

/// Returns lines by the number of pixels on them, without near doubles, strongest first.
std::vector<Straight> straight_lines(const cv::Mat1b& light) {
    cv::Mat1b edges;
    // Page edges may be faint, so the thresholds are just those of a shade across the page, and
    // above.
    cv::Canny(light, edges, 12, 24);
    const int least_votes = std::min(light.cols, light.rows) / 6;
    std::vector<cv::Vec2f> found;
    cv::HoughLines(edges, found, 1.0, CV_PI / 180, least_votes);
    const cv::Point2d centre(light.cols / 2.0, light.rows / 2.0);
    std::vector<Straight> lines;
    for (const cv::Vec2f& one : found) {
        const Straight line{one[0], one[1]};
        const bool is_double = std::any_of(lines.begin(), lines.end(), [&](const Straight& known) {
            const cv::Point2d nearest =
                centre - cv::Point2d(std::cos(line.theta_rad), std::sin(line.theta_rad)) *
                             (centre.dot({std::cos(line.theta_rad), std::sin(line.theta_rad)}) -
                              line.rho_px);
            return angle_between(known.theta_rad, line.theta_rad) < same_angle_rad &&
                   distance(known.line(), nearest) < same_place_px;
        });
        if (!is_double) lines.push_back(line);
        if (lines.size() >= 4 * most_lines) break;
    }
    return lines;
}

/// The two direction groups: the lines along the strongest line, and those across it.
std::array<std::vector<Line>, 2> groups_of(const std::vector<Straight>& lines) {
    std::array<std::vector<Line>, 2> groups;
    for (const Straight& line : lines) {
        const bool is_along = angle_between(line.theta_rad, lines.front().theta_rad) < CV_PI / 4;
        auto& group = groups[is_along ? 0 : 1];
        if (group.size() < most_lines) group.push_back(line.line());
    }
    return groups;
}

constexpr int samples = 48;            // a side
constexpr double corner_share = 0.04;  // at either end: corners are rounded, bent, held
constexpr double apart_px = 2.5;       // of the two looks, to either side of the line
constexpr double least_levels = 6.0;   // brighter inside, at least, and ...
constexpr double least_gain = 0.07;    // ... by this share of the brightness inside
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
    return inside - outside >= std::max(least_levels, least_gain * inside) ? inside - outside
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

std::vector<Quad> bright_regions(const cv::Mat1b& light) {
    std::vector<Quad> quads;
    double darkest = 0.0;
    double brightest = 0.0;
    cv::minMaxLoc(light, &darkest, &brightest);
    const double least_px = least_share * static_cast<double>(light.total());
    const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
    for (double level = darkest + level_step; level < brightest; level += level_step) {
        cv::Mat mask = light > level;
        cv::morphologyEx(mask, mask, cv::MORPH_OPEN, kernel);
        std::vector<Contour> regions;
        cv::findContours(mask, regions, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
        for (const Contour& region : regions) {
            if (cv::contourArea(region) < least_px) continue;
            const Contour polygon = polygon_of(region);
            if (polygon.size() < 4 || polygon.size() > most_corners) continue;
            add_pages(polygon, light.size(), quads);
        }
    }
    return quads;
}

std::vector<Quad> line_quads(const cv::Mat1b& light) {
    std::vector<Quad> quads;
    const std::vector<Straight> lines = straight_lines(light);
    if (lines.empty()) return quads;
    const auto groups = groups_of(lines);
    const double least_gap_px = least_gap_share * std::min(light.cols, light.rows);
    const cv::Point2d centre(light.cols / 2.0, light.rows / 2.0);
    const auto is_pair = [&](const Line& a, const Line& b) {
        const cv::Point2d on_a = a.point + a.direction * a.direction.dot(centre - a.point);
        return distance(b, on_a) >= least_gap_px &&
               std::abs(a.direction.cross(b.direction)) < std::sin(CV_PI / 6);
    };
    for (std::size_t i = 0; i < groups[0].size(); ++i)
        for (std::size_t j = i + 1; j < groups[0].size(); ++j) {
            if (!is_pair(groups[0][i], groups[0][j])) continue;
            for (std::size_t k = 0; k < groups[1].size(); ++k)
                for (std::size_t l = k + 1; l < groups[1].size(); ++l) {
                    if (!is_pair(groups[1][k], groups[1][l])) continue;
                    const auto quad =
                        quad_of({groups[0][i], groups[1][k], groups[0][j], groups[1][l]});
                    if (quad && is_sheet_like(*quad)) quads.push_back(ordered(*quad));
                }
        }
    return quads;
}

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
