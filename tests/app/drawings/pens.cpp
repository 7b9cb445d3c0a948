#include "tests/app/drawings/pens.h"

#include "tests/app/drawings/svg_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

std::string path_of(const Polyline& line) {
    std::string d;
    for (const cv::Point2d& p : line.points)
        d += fmt::format("{}{:.3f} {:.3f}", d.empty() ? "M" : "L", p.x, p.y);
    return d + (line.is_closed ? "z" : "");
}

Polyline box(const cv::Rect2d& r) {
    return {
        {{r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}},
        true};
}

std::string css_of(const cv::Scalar& bgr) {
    return fmt::format("rgb({:.0f},{:.0f},{:.0f})", bgr[2], bgr[1], bgr[0]);
}

Polyline wave(const cv::Point2d& from, const cv::Point2d& to, double height, double waves) {
    Polyline line;
    const cv::Point2d along = to - from;
    const cv::Point2d across = cv::Point2d(-along.y, along.x) / cv::norm(along);
    constexpr int curve_steps = 120;
    for (int i = 0; i <= curve_steps; ++i) {
        const double t = static_cast<double>(i) / curve_steps;
        line.points.push_back(from + t * along +
                              height * std::sin(2.0 * std::numbers::pi * waves * t) * across);
    }
    return line;
}

std::string stroked_path(const Polyline& line, double width_mm, const cv::Scalar& bgr,
                         const std::string& more) {
    return fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{:.3f}" {}/>)",
                       path_of(line), css_of(bgr), width_mm, more);
}

}  // namespace

std::span<const Dashing> dashings() {
    static const std::array<Dashing, 6> dash_patterns{{{1.0, 1.0, 0.4, false, {0, 0, 0}},
                                                       {2.0, 4.0, 0.8, true, {40, 39, 214}},
                                                       {4.0, 2.5, 0.5, false, {14, 150, 240}},
                                                       {6.0, 4.0, 1.5, true, {0, 0, 0}},
                                                       {0.0, 2.5, 1.0, true, {40, 39, 214}},
                                                       {0.0, 1.5, 0.8, false, {0, 0, 0}}}};
    return dash_patterns;
}

