#include "vision/simplify/simplify.h"

#include "config/types/map_frame.h"
#include "vision/simplify/selection.h"
#include "vision/simplify/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

struct Extent {
    Position low;
    Position high;
};

Extent extent_of(const Outline& outline) {
    Extent extent{outline.points.front(), outline.points.front()};
    for (const Position& p : outline.points) {
        extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
        extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
    }
    return extent;
}

int third_of(double place, double size) {
    return std::clamp(static_cast<int>(std::floor(3.0 * (place / size + 0.5))), 0, 2);
}

std::string counted(int parts) {
    constexpr std::array<std::string_view, 11> names{
        "No", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten"};
    const auto i = static_cast<std::size_t>(parts);
    return fmt::format("{} part{}", i < names.size() ? std::string(names[i]) : fmt::to_string(i),
                       parts == 1 ? "" : "s");
}

/// Returns "at the upper left", "in the middle".
std::string where(std::string_view place) {
    const bool is_side = place == "left" || place == "right";
    return fmt::format("{} the {}", place == "middle" ? "in" : is_side ? "on" : "at", place);
}

std::string kind_of(LineOf of, bool is_closed) {
    switch (of) {
        case LineOf::texture:
            return "rough area";
        case LineOf::text:
            return "line of text";
        case LineOf::figure:
            return "figure";
        case LineOf::ring:
            return is_closed ? "outline of the main subject" : "part of the main subject’s outline";
        case LineOf::dashed:
            return "dashed line";
        case LineOf::dotted:
            return "dotted line";
        default:
            return is_closed ? "closed line" : "line";
    }
}

double diagonal_of(const Outline& outline) {
    const Extent extent = extent_of(outline);
    return std::hypot(extent.high.x - extent.low.x, extent.high.y - extent.low.y);
}

constexpr int least_detail_of_frame = 3;       // lower ones show what is in it
constexpr int least_detail_of_background = 4;  // lower ones show what lies before it

/// Takes the frames out of the lines, and returns the drawn ones. Such a frame is a stroke, or has
/// an outer and an inner edge; one ring alone beside the rim is the outer line of a thing that
/// fills the picture.
std::vector<Chain> frames_of(std::vector<Chain>& lines, const cv::Rect2d& picture_mm) {
    std::vector<Chain> inner;
    std::vector<Chain> around;
    for (const Chain& line : lines) (is_frame(line, picture_mm) ? around : inner).push_back(line);
    const bool is_stroke = std::ranges::any_of(
        around, [](double width_px) { return width_px > 0.0; }, &Chain::width_px);
    const bool is_one_with_the_rest =
        std::ranges::any_of(around, [&](const Chain& line) { return is_met(line, inner); });
    if ((!is_stroke && around.size() < 2) || inner.empty() || is_one_with_the_rest) {
        return {};  // a frame around nothing is the picture; one that lines end on is a wall
    }
    lines = std::move(inner);
    std::erase_if(around, [&](const Chain& line) { return is_rim(line, picture_mm); });
    return around;
}

/// Puts the rings of a photograph's figure first, and what lies behind it last, from detail 4 on.
void put_figure_first(std::vector<RankedLine>& order, int detail) {
    const auto place = [](const RankedLine& ranked) {
        return ranked.line.of == LineOf::ring ? 0 : ranked.line.of == LineOf::background ? 2 : 1;
    };
    std::ranges::stable_sort(order, {}, place);
    if (detail < least_detail_of_background && !order.empty() && place(order.front()) == 0) {
        std::erase_if(order, [&](const RankedLine& ranked) { return place(ranked) == 2; });
    }
}

/// Returns the lowest detail, from `detail` down, whose number and length of strokes hold these.
int lowest_detail(int strokes, double line_mm, int detail, const Area& area) {
    for (int lower = 1; lower < detail; ++lower) {
        const DetailLimits limits = limits_for(lower, area);
        if (strokes == 1 || (strokes <= limits.strokes && line_mm <= limits.line_mm)) return lower;
    }
    return detail;
}

void fill(TactileMap& map, const Selection& selection, const std::vector<RankedLine>& order,
          int detail) {
    const std::vector<Chain> lines = selection.lines();
    std::vector<LineOf> of;
    double line_mm = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Stroke& stroke = selection.strokes()[i];
        Outline outline = outline_of(lines[i], map.area);
        line_mm += stroke.length_mm;
        of.push_back(order[stroke.line].line.of);
        outline.weight = order[stroke.line].salience;
        outline.detail = lowest_detail(static_cast<int>(i) + 1, line_mm, detail, map.area);
        outline.id = "outline-" + std::to_string(i + 1);
        map.outlines.push_back(std::move(outline));
    }
    label_by_place(map, of);
}

}  // namespace

