#include "tests/vision/pictures/pen_figures.h"

#include "config/types/angle.h"
#include "tests/vision/pictures/chance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

namespace touchline::testing {
namespace {

constexpr double sharpest_deg = 15.0;

cv::Point2d at_angle(double radius, double deg) {
    const double a = radians(deg);
    return {radius * std::cos(a), radius * std::sin(a)};
}

double angle_deg(const cv::Point2d& a, const cv::Point2d& corner, const cv::Point2d& b) {
    const cv::Point2d u = a - corner;
    const cv::Point2d v = b - corner;
    return std::abs(std::atan2(u.cross(v), u.dot(v))) * 180.0 / std::numbers::pi;
}

/// Whether the sides are long enough for their corners and no corner is too sharp.
bool is_drawable(const Polyline& ring, double least_side) {
    const std::size_t n = ring.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const cv::Point2d& here = ring.points[i];
        const cv::Point2d& next = ring.points[(i + 1) % n];
        if (cv::norm(next - here) < least_side) return false;
        if (angle_deg(ring.points[(i + n - 1) % n], here, next) < sharpest_deg) return false;
    }
    return true;
}

// All are about the origin, in a circle of radius 1; `thin` is the pen's width there.

std::vector<Polyline> pen_polygon(Chance& chance, double thin) {
    for (;;) {
        const int n = 3 + chance.below(6);
        Polyline ring{{}, true};
        const double turn = chance.between(0.0, 360.0);
        for (int i = 0; i < n; ++i)
            ring.points.push_back(at_angle(chance.between(0.35, 1.0),
                                           turn + (i + chance.between(-0.3, 0.3)) * 360.0 / n));
        if (is_drawable(ring, 14.0 * thin)) return {ring};
    }
}

std::vector<Polyline> pen_star(Chance& chance, double thin) {
    for (;;) {
        const int tips = 3 + chance.below(5);
        const double inner = chance.between(0.25, 0.7);
        Polyline ring{{}, true};
        const double turn = chance.between(0.0, 360.0);
        for (int i = 0; i < 2 * tips; ++i)
            ring.points.push_back(at_angle(i % 2 == 0 ? 1.0 : inner, turn + i * 180.0 / tips));
        if (is_drawable(ring, 14.0 * thin)) return {ring};
    }
}

std::vector<Polyline> pen_triangle(Chance& chance, double /*thin*/) {
    const double half_deg = 0.5 * chance.between(sharpest_deg, 60.0);
    const double half_base = 1.8 * std::tan(radians(half_deg));
    const double reach = std::max(1.0, std::hypot(half_base, 0.8));
    Polyline ring{{{0.0, -1.0}, {half_base, 0.8}, {-half_base, 0.8}}, true};
    for (cv::Point2d& p : ring.points) p /= reach;
    return {ring};
}

std::vector<Polyline> pen_zigzag(Chance& chance, double thin) {
    const int n = 2 + chance.below(5);
    const double angle = chance.between(sharpest_deg, 90.0);
    const double height = std::max(14.0 * thin, chance.between(0.6, 1.4));
    const double step = height * std::tan(0.5 * radians(angle));
    Polyline line;
    for (int i = 0; i <= n; ++i)
        line.points.emplace_back((i - 0.5 * n) * step, i % 2 == 0 ? 0.5 * height : -0.5 * height);
    const double reach = std::max(1.0, std::hypot(0.5 * n * step, 0.5 * height));
    for (cv::Point2d& p : line.points) p /= reach;
    return {line};
}

std::vector<Polyline> pen_arrow(Chance& chance, double /*thin*/) {
    const double barb_deg = chance.between(22.0, 45.0);
    const double barb = chance.between(0.6, 0.9);
    const cv::Point2d tip(1.0, 0.0);
    return {{{{-1.0, 0.0}, tip}, false},
            {{tip - at_angle(barb, barb_deg), tip, tip - at_angle(barb, -barb_deg)}, false}};
}

std::vector<Polyline> pen_crossing(Chance& chance, double /*thin*/) {
    const double angle = chance.between(sharpest_deg, 90.0);
    const cv::Point2d middle(chance.between(-0.15, 0.15), 0.0);
    return {{{{-1.0, 0.0}, middle, {1.0, 0.0}}, false},
            {{middle - at_angle(0.8, angle), middle, middle + at_angle(0.8, angle)}, false}};
}

std::vector<Polyline> pen_three_arms(Chance& chance, double /*thin*/) {
    const double first = chance.between(20.0, 120.0);
    const double second = chance.between(20.0, 150.0);
    const cv::Point2d middle(0.0, 0.0);
    return {{{at_angle(1.0, 0.0), middle, at_angle(0.9, first)}, false},
            {{middle, at_angle(0.9, first + second)}, false}};
}

std::vector<Polyline> pen_stroke_on_stroke(Chance& chance, double /*thin*/) {
    const cv::Point2d foot(chance.between(-0.3, 0.3), 0.0);
    return {{{{-1.0, 0.0}, foot, {1.0, 0.0}}, false},
            {{foot, foot + at_angle(0.65, chance.between(20.0, 160.0))}, false}};
}

std::vector<Polyline> pen_letter(Chance& chance, double /*thin*/) {
    const cv::Point2d left(-0.2, 0.2);
    const cv::Point2d right(0.2, 0.2);
    const std::vector<std::vector<Polyline>> letters{
        {{{{-0.5, 0.95},
           left + cv::Point2d(-0.055, 0.0),
           {0.0, -0.95},
           right + cv::Point2d(0.055, 0.0),
           {0.5, 0.95}},
          false},
         {{left + cv::Point2d(-0.055, 0.0), right + cv::Point2d(0.055, 0.0)}, false}},   // A
        {{{{-0.5, -0.9}, {0.0, 0.9}, {0.5, -0.9}}, false}},                              // V
        {{{{-0.9, -0.8}, {-0.45, 0.8}, {0.0, -0.8}, {0.45, 0.8}, {0.9, -0.8}}, false}},  // W
        {{{{-0.7, 0.8}, {-0.6, -0.8}, {0.0, 0.6}, {0.6, -0.8}, {0.7, 0.8}}, false}},     // M
        {{{{-0.5, 0.9}, {-0.5, -0.9}, {0.5, 0.9}, {0.5, -0.9}}, false}},                 // N
        {{{{0.3, 0.95}, {0.3, 0.4}, {0.3, -0.95}, {-0.5, 0.4}, {0.3, 0.4}, {0.7, 0.4}},
          false}},                                            // 4
        {{{{-0.5, -0.9}, {0.5, -0.9}, {-0.1, 0.9}}, false}},  // 7
    };
    std::vector<Polyline> drawn =
        letters[static_cast<std::size_t>(chance.below(static_cast<int>(letters.size())))];
    for (Polyline& line : drawn)
        for (cv::Point2d& p : line.points) p *= 0.8;  // into the circle
    return drawn;
}

using PenMaker = std::vector<Polyline> (*)(Chance&, double);

constexpr std::array<std::pair<const char*, PenMaker>, 9> pen_makers{
    {{"polygon", pen_polygon},
     {"star", pen_star},
     {"triangle", pen_triangle},
     {"zig-zag", pen_zigzag},
     {"arrow", pen_arrow},
     {"crossing", pen_crossing},
     {"three arms", pen_three_arms},
     {"stroke on stroke", pen_stroke_on_stroke},
     {"letter", pen_letter}}};

/// The neighbours of each point; equal points count as one.
using Graph = std::map<std::pair<double, double>, std::multiset<std::pair<double, double>>>;

Graph graph_of(const std::vector<Polyline>& lines) {
    Graph graph;
    const auto key = [](const cv::Point2d& p) { return std::pair(p.x, p.y); };
    for (const Polyline& line : lines) {
        const std::size_t n = line.points.size();
        for (std::size_t i = 0; i + (line.is_closed ? 0 : 1) < n; ++i) {
            const auto a = key(line.points[i]);
            const auto b = key(line.points[(i + 1) % n]);
            if (a == b) continue;
            graph[a].insert(b);
            graph[b].insert(a);
        }
    }
    return graph;
}

}  // namespace

