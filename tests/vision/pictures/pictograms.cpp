#include "tests/vision/pictures/pictograms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchline::testing {
namespace {

Polyline ring(std::vector<cv::Point2d> points) {
    return {std::move(points), true};
}

Polyline line(std::vector<cv::Point2d> points) {
    return {std::move(points), false};
}

Polyline circle(cv::Point2d centre, double radius) {
    return arc(centre, {radius, radius});
}

Polyline star(int tips, double outer, double inner) {
    Polyline made{{}, true};
    for (int i = 0; i < 2 * tips; ++i) {
        const double a = std::numbers::pi * i / tips - std::numbers::pi / 2.0;
        const double r = i % 2 == 0 ? outer : inner;
        made.points.emplace_back(12.0 + r * std::cos(a), 12.0 + r * std::sin(a));
    }
    return made;
}

/// Joins arcs and points one after the other, and closes the line.
Polyline joined(const std::vector<Polyline>& parts) {
    Polyline made{{}, true};
    for (const Polyline& part : parts) {
        made.points.insert(made.points.end(), part.points.begin(), part.points.end());
    }
    return made;
}

Polyline wave(double amplitude, double periods) {
    Polyline made;
    for (int i = 0; i <= 100; ++i) {
        made.points.emplace_back(
            3.0 + 0.18 * i,
            20.0 + amplitude * std::sin(2.0 * std::numbers::pi * periods * i / 100));
    }
    return made;
}

Polyline spiral() {
    Polyline made;
    for (int i = 0; i <= 200; ++i) {
        const double a = 4.0 * std::numbers::pi * i / 200.0;
        made.points.emplace_back(12.0 + (1.0 + 0.55 * a) * std::cos(a),
                                 12.0 + (1.0 + 0.55 * a) * std::sin(a));
    }
    return made;
}

double distance_px(const cv::Point2d& p, const cv::Point2d& a, const cv::Point2d& b) {
    const cv::Point2d along = b - a;
    const double square = along.dot(along);
    const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return cv::norm(p - a - t * along);
}

std::size_t segments(const Polyline& line) {
    return line.points.size() - (line.is_closed ? 0 : 1);
}

}  // namespace

std::vector<Pictogram> pictograms() {
    return {
        {"house",
         {ring({{4, 11}, {12, 4}, {20, 11}, {20, 20}, {4, 20}}),
          line({{9, 20}, {9, 14}, {15, 14}, {15, 20}})}},
        {"heart",
         {joined(
             {arc({8, 9}, {4, 4}, 150, 320), arc({16, 9}, {4, 4}, 220, 390), line({{12, 21}})})}},
        {"star", {star(5, 9, 4)}},
        {"bell",
         {joined({arc({12, 10}, {6, 6}, 180, 360), line({{19, 18}, {5, 18}})}),
          arc({12, 18}, {2.5, 3}, 0, 180)}},
        {"cup", {ring({{4, 6}, {16, 6}, {15, 19}, {5, 19}}), arc({16, 11}, {4, 3.5}, -80, 95)}},
        {"key",
         {circle({7, 12}, 4), line({{11, 12}, {21, 12}, {21, 16}}), line({{17, 12}, {17, 15}})}},
        {"flag", {ring({{5, 4}, {19, 4}, {16, 8.5}, {19, 13}, {5, 13}}), line({{5, 13}, {5, 21}})}},
        {"arrow", {ring({{3, 9}, {12, 9}, {12, 4}, {21, 12}, {12, 20}, {12, 15}, {3, 15}})}},
        {"cross",
         {ring({{9, 3},
                {15, 3},
                {15, 9},
                {21, 9},
                {21, 15},
                {15, 15},
                {15, 21},
                {9, 21},
                {9, 15},
                {3, 15},
                {3, 9},
                {9, 9}})}},
        {"clock", {circle({12, 12}, 9), line({{12, 6.5}, {12, 12}, {15.5, 14.5}})}},
        {"mail",
         {ring({{3, 6}, {21, 6}, {21, 18}, {3, 18}}), line({{6.5, 9.5}, {12, 14}, {17.5, 9.5}})}},
        {"lock",
         {ring({{5, 11}, {19, 11}, {19, 21}, {5, 21}}),
          joined({line({{8, 11}}), arc({12, 8}, {4, 4}, 180, 360), line({{16, 11}})})}},
        {"eye",
         {joined({arc({12, 18}, {11, 12}, 210, 330), arc({12, 6}, {11, 12}, 30, 150)}),
          circle({12, 12}, 2.5)}},
        {"fish", {joined({arc({10, 12}, {7, 5}, 30, 330), line({{21, 7}, {21, 17}})})}},
        {"tree",
         {ring({{12, 3}, {19, 11}, {14.5, 11}, {20, 18}, {4, 18}, {9.5, 11}, {5, 11}}),
          line({{12, 18}, {12, 22}})}},
        {"cloud",
         {joined({arc({7, 14}, {4, 4}, 90, 250), arc({12, 10}, {5, 5}, 200, 340),
                  arc({17, 14}, {4, 4}, 290, 450)})}},
        {"triangle", {ring({{12, 3}, {21, 20}, {3, 20}}), line({{12, 9}, {12, 14.5}})}},
        {"umbrella",
         {joined({arc({12, 12}, {9, 8}, 180, 360)}), line({{12, 12}, {12, 20}, {15.5, 20}})}},
        {"hexagon", {star(3, 9, 9), circle({12, 12}, 3.5)}},
        {"drop", {joined({line({{12, 3}}), arc({12, 14}, {6.5, 6.5}, -30, 210)})}},
        {"box",
         {ring({{12, 3}, {20, 7.5}, {20, 16.5}, {12, 21}, {4, 16.5}, {4, 7.5}}),
          line({{12, 12}, {20, 7.5}}), line({{12, 12}, {12, 21}}), line({{12, 12}, {4, 7.5}})}},
        {"boat",
         {ring({{3, 15}, {21, 15}, {17.5, 20}, {6.5, 20}}), line({{12, 15}, {12, 3}, {18.5, 12}})}},
        {"lens", {circle({10, 10}, 6.5), line({{14.6, 14.6}, {21, 21}})}},
        {"water", {circle({12, 8}, 5), wave(1.5, 2.0)}},
        {"snail", {spiral()}},
    };
}

double farthest_px(const std::vector<Polyline>& from, const std::vector<Polyline>& to) {
    constexpr double curve_step_px = 1.0;
    double worst = 0.0;
    const auto measure = [&](const cv::Point2d& p) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Polyline& other : to) {
            for (std::size_t i = 0; i < segments(other); ++i) {
                nearest = std::min(
                    nearest,
                    distance_px(p, other.points[i], other.points[(i + 1) % other.points.size()]));
            }
        }
        worst = std::max(worst, nearest);
    };
    for (const Polyline& line : from) {
        for (std::size_t i = 0; i < segments(line); ++i) {
            const cv::Point2d a = line.points[i];
            const cv::Point2d b = line.points[(i + 1) % line.points.size()];
            const int steps = 1 + static_cast<int>(cv::norm(b - a) / curve_step_px);
            for (int k = 0; k <= steps; ++k) {
                measure(a + (static_cast<double>(k) / steps) * (b - a));
            }
        }
    }
    return worst;
}

}  // namespace touchline::testing
