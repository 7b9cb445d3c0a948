#include "vision/prepare/page_candidates.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

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

}  // namespace

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

}  // namespace touchline
