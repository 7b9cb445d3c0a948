#include "tests/app/drawings/charts.h"

#include "tests/app/drawings/svg_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

namespace touchline::testing {
namespace {

const cv::Scalar black_ink(0, 0, 0);
const cv::Scalar white_paper(255, 255, 255);

/// Writes each thing into the file and into the list of known paints.
class Board {
  public:
    void stroke(const Polyline& line, double width_mm, const cv::Scalar& bgr = black_ink,
                std::string_view more = "") {
        paints_.push_back(stroked(line, width_mm, bgr));
        body_ += fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{:.3f}" {}/>)",
                             path_of(line), css_of(bgr), width_mm, more);
    }

    void line(const cv::Point2d& a, const cv::Point2d& b, double width_mm,
              const cv::Scalar& bgr = black_ink, std::string_view more = "") {
        stroke({{a, b}, false}, width_mm, bgr, more);
    }

    void dashed_line(const cv::Point2d& a, const cv::Point2d& b, double width_mm) {
        line(a, b, width_mm, black_ink, R"(stroke-dasharray="3 2")");
        paints_.back().dashes_mm = {3.0, 2.0};
    }

    void area(const Polyline& ring, const cv::Scalar& bgr) {
        paints_.push_back(filled(ring, bgr));
        body_ += fmt::format(R"(<path d="{}" fill="{}"/>)", path_of(ring), css_of(bgr));
    }

    void bar(const cv::Rect2d& r, const cv::Scalar& bgr) { area(box(r), bgr); }

    /// Pale lines behind a chart, which nobody should feel.
    void grid_line(const cv::Point2d& a, const cv::Point2d& b) {
        body_ += fmt::format(
            R"(<path d="M{:.3f} {:.3f}L{:.3f} {:.3f}" stroke="#d8d8d8" stroke-width="0.25"/>)", a.x,
            a.y, b.x, b.y);
    }

    void text(const std::string& words, const cv::Point2d& at, double size_mm = 3.0) {
        body_ += fmt::format(
            R"(<text x="{:.3f}" y="{:.3f}" font-size="{:.2f}" font-family="DejaVu Sans">{}</text>)",
            at.x, at.y, size_mm, words);
    }

    [[nodiscard]] static Polyline box(const cv::Rect2d& r) {
        return {{{r.x, r.y},
                 {r.x + r.width, r.y},
                 {r.x + r.width, r.y + r.height},
                 {r.x, r.y + r.height}},
                true};
    }

    [[nodiscard]] Drawing drawing() const { return {"", "", svg_sheet(body_), paints_}; }

  private:
    static std::string css_of(const cv::Scalar& bgr) {
        return fmt::format("rgb({:.0f},{:.0f},{:.0f})", bgr[2], bgr[1], bgr[0]);
    }

    static std::string path_of(const Polyline& line) {
        std::string d;
        for (const cv::Point2d& p : line.points)
            d += fmt::format("{}{:.4f} {:.4f}", d.empty() ? "M" : "L", p.x, p.y);
        return d + (line.is_closed ? "z" : "");
    }

