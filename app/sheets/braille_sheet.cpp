#include "app/sheets/braille_sheet.h"

#include "app/sheets/line_gaps.h"
#include "app/sheets/paper_place.h"
#include "app/sheets/sheet_words.h"
#include "app/sheets/stroke_grid.h"
#include "config/types/extent.h"

#include <algorithm>
#include <span>

namespace touchline {
namespace {

constexpr double dots_clear_mm = 5.0;  // between lines: more than the widest gap of two dots
constexpr double dot_step_mm = 0.4;
constexpr double widest_scale = 2.5;
constexpr double graphic_pitch_mm = 2.0;
constexpr double graphic_rim_mm = 5.0;

std::size_t nearest(const std::vector<double>& places_mm, double place_mm) {
    const auto after = std::ranges::lower_bound(places_mm, place_mm);
    if (after == places_mm.begin()) return 0;
    const auto i = static_cast<std::size_t>(after - places_mm.begin());
    if (after == places_mm.end()) return i - 1;
    return place_mm - places_mm[i - 1] <= places_mm[i] - place_mm ? i - 1 : i;
}

/// The dots of a picture from (x, y) on, `columns` wide and `rows` high, as bits: the first column
/// from the top, then the second.
unsigned bits_at(const DotPicture& dots, std::size_t x, std::size_t y, std::size_t rows) {
    unsigned bits = 0;
    for (std::size_t column = 0; column < 2; ++column)
        for (std::size_t row = 0; row < rows; ++row)
            if (x + column < dots.columns && y + row < dots.rows && dots.at(x + column, y + row))
                bits |= 1U << (column * rows + row);
    return bits;
}

void trim(BrailleCells& cells) {
    while (!cells.empty() && cells.back() == 0) cells.pop_back();
}

BraillePages paged(const std::vector<BrailleCells>& lines) {
    BraillePages pages;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i % embosser_rows == 0) pages.emplace_back();
        pages.back().push_back(lines[i]);
    }
    return pages;
}

}  // namespace

DotLattice text_lattice(std::size_t cells, std::size_t rows) {
    DotLattice lattice;
    for (std::size_t i = 0; i < 2 * cells; ++i)
        lattice.x_mm.push_back(static_cast<double>(i / 2) * braille_cell_mm +
                               static_cast<double>(i % 2) * braille_pitch_mm);
    for (std::size_t i = 0; i < 3 * rows; ++i)
        lattice.y_mm.push_back(static_cast<double>(i / 3) * braille_line_mm +
                               static_cast<double>(i % 3) * braille_pitch_mm);
    return lattice;
}

DotLattice even_lattice(std::size_t columns, std::size_t rows, double pitch_mm) {
    DotLattice lattice;
    for (std::size_t i = 0; i < columns; ++i)
        lattice.x_mm.push_back(static_cast<double>(i) * pitch_mm);
    for (std::size_t i = 0; i < rows; ++i)
        lattice.y_mm.push_back(static_cast<double>(i) * pitch_mm);
    return lattice;
}

DotLattice graphic_lattice(PaperKind paper) {
    const PaperSize size = size_of(paper);
    const auto count = [](double side_mm, std::size_t step) {
        const double room_mm = side_mm - 2.0 * graphic_rim_mm - 1.6;
        return static_cast<std::size_t>(room_mm / graphic_pitch_mm) / step * step;
    };
    return even_lattice(count(size.width_mm, 2), count(size.height_mm, 4), graphic_pitch_mm);
}

Result<DotPicture> dots_of(const TactileMap& map, const DotLattice& lattice) {
    const Extent extent = extent_of(map);
    if (!extent.is_finite()) return failure("there is no line to emboss");
    const PaperSize room{lattice.x_mm.back(), lattice.y_mm.back()};
    const PaperPlace place = middle_place(extent, {0.0, 0.0, room.width_mm, room.height_mm},
                                          fitting_scale(extent, room, widest_scale));
    DotPicture dots{lattice.x_mm.size(), lattice.y_mm.size(), {}};
    dots.raised.assign(dots.columns * dots.rows, false);
    for (const SheetStroke& stroke :
         paper_lines(map, place, room, {dots_clear_mm, 0.0, 0.0}).strokes)
        for (const PaperPoint& p : sampled(stroke, dot_step_mm))
            dots.raised[nearest(lattice.y_mm, p.y_mm) * dots.columns +
                        nearest(lattice.x_mm, p.x_mm)] = true;
    return dots;
}