PenFigure pen_figure(int seed, cv::Size size) {
    Chance chance(seed);
    const auto& [name, make] = pen_makers[static_cast<std::size_t>(seed) % pen_makers.size()];
    PenFigure figure{name, {}, {}};
    figure.pen.width_px = chance.between(2.5, 8.0);
    figure.pen.join = static_cast<Join>(chance.below(3));
    figure.pen.cap = static_cast<Cap>(chance.below(3));
    const double radius_px = 0.5 * std::min(size.width, size.height) - 4.0 * figure.pen.width_px;
    const double turn_deg = chance.between(0.0, 360.0);
    const cv::Point2d middle(0.5 * size.width + chance.between(-1.0, 1.0),
                             0.5 * size.height + chance.between(-1.0, 1.0));
    for (const Polyline& line : make(chance, figure.pen.width_px / radius_px))
        figure.lines.push_back(placed(line, middle, radius_px, turn_deg));
    return figure;
}

Topology topology_of(const std::vector<Polyline>& lines) {
    const Graph graph = graph_of(lines);
    Topology topology;
    std::set<std::pair<double, double>> seen;
    int edges = 0;
    for (const auto& [point, neighbours] : graph) {
        edges += static_cast<int>(neighbours.size());
        if (neighbours.size() == 1) ++topology.ends;
        if (neighbours.size() > 2)
            topology.junctions.push_back(static_cast<int>(neighbours.size()));
        if (!seen.insert(point).second) continue;
        ++topology.parts;
        std::vector<std::pair<double, double>> open{point};
        while (!open.empty()) {
            const auto here = open.back();
            open.pop_back();
            for (const auto& next : graph.at(here))
                if (seen.insert(next).second) open.push_back(next);
        }
    }
    std::ranges::sort(topology.junctions);
    topology.loops = edges / 2 - static_cast<int>(graph.size()) + topology.parts;
    return topology;
}

std::string words_of(const Topology& topology) {
    std::ostringstream words;
    words << topology.parts << " parts, " << topology.loops << " loops, " << topology.ends
          << " ends, junctions of";
    for (const int lines : topology.junctions) words << ' ' << lines;
    return words.str();
}

}  // namespace touchline::testing