Drawing dashed_drawing(const Dashing& dashing, int seed) {
    Chance chance(700'000 + seed);
    const double width = dashing.width_mm;
    // A round cap extends each end of a dash by half the width.
    const double on = dashing.dash_mm > 0.0 && dashing.is_round
                          ? std::max(0.0, dashing.dash_mm - width)
                      : dashing.dash_mm > 0.0 ? dashing.dash_mm
                      : dashing.is_round      ? 0.0
                                              : width;
    const double off = dashing.gap_mm + (dashing.is_round ? width : 0.0);
    const std::string more = fmt::format(
        R"(stroke-dasharray="{:.3f} {:.3f}" stroke-dashoffset="{:.2f}" stroke-linecap="{}")", on,
        off, chance.between(0.0, 4.0), dashing.is_round ? "round" : "butt");
    const cv::Rect2d left(6.0, 6.0, chance.between(18.0, 26.0), chance.between(14.0, 20.0));
    const cv::Rect2d right(88.0, 58.0, chance.between(16.0, 22.0), chance.between(12.0, 18.0));
    std::string body;
    Drawing drawing;
    const std::array<cv::Scalar, 2> fills{cv::Scalar(60, 200, 240), cv::Scalar(180, 119, 31)};
    for (const auto& [r, colour] : {std::pair(left, fills[0]), std::pair(right, fills[1])}) {
        const Polyline ring = box(r);
        body += fmt::format(R"(<path d="{}" fill="{}"/>)", path_of(ring), css_of(colour));
        drawing.paints.push_back(filled(ring, colour));
    }
    const double lean = chance.between(-6.0, 6.0);
    const double from = chance.between(150.0, 190.0);
    const std::array<Polyline, 4> lines{
        Polyline{{{38.0, 12.0 + lean}, {110.0, 12.0 - lean}}, false},
        arc({36.0, 52.0}, {22.0, 22.0}, from, from + chance.between(120.0, 200.0)),
        wave({64.0, 30.0}, {110.0, 38.0}, chance.between(3.0, 6.0), chance.between(0.8, 1.5)),
        Polyline{{{50.0, 76.0}, {54.0, 54.0 - lean}, {78.0, 58.0}, {76.0, 77.0}}, true}};
    for (const Polyline& line : lines) {
        body += stroked_path(line, width, dashing.colour, more);
        drawing.paints.push_back(stroked(line, width, dashing.colour));
        drawing.paints.back().dashes_mm = {dashing.dash_mm, dashing.gap_mm};
    }
    drawing.kind = "dashes";
    drawing.name = fmt::format("{} mm, gap {} mm, width {} mm, {}, {}", dashing.dash_mm,
                               dashing.gap_mm, width, dashing.is_round ? "round" : "flat", seed);
    drawing.file = svg_sheet(body);
    return drawing;
}

std::vector<Drawing> broken_line_art() {
    struct Art {
        std::string_view name;
        Polyline broken;
        std::vector<double> dashes_mm;
        std::string_view more;
        double width_mm;
    };

    const std::array<Art, 4> arts{
        {{"box of dashes", box({23.0, 17.0, 70.0, 49.0}), {2.6, 2.1}, "2.6 2.1", 0.46},
         {"circle of dots", arc({58.0, 42.0}, {26.7, 26.7}), {0.0, 1.6}, "0 2.8", 1.2},
         {"circle of dashes", arc({58.0, 42.0}, {29.0, 29.0}), {2.5, 2.0}, "2.5 2.0", 0.46},
         {"axis", {{{12.0, 52.0}, {104.0, 52.0}}, false}, {2.6, 2.1}, "2.6 2.1", 0.46}}};
    std::vector<Drawing> drawings;
    for (const Art& art : arts) {
        Drawing drawing{"broken line art", std::string(art.name), {}, {}};
        const std::string cap = art.dashes_mm[0] > 0.0 ? "butt" : "round";
        std::string body = stroked_path(
            art.broken, art.width_mm, {0, 0, 0},
            fmt::format(R"(stroke-dasharray="{}" stroke-linecap="{}")", art.more, cap));
        drawing.paints.push_back(stroked(art.broken, art.width_mm, {0, 0, 0}));
        drawing.paints.back().dashes_mm = art.dashes_mm;
        if (!art.broken.is_closed) {
            const Polyline whole = box({23.0, 14.0, 70.0, 21.0});
            body += stroked_path(whole, art.width_mm, {0, 0, 0}, "");
            drawing.paints.push_back(stroked(whole, art.width_mm, {0, 0, 0}));
        }
        drawing.file = svg_sheet(body);
        drawings.push_back(std::move(drawing));
    }
    return drawings;
}

Drawing thin_fills(double width_mm, bool is_even_odd) {
    const double half = 0.5 * width_mm;
    const auto grown = [](const cv::Rect2d& r, double by) {
        return box({r.x - by, r.y - by, r.width + 2.0 * by, r.height + 2.0 * by});
    };
    const cv::Rect2d frame(66.0, 18.0, 40.0, 50.0);
    std::string body;
    Drawing drawing;
    for (const auto& [outer, inner] : {std::pair(arc({32.0, 42.0}, {22.0 + half, 22.0 + half}),
                                                 arc({32.0, 42.0}, {22.0 - half, 22.0 - half})),
                                       std::pair(grown(frame, half), grown(frame, -half))}) {
        Polyline hole = inner;
        if (!is_even_odd) std::reverse(hole.points.begin(), hole.points.end());
        body += fmt::format(R"(<path d="{}{}" fill-rule="{}"/>)", path_of(outer), path_of(hole),
                            is_even_odd ? "evenodd" : "nonzero");
    }
    drawing.paints.push_back(stroked(arc({32.0, 42.0}, {22.0, 22.0}), width_mm, {0, 0, 0}));
    drawing.paints.push_back(stroked(grown(frame, 0.0), width_mm, {0, 0, 0}));
    drawing.kind = "thin fills";
    drawing.name =
        fmt::format("fills of {} mm, {}", width_mm, is_even_odd ? "even-odd" : "nonzero");
    drawing.file = svg_sheet(body);
    return drawing;
}

Drawing crossing_strokes(int seed) {
    Chance chance(800'000 + seed);
    const bool is_black = chance.coin();
    constexpr std::array<std::array<double, 3>, 4> colours{
        {{180, 119, 31}, {14, 127, 220}, {44, 140, 44}, {40, 39, 214}}};
    const std::array<Polyline, 4> lines{
        wave({6.0, chance.between(14.0, 30.0)}, {110.0, chance.between(14.0, 30.0)},
             chance.between(0.0, 7.0), chance.between(0.7, 1.4)),
        Polyline{{{6.0, chance.between(56.0, 72.0)},
                  {chance.between(50.0, 66.0), chance.between(46.0, 74.0)},
                  {110.0, chance.between(56.0, 72.0)}},
                 false},
        Polyline{{{chance.between(24.0, 40.0), 5.0}, {chance.between(24.0, 40.0), 79.0}}, false},
        wave({chance.between(76.0, 92.0), 5.0}, {chance.between(76.0, 92.0), 79.0},
             chance.between(0.0, 7.0), chance.between(0.7, 1.2))};
    std::string body;
    Drawing drawing;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double width = chance.between(0.5, 6.0);
        const auto& c = colours[i];
        const cv::Scalar colour = is_black ? cv::Scalar(0, 0, 0) : cv::Scalar(c[0], c[1], c[2]);
        body += stroked_path(lines[i], width, colour, "");
        drawing.paints.push_back(stroked(lines[i], width, colour));
    }
    drawing.kind = "crossing strokes";
    drawing.name = fmt::format("crossing strokes {}", seed);
    drawing.file = svg_sheet(body);
    return drawing;
}

}  // namespace touchline::testing
