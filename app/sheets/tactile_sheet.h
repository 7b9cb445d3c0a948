// A sheet to take home, as it is drawn: lines, braille and a little print, all in millimetres.
// Threads: values and pure functions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// From the upper left corner of the page, x right, y down.
struct PaperPoint {
    double x_mm = 0.0;
    double y_mm = 0.0;

    friend bool operator==(const PaperPoint&, const PaperPoint&) = default;
};

/// No std::hypot: layout asks for millions of distances, and none is so large or small that its
/// square is not a number.
[[nodiscard]] inline double distance_mm(PaperPoint a, PaperPoint b) {
    const double x = b.x_mm - a.x_mm;
    const double y = b.y_mm - a.y_mm;
    return std::sqrt(x * x + y * y);
}

/// The point at `share` (0 ... 1) of the way.
[[nodiscard]] inline PaperPoint between(PaperPoint from, PaperPoint to, double share) {
    return {from.x_mm + share * (to.x_mm - from.x_mm), from.y_mm + share * (to.y_mm - from.y_mm)};
}

/// left_mm <= right_mm, top_mm <= bottom_mm.
struct PaperBox {
    double left_mm = 0.0;
    double top_mm = 0.0;
    double right_mm = 0.0;
    double bottom_mm = 0.0;

    [[nodiscard]] double width_mm() const { return right_mm - left_mm; }

    [[nodiscard]] double height_mm() const { return bottom_mm - top_mm; }

    friend bool operator==(const PaperBox&, const PaperBox&) = default;
};

[[nodiscard]] inline PaperBox grown(const PaperBox& box, double by_mm) {
    return {box.left_mm - by_mm, box.top_mm - by_mm, box.right_mm + by_mm, box.bottom_mm + by_mm};
}

/// 0 inside.
[[nodiscard]] inline double distance_mm(const PaperBox& box, PaperPoint p) {
    const double x = std::max({box.left_mm - p.x_mm, p.x_mm - box.right_mm, 0.0});
    const double y = std::max({box.top_mm - p.y_mm, p.y_mm - box.bottom_mm, 0.0});
    return std::hypot(x, y);
}

enum class PaperKind : std::uint8_t { a4, letter };

struct PaperSize {
    double width_mm = 210.0;
    double height_mm = 297.0;

    friend bool operator==(const PaperSize&, const PaperSize&) = default;
};

/// Upright.
[[nodiscard]] constexpr PaperSize size_of(PaperKind paper) {
    return paper == PaperKind::a4 ? PaperSize{210.0, 297.0} : PaperSize{215.9, 279.4};
}

// What a finger needs of paper (the README has the sources).

inline constexpr double paper_margin_mm = 10.0;
inline constexpr double least_clear_mm = 3.0;  // between the edges of any two things
inline constexpr double outer_line_mm = 1.5;
inline constexpr double inner_line_mm = 1.25;
inline constexpr double thin_line_mm = 1.0;  // of leaders, bar and arrow

// Braille on paper.

inline constexpr double braille_dot_mm = 1.5;    // across
inline constexpr double braille_pitch_mm = 2.5;  // dot to dot in a cell
inline constexpr double braille_cell_mm = 6.0;   // cell to cell
inline constexpr double braille_line_mm = 10.0;  // line to line
inline constexpr double braille_label_mm = 8.0;  // between the dots of two labels
/// Between two that are beside each other without a line between them: as three blank cells, for
/// one is a space between words.
inline constexpr double braille_beside_mm = 20.0;

enum class StrokeUse : std::uint8_t { outline, leader, furniture };

/// A line of constant width with round ends; a single point is a dot of that width.
struct SheetStroke {
    std::vector<PaperPoint> points;
    bool is_closed = false;
    double width_mm = thin_line_mm;
    StrokeUse use = StrokeUse::outline;
    std::size_t source = 0;  // the outline of the map; of a leader: its block; else 0
};

struct BrailleRow {
    PaperPoint first_dot;             // the middle of dot 1 of the first cell
    std::vector<std::uint8_t> cells;  // bit 0 is dot 1; 0 is a blank
};

/// Words in braille, in one or more rows.
struct BrailleBlock {
    std::string words;
    std::vector<BrailleRow> rows;
};

/// The middle of dot `dot` (0 ... 5) of a cell.
[[nodiscard]] inline PaperPoint dot_place(const BrailleRow& row, std::size_t cell, int dot) {
    return {row.first_dot.x_mm + static_cast<double>(cell) * braille_cell_mm +
                (dot < 3 ? 0.0 : braille_pitch_mm),
            row.first_dot.y_mm + (dot % 3) * braille_pitch_mm};
}

/// The width and height that whole cells take, from edge to edge of their dots. Both counts >= 1.
[[nodiscard]] constexpr double braille_width_mm(std::size_t cells) {
    return static_cast<double>(cells - 1) * braille_cell_mm + braille_pitch_mm + braille_dot_mm;
}

[[nodiscard]] constexpr double braille_height_mm(std::size_t rows) {
    return static_cast<double>(rows - 1) * braille_line_mm + 2.0 * braille_pitch_mm +
           braille_dot_mm;
}

/// The cells that fit into a width; 0 if none does.
[[nodiscard]] constexpr std::size_t cells_in(double width_mm) {
    const double rest_mm = width_mm - braille_pitch_mm - braille_dot_mm;
    return rest_mm < 0.0 ? 0 : 1 + static_cast<std::size_t>(rest_mm / braille_cell_mm + 1e-9);
}

[[nodiscard]] constexpr std::size_t rows_in(double height_mm) {
    const double rest_mm = height_mm - 2.0 * braille_pitch_mm - braille_dot_mm;
    return rest_mm < 0.0 ? 0 : 1 + static_cast<std::size_t>(rest_mm / braille_line_mm + 1e-9);
}

/// The box of whole cells. The block has at least one row.
[[nodiscard]] PaperBox box_of(const BrailleBlock& block);

/// Ink for eyes; `base` is the left end of the base line. It has a colour that heat does not raise.
struct SheetPrint {
    PaperPoint base;
    double cap_mm = 2.5;
    double width_mm = 100.0;  // at most; the rest is cut off
    std::string text;
};

struct PaperPage {
    PaperSize size;  // may lie on its side
    std::vector<SheetStroke> strokes;
    std::vector<BrailleBlock> blocks;
    std::vector<SheetPrint> prints;
};

/// The first page is the drawing, the others are words.
struct TactileSheet {
    std::vector<PaperPage> pages;
    double scale = 1.0;                   // millimetres on paper per millimetre of the map
    std::vector<std::string> left_out;    // parts that the drawing lacks wholly or in places
    std::vector<std::string> unlabelled;  // parts whose label found no room
};

}  // namespace touchline
