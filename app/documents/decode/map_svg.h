// A TactileMap as a file: an SVG whose user unit is one millimetre and whose viewBox is the drawing
// area, x right, y down (config/types/map_frame.h has the formula). A browser shows it, a drawing
// program edits it, and reading what was written gives the same map bit for bit.
// Threads: pure functions, except read_map_svg, which reads one file.
//
// Written are: one <path> (M, L, Z) per outline with id, data-label, data-weight and data-detail;
// one <text data-label="1"> per label; the map's title and description as <title> and <desc> of the
// root.
//
// Read are: <path> with all of SVG's path commands, <polyline>, <polygon>, <line>, <rect>,
// <circle>, <ellipse> and <text>, inside <g>, <a> and <svg>, all with their transforms. Every
// subpath is an outline; Z, or an end where it began, closes it.
//
// Languages, by SVG's own means: <title> and <desc> may occur several times, each with its own
// xml:lang; one without it serves every other language. In the root they are the root's words. A
// <title> inside a shape is its label, and so is data-label, which has no language. A <text> is
// drawn in one language; titles inside it say it in others. Left out is what is not drawn (defs,
// clipPath, mask, symbol, marker, pattern, display none), and also pictures, <use> and style
// sheets.
#pragma once

#include "config/types/choices.h"
#include "config/types/map_frame.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// The polylines of curves stay this near to them.
constexpr double flattening_tolerance_mm = 0.01;

/// A map with more points is refused.
constexpr std::size_t max_map_points = 4'000'000;

/// Reads the map in an SVG text. A coordinate that was written as such is read exactly; one that
/// had to be computed (a curve, a transform) is rounded to the nanometre grid. Consecutive equal
/// points become one point, and a lone point is no outline. A suffix -2, -3, ... makes ids unique;
/// white space in texts is collapsed. Each text is the one in `language`, else the one without
/// xml:lang, else the first; the map does not hold the others. The version stays 0: whoever uses
/// the map numbers it. Fails with one line: no SVG, no viewBox, a bad or infinite number, no
/// outline, more than max_map_points. Never expands entities of a DOCTYPE. O(text + points).
[[nodiscard]] Result<TactileMap> parse_map_svg(std::string_view text,
                                               const LanguageTag& language = {});

/// How hard the picture is to understand by touch, if its author said so: data-difficulty of the
/// root, from 1, one closed line, to 5, many parts (app/documents/gallery/README.md). Fails with
/// one line for any other value, and if it is no SVG. O(text).
[[nodiscard]] Result<std::optional<int>> difficulty_of_map_svg(std::string_view text);

/// Reads a map of Touchline's own, as format_map_svg() and the gallery write them: in millimetres,
/// no larger than `area`, with a data-detail on an outline or a data-difficulty. Fails for every
/// other SVG, which is a picture and is felt as it is painted. As parse_map_svg().
[[nodiscard]] Result<TactileMap> parse_own_map(std::string_view text, const Area& area,
                                               const LanguageTag& language = {});

/// Title and description of an SVG in `language` or in none, else in the first language there is.
/// White space is collapsed. Empty if it has none.
struct SvgWords {
    std::string title;
    std::string description;
};

[[nodiscard]] SvgWords words_of_svg(std::string_view text, const LanguageTag& language = {});

/// read_file and parse_map_svg; errors start with the path.
[[nodiscard]] Result<TactileMap> read_map_svg(const std::string& path,
                                              const LanguageTag& language = {});

/// The map as SVG text. parse_map_svg returns its points bit for bit if they are canonical
/// (map_frame.h), else within 1e-15 m. O(points).
[[nodiscard]] std::string format_map_svg(const TactileMap& map);

/// The d attribute of a polyline: "M1 2 L3 4 Z", with the shortest numbers that read back.
/// O(points).
[[nodiscard]] std::string path_data(std::span<const Position> points, bool is_closed,
                                    const ViewBox& box);

/// A number as it is written in SVG: the shortest text that reads back as the same double.
[[nodiscard]] std::string svg_number(double value);

/// True if there is a layer, or a shape that only aria-label or aria-labelledby names. False if the
/// text is no XML. O(text).
[[nodiscard]] bool has_image_layers(std::string_view text);

/// The same picture as a map SVG (map_svg.h). Every shape has its name, or else its layer's, as
/// <title>. If there is no description, the names and long descriptions of the layers become one.
/// The picture is fitted into `area` and centred, with its proportions kept, unless it is in
/// millimetres and small enough already. What a map SVG says itself stays. Fails with one line if
/// it is no SVG or has no size. O(text).
[[nodiscard]] Result<std::string> map_svg_of_image_layers(std::string_view text, const Area& area);

/// A map SVG as a layered picture in one language: with one title and description, every shape
/// named by aria-label, and one <g data-image-layer> for each detail that occurs. Read as a map SVG
/// it has the same points, bit for bit, and the same words. Fails with one line if it is no SVG.
/// O(text).
[[nodiscard]] Result<std::string> image_layers_of_map_svg(std::string_view text,
                                                          const LanguageTag& language);

}  // namespace touchline
