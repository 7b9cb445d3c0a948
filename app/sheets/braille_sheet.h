// A sheet for an embosser: text, and the lines as dots; and the ways in which embossers are told.
// Threads: pure functions, except for the tables of braille_of() (app/braille/translation.h).
#pragma once

#include "app/sheets/braille_lines.h"
#include "app/sheets/tactile_sheet.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

inline constexpr std::size_t embosser_cells = 40;
inline constexpr std::size_t embosser_rows = 24;

/// Dots in rows from the top; raised[y * columns + x].
struct DotPicture {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<bool> raised;

    [[nodiscard]] bool at(std::size_t x, std::size_t y) const { return raised[y * columns + x]; }
};

/// Where the columns and rows of dots lie on the paper, in millimetres, ascending.
struct DotLattice {
    std::vector<double> x_mm;
    std::vector<double> y_mm;
};

/// That of cells of text: dots are nearer in a cell than between two.
[[nodiscard]] DotLattice text_lattice(std::size_t cells, std::size_t rows);

/// That of an embosser's graphic mode: all dots are `pitch_mm` apart.
[[nodiscard]] DotLattice even_lattice(std::size_t columns, std::size_t rows, double pitch_mm);

/// What an embosser's graphic mode reaches on upright paper: dots 2 mm apart, 5 mm from the rims.
/// Debian's drivers take it so by default.
[[nodiscard]] DotLattice graphic_lattice(PaperKind paper);

/// The lines as large as the lattice allows, in its middle. Lines keep a dot free between them as
/// paper_lines() keeps gaps; each dot raised is the nearest to a place of a line. Fails with one
/// line for a map without lines.
[[nodiscard]] Result<DotPicture> dots_of(const TactileMap& map, const DotLattice& lattice);

/// Pages of lines: at most embosser_rows of at most embosser_cells cells.
using BraillePages = std::vector<std::vector<BrailleCells>>;

/// The words: title, description, parts.
[[nodiscard]] Result<BraillePages> word_pages(const TactileMap& map, const BrailleHand& hand,
                                              const Language& language);

/// A page of text cells: the title in one line, then the lines as dots.
[[nodiscard]] Result<BraillePages> drawing_pages(const TactileMap& map, const BrailleHand& hand);

/// North American ASCII braille; a line ends in CR LF, and a page in a form feed. O(cells).
[[nodiscard]] std::string brf_of(const BraillePages& pages);

/// What brf_of(), ubrl_of() and index_of() give, as a file has it.
[[nodiscard]] std::vector<std::byte> file_bytes(std::string_view text);

/// A whole sheet as brf_of(): the words, then the drawing.
[[nodiscard]] Result<std::string> brf_sheet(const TactileMap& map, const BrailleHand& hand,
                                            const Language& language);

/// The dots in Unicode's patterns of eight, two wide and four high, a row of cells a line: the form
/// that Debian's CUPS drivers call UBRL. O(dots).
[[nodiscard]] std::string ubrl_of(const DotPicture& dots);

/// The bytes for an Index embosser of generation 3 to 5: words as text, then the dots in its
/// four-dot graphic mode, 2 mm apart, on a page of their own. O(cells + dots).
[[nodiscard]] std::string index_of(const BraillePages& words, const DotPicture& dots);

}  // namespace touchline
