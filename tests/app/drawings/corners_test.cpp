// Tests closed pen lines with sharp corners, from the file to the map: each must be one closed line
// with its corners where they were drawn. TOUCHLINE_EXHAUSTIVE=1 tries more (tests/README.md).
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/drawings/felt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

using testing::Join;
using testing::Pen;
using testing::Polyline;

constexpr double px_per_mm = 1200.0 / 116.0;

/// Returns a PNG as a drawing program saves it: black on white, anti-aliased.
testing::Drawing png_of(const Polyline& line, const Pen& pen) {
    testing::Canvas canvas({1200, 869}, cv::Scalar::all(255));
    canvas.stroke({line}, pen, cv::Scalar::all(0));
    const cv::Mat bgr = canvas.picture();
    testing::Drawing drawing;
    for (const std::byte byte :
         encoders::png({bgr.cols, bgr.rows, {bgr.data, bgr.data + 3 * bgr.total()}}))
        drawing.file.push_back(static_cast<char>(byte));
    return drawing;
}

Polyline ring_of(const std::vector<cv::Point2d>& corners) {
    return {corners, true};
}

double distance(const cv::Point2d& p, const cv::Point2d& a, const cv::Point2d& b) {
    const cv::Point2d side = b - a;
    const double t = std::clamp((p - a).dot(side) / side.dot(side), 0.0, 1.0);
    return cv::norm(p - a - t * side);
}

double distance(const cv::Point2d& p, const Polyline& ring) {
    double least = cv::norm(p - ring.points.front());
    for (std::size_t i = 0; i < ring.points.size(); ++i)
        least =
            std::min(least, distance(p, ring.points[i], ring.points[(i + 1) % ring.points.size()]));
    return least;
}

double length_of(const Polyline& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.points.size(); ++i)
        sum += cv::norm(ring.points[i] - ring.points[(i + 1) % ring.points.size()]);
    return sum;
}

/// Returns what is wrong, in words. Returns nothing for one closed line whose corners are all
/// within a millimetre, which nowhere strays and is no longer than drawn: no spur, no way there and
/// back.
std::string fault_of(const Polyline& drawn, const Pen& pen) {
    const auto view = testing::whole_view_of(png_of(drawn, pen), 3, 1e12);
    if (!view) return view.error().line;
    const auto& outlines = view->map.outlines;
    if (outlines.size() != 1) return fmt::format("{} lines", outlines.size());
    if (!outlines[0].is_closed) return "not closed";
    Polyline ring = drawn;
    for (cv::Point2d& p : ring.points) p /= px_per_mm;
    const std::vector<cv::Point2d> felt = testing::in_steps(outlines[0]);
    for (const cv::Point2d& corner : ring.points) {
        double least = 1e9;
        for (const cv::Point2d& at : felt) least = std::min(least, cv::norm(at - corner));
        if (least > 1.0) return fmt::format("a corner is {:.2f} mm off", least);
    }
    double aside = 0.0;
    for (const cv::Point2d& at : felt) aside = std::max(aside, distance(at, ring));
    if (aside > 1.0) return fmt::format("{:.2f} mm aside", aside);
    const double share = length_of({felt, true}) / length_of(ring);
    if (share > 1.02) return fmt::format("{:.3f} times as long", share);
    return {};
}

struct Figure {
    std::string name;
    Polyline line;
};

/// An upright triangle, 600 pixels high.
Figure triangle(double apex_deg) {
    const double half = 600.0 * std::tan(apex_deg * std::numbers::pi / 360.0);
    return {fmt::format("triangle of {} degrees", apex_deg),
            ring_of({{600.0 - half, 740.0}, {600.0 + half, 740.0}, {600.0, 140.0}})};
}

/// Corners at even angles, alternating between two distances from the middle.
Figure star(int rays, double inner) {
    Polyline line{{}, true};
    for (int i = 0; i < 2 * rays; ++i) {
        const double a = std::numbers::pi * i / rays + 0.1;
        const double r = i % 2 == 0 ? 340.0 : 340.0 * inner;
        line.points.emplace_back(600.0 + r * std::sin(a), 430.0 - r * std::cos(a));
    }
    return {fmt::format("{} of {} rays", inner == 1.0 ? "polygon" : "star", rays), line};
}

/// Teeth of this angle above a straight side.
Figure zig_zag(double apex_deg) {
    constexpr int teeth = 3;
    const double half = 320.0 * std::tan(apex_deg * std::numbers::pi / 360.0);
    const double left = 600.0 - teeth * half;
    Polyline line{{{left - 60.0, 720.0}, {left - 60.0, 500.0}}, true};
    for (int i = 0; i < teeth; ++i) {
        line.points.emplace_back(left + 2 * i * half, 500.0);
        line.points.emplace_back(left + (2 * i + 1) * half, 180.0);
    }
    line.points.emplace_back(left + 2 * teeth * half, 500.0);
    line.points.emplace_back(left + 2 * teeth * half + 60.0, 500.0);
    line.points.emplace_back(left + 2 * teeth * half + 60.0, 720.0);
    return {fmt::format("zig-zag of {} degrees", apex_deg), line};
}

void expect_one_closed_line(const Figure& figure) {
    constexpr std::array<std::pair<Join, std::string_view>, 3> joins{
        {{Join::mitre, "mitred"}, {Join::round, "round"}, {Join::bevel, "bevelled"}}};
    for (const double width_px : {3.0, 6.0, 10.0})
        for (const auto& [join, name] : joins)
            EXPECT_EQ(fault_of(figure.line, {width_px, join, testing::Cap::butt}), "")
                << figure.name << ", " << width_px << " px, " << name;
}

bool is_exhaustive() {
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr;
}

TEST(SharpCorners, ATriangleIsOneClosedLine) {
    for (const double apex_deg : {15.0, 27.0, 60.0}) expect_one_closed_line(triangle(apex_deg));
    if (!is_exhaustive()) return;
    for (const double apex_deg : {20.0, 25.0, 30.0, 36.0, 45.0})
        expect_one_closed_line(triangle(apex_deg));
}

TEST(SharpCorners, APolygonAStarAndAZigZagAreOneClosedLine) {
    for (const Figure& figure : {star(4, 1.0), star(5, 0.38), zig_zag(20.0)})
        expect_one_closed_line(figure);
    if (!is_exhaustive()) return;
    for (const Figure& figure : {star(3, 1.0), star(8, 1.0), star(6, 0.5), star(4, 0.3),
                                 zig_zag(15.0), zig_zag(22.0), zig_zag(25.0), zig_zag(40.0)})
        expect_one_closed_line(figure);
}

}  // namespace
}  // namespace touchline
