#include "vision/simplify/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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
            return is_closed ? "outline of the main thing" : "part of the main thing’s outline";
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
    if (map.outlines.empty()) {
        return "There is no line here.";
    }
    constexpr std::array<std::string_view, 3> kEffort{"simple", "of medium difficulty", "complex"};
    std::string words = fmt::format("{}, {} centimetres of line, {}.", counted(report.parts),
                                    static_cast<int>(std::lround(0.1 * report.line_mm)),
                                    kEffort[static_cast<std::size_t>(report.complexity)]);
    const Outline& largest = *std::ranges::max_element(map.outlines, {}, diagonal_of);
    words += fmt::format(" {} lies {}.", report.parts == 1 ? "It" : "The largest",
                         where(place_of(largest, map.area)));
    if (report.frames_dropped > 0) {
        words += " A frame around the picture is left out.";
    }
    if (report.left_out > 0 && detail < kMostDetail) {
        words += " More lines are shown at a higher detail.";
    } else if (report.left_out > 0 && report.is_full) {
        words += " There are more lines than a hand can follow; zoom in.";
    } else if (report.left_out > 0) {
        words += " Some lines are too small or too close together; zoom in.";
    }
    return words;
}

}  // namespace touchline