Result<BraillePages> word_pages(const TactileMap& map, const BrailleHand& hand,
                                const Language& language) {
    return check_parts(map).and_then([&] {
        return braille_lines(paragraphs_of(map, {}, language), embosser_cells, hand).map(paged);
    });
}

Result<BraillePages> drawing_pages(const TactileMap& map, const BrailleHand& hand) {
    const auto title = cells_of(map.title, hand);
    if (!title) return tl::unexpected(title.error());
    const auto dots = dots_of(map, text_lattice(embosser_cells, embosser_rows - 1));
    if (!dots) return tl::unexpected(dots.error());
    std::vector<BrailleCells> page;
    const auto lines = wrapped(*title, embosser_cells);
    page.push_back(lines.empty() ? BrailleCells{} : lines.front());
    for (std::size_t y = 0; y < dots->rows; y += 3) {
        BrailleCells cells;
        for (std::size_t x = 0; x < dots->columns; x += 2)
            cells.push_back(static_cast<std::uint8_t>(bits_at(*dots, x, y, 3)));
        trim(cells);
        page.push_back(std::move(cells));
    }
    return BraillePages{std::move(page)};
}

std::string brf_of(const BraillePages& pages) {
    std::string text;
    for (const auto& page : pages) {
        for (const BrailleCells& line : page) {
            for (const std::uint8_t cell : line) text += braille_ascii(cell);
            text += "\r\n";
        }
        text += '\f';
    }
    return text;
}

std::vector<std::byte> file_bytes(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

Result<std::string> brf_sheet(const TactileMap& map, const BrailleHand& hand,
                              const Language& language) {
    auto pages = word_pages(map, hand, language);
    if (!pages) return tl::unexpected(pages.error());
    const auto drawing = drawing_pages(map, hand);
    if (!drawing) return tl::unexpected(drawing.error());
    pages->insert(pages->end(), drawing->begin(), drawing->end());
    return brf_of(*pages);
}

std::string ubrl_of(const DotPicture& dots) {
    std::string text;
    for (std::size_t y = 0; y < dots.rows; y += 4) {
        for (std::size_t x = 0; x < dots.columns; x += 2) {
            // Unicode counts dots 1 to 6 in columns of three; 7 and 8 are below.
            const unsigned bits = bits_at(dots, x, y, 4);
            const unsigned left = bits & 7U;
            const unsigned right = bits >> 4U & 7U;
            const unsigned low = (bits >> 3U & 1U) | (bits >> 7U & 1U) << 1U;
            const unsigned cell = left | right << 3U | low << 6U;
            text += '\xe2';
            text += static_cast<char>(0xa0U | cell >> 6U);
            text += static_cast<char>(0x80U | (cell & 0x3fU));
        }
        text += '\n';
    }
    return text;
}

std::string index_of(const BraillePages& words, const DotPicture& dots) {
    // Margins, first line and page numbers off, one impact, one side, text dots 2.5 mm and graphic
    // dots 2.0 mm apart, table of six dots. The rest is as the embosser is set.
    std::string bytes =
        "\x1b"
        "DTM0,BI0,FO0,MI1,DP1,TD0,GD0,PN0,BT0;";
    for (const auto& page : words) {
        for (const BrailleCells& line : page) {
            if (!line.empty()) {
                // So many cells as they are: a column of dots each half a byte.
                bytes += "\x1b\\";
                bytes += static_cast<char>(line.size());
                bytes += '\0';
                for (const std::uint8_t cell : line)
                    bytes += static_cast<char>((cell & 7U) | (cell >> 3U & 7U) << 4U);
            }
            bytes += "\r\n";
        }
        bytes += '\f';
    }
    bytes += "\x1b\x07";  // four-dot graphic mode: a letter a column, '@' is none
    for (std::size_t y = 0; y < dots.rows; y += 4) {
        std::string line;
        for (std::size_t x = 0; x < dots.columns; x += 2) {
            const unsigned bits = bits_at(dots, x, y, 4);
            line += static_cast<char>('@' + (bits & 15U));
            line += static_cast<char>('@' + (bits >> 4U));
        }
        line.erase(line.find_last_not_of('@') + 1);
        bytes += line + "\r\n";
    }
    bytes += "\x1b\x06";
    bytes += '\x1a';
    return bytes;
}

}  // namespace touchline