std::string_view word_of(Complexity complexity) {
    constexpr std::array<std::string_view, 3> words{"simple", "medium", "complex"};
    return words[static_cast<std::size_t>(complexity)];
}

std::string_view place_of(const Outline& outline, const Area& area) {
    constexpr std::array<std::array<std::string_view, 3>, 3> names{
        {{"lower left", "bottom", "lower right"},
         {"left", "middle", "right"},
         {"upper left", "top", "upper right"}}};
    const Extent extent = extent_of(outline);
    const int column = third_of(0.5 * (extent.low.x + extent.high.x), area.width_m);
    const int row = third_of(0.5 * (extent.low.y + extent.high.y), area.height_m);
    return names[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
}

void label_by_place(TactileMap& map, const std::vector<LineOf>& of) {
    std::map<std::string, int> uses;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        Outline& outline = map.outlines[i];
        const std::string kind = kind_of(of[i], outline.is_closed);
        const std::string_view place = place_of(outline, map.area);
        const int number = ++uses[fmt::format("{}, {}", kind, place)];
        outline.label = number == 1 ? fmt::format("{}, {}", kind, place)
                                    : fmt::format("{} {}, {}", kind, number, place);
    }
}

Complexity complexity_of(int parts, double line_mm, const Area& area) {
    const auto fits = [&](int detail) {
        const DetailLimits limits = limits_for(detail, area);
        return parts <= limits.strokes && line_mm <= limits.line_mm;
    };
    return fits(2) ? Complexity::simple : fits(4) ? Complexity::medium : Complexity::complex;
}

std::string words_for(const TactileMap& map, const SimplifyReport& report, int detail) {
    if (map.outlines.empty()) return "There is no line here.";
    constexpr std::array<std::string_view, 3> effort{"simple", "of medium difficulty", "complex"};
    std::string words = fmt::format("{}, {} centimetres of line, {}.", counted(report.parts),
                                    static_cast<int>(std::lround(0.1 * report.line_mm)),
                                    effort[static_cast<std::size_t>(report.complexity)]);
    const Outline& largest = *std::ranges::max_element(map.outlines, {}, diagonal_of);
    words += fmt::format(" {} lies {}.", report.parts == 1 ? "It" : "The largest",
                         where(place_of(largest, map.area)));
    if (report.frames_dropped > 0) words += " A frame around the picture is left out.";
    if (report.left_out > 0 && detail < most_detail) {
        words += " More lines are shown at a higher detail.";
    } else if (report.left_out > 0 && report.is_full) {
        words += " There are more lines than a hand can follow; zoom in.";
    } else if (report.left_out > 0) {
        words += " Some lines are too small or too close together; zoom in.";
    }
    return words;
}

Simplified simplified(const PictureLines& found, const Area& area, int detail, const Zoom& zoom) {
    Simplified result;
    TactileMap& map = result.map;
    SimplifyReport& report = result.report;
    map.area = area_of(view_box_of(area));
    const cv::Size2d area_mm(1000.0 * map.area.width_m, 1000.0 * map.area.height_m);
    const Placement placement(found.picture, found.working, map.area);

    std::vector<Chain> lines = in_zoom(found.chains, placement, map.area, zoom);
    const std::size_t in_pieces = lines.size();
    lines = with_breaks_closed(std::move(lines), small_break_mm);
    report.breaks_closed = static_cast<int>(in_pieces - lines.size());
    std::vector<Chain> frames =
        frames_of(lines, picture_in_zoom(placement, found.working, map.area, zoom));
    const Outside outside(lines, area_mm);
    lines = with_silhouettes_joined(std::move(lines), outside);
    const std::vector<double> shares = outside.shares_of(lines);
    std::vector<RankedLine> order = ranked(std::move(lines), shares, found.high);
    put_figure_first(order, detail);
    if (detail < least_detail_of_frame) {
        report.frames_dropped = static_cast<int>(frames.size());
    } else {
        for (Chain& frame : frames) {  // last: nothing else gives way to it
            order.push_back({std::move(frame), order.back().salience, 1.0});
        }
    }

    const Selection selection = selected(order, limits_for(detail, map.area), area_mm);
    fill(map, selection, order, detail);
    report.parts = static_cast<int>(map.outlines.size());
    report.line_mm = selection.line_mm();
    report.crossings_opened = selection.crossings_opened();
    report.complexity = complexity_of(report.parts, report.line_mm, map.area);
    std::vector<bool> is_shown(order.size(), false);
    for (const Stroke& stroke : selection.strokes()) is_shown[stroke.line] = true;
    report.lines = static_cast<int>(order.size());
    report.is_full = selection.is_full();
    report.left_out = static_cast<int>(std::ranges::count(is_shown, false));
    report.words = words_for(map, report, detail);
    return result;
}

}  // namespace touchline