    std::string body_;
    std::vector<Paint> paints_;
};

constexpr double floor_mm = 72.0;
constexpr double wall_mm = 18.0;

void add_axes(Board& board, double width_mm) {
    board.line({wall_mm, 6.0}, {wall_mm, floor_mm}, width_mm);
    board.line({wall_mm - width_mm / 2, floor_mm}, {112.0, floor_mm}, width_mm);
    for (int i = 0; i < 4; ++i) {
        const double y = floor_mm - 16.0 * (i + 1);
        board.line({wall_mm - 1.8, y}, {wall_mm, y}, width_mm);
        board.text(fmt::format("{}", 10 * (i + 1)), {wall_mm - 8.0, y + 1.0});
    }
}

void add_grid(Board& board) {
    for (double y = floor_mm - 8.0; y > 6.0; y -= 8.0) board.grid_line({wall_mm, y}, {112.0, y});
}

cv::Scalar bar_colour(Chance& chance) {
    constexpr std::array<std::array<double, 3>, 5> colours{
        {{180, 119, 31}, {14, 127, 220}, {44, 140, 44}, {40, 39, 214}, {70, 70, 70}}};
    const auto& c = colours[static_cast<std::size_t>(chance.below(5))];
    return {c[0], c[1], c[2]};
}

Drawing bars(Chance& chance) {
    Board board;
    if (chance.coin()) add_grid(board);
    const int n = 3 + chance.below(4);
    const double pitch = 90.0 / n;
    const double width = pitch - chance.between(4.0, 0.4 * pitch);
    const cv::Scalar colour = bar_colour(chance);
    for (int i = 0; i < n; ++i) {
        const double height = chance.between(12.0, 62.0);
        const double x = wall_mm + 4.5 + pitch * i;
        board.bar({x, floor_mm - height, width, height}, colour);
        board.text(fmt::format("Q{}", i + 1), {x + width / 2 - 2.0, floor_mm + 5.0});
    }
    add_axes(board, chance.between(0.3, 0.8));
    return board.drawing();
}

Drawing outlined_bars(Chance& chance) {
    Board board;
    const int n = 3 + chance.below(3);
    const double pitch = 88.0 / n;
    const double width = pitch - chance.between(5.0, 8.0);
    const double pen = chance.between(0.4, 1.0);
    for (int i = 0; i < n; ++i) {
        const double height = chance.between(14.0, 60.0);
        const double x = wall_mm + 5.0 + pitch * i;
        board.stroke({{{x, floor_mm},
                       {x, floor_mm - height},
                       {x + width, floor_mm - height},
                       {x + width, floor_mm}},
                      false},
                     pen);
    }
    add_axes(board, pen);
    return board.drawing();
}

Drawing stacked_bars(Chance& chance) {
    Board board;
    const int n = 3 + chance.below(2);
    const double pitch = 90.0 / n;
    const double width = pitch - chance.between(6.0, 9.0);
    for (int i = 0; i < n; ++i) {
        const double x = wall_mm + 5.0 + pitch * i;
        const double first = chance.between(12.0, 26.0);
        const double second = chance.between(12.0, 26.0);
        board.bar({x, floor_mm - first, width, first}, {180, 119, 31});
        board.bar({x, floor_mm - first - second, width, second}, {60, 200, 240});
    }
    add_axes(board, 0.5);
    return board.drawing();
}

Drawing curve(Chance& chance) {
    Board board;
    add_grid(board);
    Polyline line;
    const double phase = chance.between(0.0, 6.0);
    const double waves = chance.between(0.8, 1.6);
    for (int i = 0; i <= 90; ++i)
        line.points.emplace_back(
            wall_mm + 4.0 + i,
            40.0 - 22.0 * std::sin(phase + waves * 2 * std::numbers::pi * i / 90.0));
    board.stroke(line, chance.between(0.5, 1.2), {180, 60, 20});
    add_axes(board, 0.5);
    return board.drawing();
}

Drawing pie(Chance& chance) {
    Board board;
    const int n = 3 + chance.below(3);
    const double first = chance.between(0.0, 360.0);
    double from = first;
    constexpr std::array<std::array<double, 3>, 5> colours{
        {{180, 119, 31}, {14, 127, 255}, {44, 160, 44}, {40, 39, 214}, {60, 220, 240}}};
    for (int i = 0; i < n; ++i) {
        const double to = i + 1 == n ? first + 360.0 : from + 360.0 / n * chance.between(0.8, 1.1);
        Polyline slice = arc({58.0, 42.0}, {34.0, 34.0}, from, to);
        slice.is_closed = true;
        slice.points.emplace_back(58.0, 42.0);
        const auto& c = colours[static_cast<std::size_t>(i)];
        board.area(slice, {c[0], c[1], c[2]});
        from = to;
    }
    return board.drawing();
}

/// Adds a door's leaf and its quarter circle, in a gap of the wall from `at` along `along`.
void add_door(Board& board, const cv::Point2d& at, const cv::Point2d& along,
              const cv::Point2d& into) {
    board.line(at, at + into, 0.35);
    Polyline swing;
    for (int i = 0; i <= 24; ++i) {
        const double a = i * 0.5 * std::numbers::pi / 24;
        swing.points.push_back(at + into * std::cos(a) + along * std::sin(a));
    }
    board.stroke(swing, 0.35);
}

Drawing floor_plan(Chance& chance) {
    Board board;
    const double wall = chance.between(0.8, 2.2);
    const double middle = chance.between(48.0, 66.0);
    const double cross = chance.between(38.0, 48.0);
    const double door = chance.between(9.0, 12.0);
    const double x0 = 8.0, y0 = 8.0, x1 = 108.0, y1 = 76.0;
    const double entry = chance.between(20.0, 30.0);
    const std::string_view flat = R"(stroke-linecap="butt" stroke-linejoin="miter")";
    board.stroke({{{entry + door, y1}, {x1, y1}, {x1, y0}, {x0, y0}, {x0, y1}, {entry, y1}}, false},
                 wall, black_ink, flat);
    board.line({middle, y0}, {middle, cross - 12.0 - door}, wall, black_ink, flat);
    board.line({middle, cross - 12.0}, {middle, y1}, wall, black_ink, flat);
    board.line({middle, cross}, {x1 - 18.0 - door, cross}, wall, black_ink, flat);
    board.line({x1 - 18.0, cross}, {x1, cross}, wall, black_ink, flat);
    add_door(board, {entry, y1}, {door, 0.0}, {0.0, -door});
    add_door(board, {x1 - 18.0, cross}, {-door, 0.0}, {0.0, door});
    board.text("Kitchen", {18.0, 40.0});
    board.text("Hall", {80.0, 24.0});
    return board.drawing();
}

Drawing tactile_map(Chance& chance) {
    Board board;
    board.bar({0.0, 0.0, sheet_mm.width, sheet_mm.height}, white_paper);  // not a line of the map
    const cv::Scalar road(119, 119, 119);
    const double width = chance.between(1.2, 2.4);
    const double y = chance.between(36.0, 48.0);
    const double x = chance.between(46.0, 70.0);
    board.line({0.0, y}, {116.0, y + chance.between(-8.0, 8.0)}, width, road);
    board.line({x, 0.0}, {x + chance.between(-6.0, 6.0), 84.0}, width, road);
    for (const cv::Point2d& at :
         {cv::Point2d(8, 8), cv::Point2d(86, 8), cv::Point2d(10, 60), cv::Point2d(84, 62)})
        board.bar({at.x, at.y, chance.between(14.0, 22.0), chance.between(9.0, 15.0)}, black_ink);
    return board.drawing();
}

Drawing flow_chart(Chance& chance) {
    Board board;
    const double pen = chance.between(0.4, 1.0);
    const double y = chance.between(22.0, 30.0);
    for (int i = 0; i < 3; ++i) {
        const double x = 6.0 + 38.0 * i;
        if (i == 1)
            board.stroke({{{x + 13, y - 12}, {x + 26, y}, {x + 13, y + 12}, {x, y}}, true}, pen);
        else
            board.stroke(Board::box({x, y - 8, 26, 16}), pen);
        board.text(i == 1 ? "Dry?" : "Step", {x + 9, y + 1});
        if (i == 2) continue;
        board.line({x + 26, y}, {x + 35, y}, pen);
        board.area({{{x + 34, y - 2.2}, {x + 38, y}, {x + 34, y + 2.2}}, true}, black_ink);
    }
    board.stroke({{{57.0, y + 12}, {57.0, y + 34}, {19.0, y + 34}, {19.0, y + 12}}, false}, pen);
    board.area({{{16.8, y + 12}, {19.0, y + 8}, {21.2, y + 12}}, true}, black_ink);
    return board.drawing();
}

Drawing geometry(Chance& chance) {
    Board board;
    const double pen = chance.between(0.4, 0.9);
    const cv::Point2d a(12.0, 74.0);
    const cv::Point2d b(104.0, 74.0);
    const cv::Point2d top(chance.between(36.0, 80.0), chance.between(8.0, 24.0));
    board.stroke({{a, b, top}, true}, pen);
    board.dashed_line(top, {top.x, 74.0}, pen);
    board.text("A", {4.0, 76.0}, 4.0);
    board.text("B", {107.0, 76.0}, 4.0);
    board.text("C", {top.x + 2.0, top.y - 2.0}, 4.0);
    return board.drawing();
}

Drawing venn(Chance& chance) {
    Board board;
    const double pen = chance.between(0.5, 1.5);
    const double apart = chance.between(14.0, 20.0);
    board.stroke(arc({58.0 - apart, 42.0}, {28.0, 28.0}), pen);
    board.stroke(arc({58.0 + apart, 42.0}, {28.0, 28.0}), pen, {160, 40, 40});
    board.text("fish", {58.0 - apart - 18.0, 43.0}, 4.0);
    board.text("birds", {58.0 + apart + 6.0, 43.0}, 4.0);
    return board.drawing();
}

struct ChartKind {
    std::string_view name;
    Drawing (*draw)(Chance&);
};

constexpr std::array<ChartKind, 10> kinds{{{"bars", bars},
                                           {"outlined bars", outlined_bars},
                                           {"stacked bars", stacked_bars},
                                           {"curve", curve},
                                           {"pie", pie},
                                           {"floor plan", floor_plan},
                                           {"map of streets", tactile_map},
                                           {"flow chart", flow_chart},
                                           {"geometry", geometry},
                                           {"sets", venn}}};

}  // namespace

int chart_kind_count() {
    return static_cast<int>(kinds.size());
}

Drawing chart_drawing(int kind, int seed) {
    Chance chance(500'000 + 1000 * kind + seed);
    const ChartKind& one = kinds[static_cast<std::size_t>(kind)];
    Drawing drawing = one.draw(chance);
    drawing.kind = one.name;
    drawing.name = fmt::format("{} {}", one.name, seed);
    return drawing;
}

}  // namespace touchline::testing
