// A TactileMap as a file: an SVG whose user unit is one millimetre and whose viewBox is the drawing
// area, x right, y down (config/types/map_frame.h has the formula). A browser shows it, a drawing
// program edits it, and reading what was written gives the same map bit for bit.
// Threads: pure functions, but for read_map_svg, which reads one file.
//
// Written: one <path> (M, L, Z) an outline with id, data-label, data-weight and data-detail; one
// <text data-label="1"> a label; <title> and <desc> of the root are the map's.
//
// Read: <path> with all of SVG's path commands, <polyline>, <polygon>, <line>, <rect>, <circle>,
// <ellipse> and <text>, inside <g>, <a> and <svg>, all with their transforms. Every subpath is an
// outline, closed by Z or by ending where it began.
//
// Languages, by SVG's own means: <title> and <desc> may be there several times, told apart by
// xml:lang; the one without it is for everybody else. They are the root's words, and a <title>
// inside a shape is its label, as is data-label, which has no language. A <text> is drawn in one
// language; titles inside it say it in others. Left out: what is not drawn (defs, clipPath, mask,
// symbol, marker, pattern, display none), pictures, <use>, style sheets.
#pragma once

#include "config/types/language_tag.h"
#include "config/types/map_frame.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// Curves become polylines that stay this near to them.
constexpr double flattening_tolerance_mm = 0.01;

/// A map with more points is refused.
constexpr std::size_t max_map_points = 4'000'000;

/// The map in an SVG text. A coordinate that was written as such is read exactly; one that had to
/// be computed (a curve, a transform) is put on the nanometre grid. Consecutive equal points are
/// one point, and a lone point is no outline. Ids are made unique by a suffix -2, -3, ...; texts
/// have their white space collapsed. Each is the one in `language`, else the one without xml:lang,
/// else the first; the map does not hold the others. The version is left 0: who takes the map into
/// use numbers it. Fails with one line: no SVG, no viewBox, a number that is none or not finite, no
/// outline, more than max_map_points. Entities of a DOCTYPE are never expanded. O(text + points).
[[nodiscard]] Result<TactileMap> parse_map_svg(std::string_view text,
                                               const LanguageTag& language = {});

/// How hard the picture is to understand by touch, if whoever drew it said so: data-difficulty of
/// the root, from 1, one closed line, to 5, many parts (app/gallery/README.md). Fails with one line
/// for any other value, and for what is no SVG. O(text).
[[nodiscard]] Result<std::optional<int>> difficulty_of_map_svg(std::string_view text);

/// A map of Touchline's own, as format_map_svg() and the gallery write them: in millimetres, no
/// larger than `area`, with a data-detail on an outline or a data-difficulty. Fails for every other
/// SVG: that is a picture, and felt as it is painted. As parse_map_svg().
[[nodiscard]] Result<TactileMap> parse_own_map(std::string_view text, const Area& area);

/// Title and description of an SVG in English or no language, else in the first that is there;
/// white space collapsed; empty where it has none.
struct SvgWords {
    std::string title;
    std::string description;
};

[[nodiscard]] SvgWords words_of_svg(std::string_view text);

/// read_file and parse_map_svg; errors start with the path.
[[nodiscard]] Result<TactileMap> read_map_svg(const std::string& path,
                                              const LanguageTag& language = {});

/// The map as SVG text. parse_map_svg returns its points bit for bit if they are canonical
/// (map_frame.h), else within 1e-15 m. O(points).
[[nodiscard]] std::string format_map_svg(const TactileMap& map);

/// The d attribute of a polyline: "M1 2 L3 4 Z", numbers shortest that read back. O(points).
[[nodiscard]] std::string path_data(std::span<const Position> points, bool is_closed,
                                    const ViewBox& box);

/// A number as it is written in SVG: the shortest text that reads back as the same double.
[[nodiscard]] std::string svg_number(double value);

}  // namespace touchline
