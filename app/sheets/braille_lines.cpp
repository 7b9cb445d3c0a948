#include "app/sheets/braille_lines.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

std::vector<BrailleCells> words_in(const BrailleCells& cells) {
    std::vector<BrailleCells> words;
    bool goes_on = false;
    for (const std::uint8_t cell : cells) {
        if (cell != 0 && !goes_on) words.emplace_back();
        if (cell != 0) words.back().push_back(cell);
        goes_on = cell != 0;
    }
    return words;
}

}  // namespace

Result<BrailleCells> cells_of(std::string_view text, const BrailleHand& hand) {
    return braille_of(text, hand.language, hand.grade).map([](const BrailleText& braille) {
        BrailleCells cells;
        for (const BrailleCells& word : words_in(braille.cells)) {
            if (!cells.empty()) cells.push_back(0);
            cells.insert(cells.end(), word.begin(), word.end());
        }
        return cells;
    });
}

std::vector<BrailleCells> wrapped(const BrailleCells& cells, std::size_t width,
                                  std::size_t first_indent, std::size_t next_indent) {
    std::vector<BrailleCells> lines;
    bool has_words = false;  // on the last line
    const auto begin_line = [&] {
        lines.emplace_back(lines.empty() ? first_indent : next_indent, std::uint8_t{0});
        has_words = false;
    };
    for (const BrailleCells& word : words_in(cells)) {
        if (lines.empty()) begin_line();
        if (has_words && lines.back().size() + 1 + word.size() > width) begin_line();
        if (has_words) lines.back().push_back(0);
        for (const std::uint8_t cell : word) {
            if (lines.back().size() == width) begin_line();
            lines.back().push_back(cell);
            has_words = true;
        }
    }
    return lines;
}

std::size_t longest_word(const BrailleCells& cells) {
    std::size_t longest = 0;
    for (const BrailleCells& word : words_in(cells)) longest = std::max(longest, word.size());
    return longest;
}

std::vector<std::vector<BrailleCells>> label_shapes(const BrailleCells& cells,
                                                    std::size_t most_width,
                                                    std::size_t most_lines) {
    std::vector<std::vector<BrailleCells>> shapes;
    const std::size_t longest = longest_word(cells);
    if (longest == 0) return shapes;
    // Each number of lines once, by its narrowest width: from the widest down.
    for (std::size_t width = std::min(cells.size(), most_width); width >= longest; --width) {
        auto lines = wrapped(cells, width);
        if (lines.size() > most_lines) break;
        if (!shapes.empty() && shapes.back().size() == lines.size()) shapes.pop_back();
        shapes.push_back(std::move(lines));
    }
    return shapes;
}

}  // namespace touchline
