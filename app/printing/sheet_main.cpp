// touchline-sheet KIND LANGUAGE WORDS: makes a sheet of a map, shut in as a decoder is: the map's
// names came with a stranger's picture, and crowded maps take memory and time. KIND: a SheetKind.
#include "app/documents/decode/worker_program.h"
#include "app/sheets/braille_sheet.h"
#include "app/sheets/sheet_drawing.h"
#include "app/sheets/sheet_layout.h"
#include "app/sheets/sheet_words.h"
#include "audio-cues/words/language.h"
#include "config/types/choices.h"
#include "config/types/map_bytes.h"
#include "config/types/utf8.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

/// The file says nothing of the picture but what is on the paper.
Result<Bytes> sheet_for(SheetKind kind, const TactileMap& map, const Language& language) {
    const BrailleHand hand{language.code(), BrailleGrade::uncontracted};
    if (kind == SheetKind::embosser) return brf_sheet(map, hand, language).map(file_bytes);
    const PaperKind paper = kind == SheetKind::letter ? PaperKind::letter : PaperKind::a4;
    return tactile_sheet(map, {paper, hand}, language).and_then([](const TactileSheet& sheet) {
        return pdf_of(sheet, "Touchline");
    });
}

/// A sheet of its own makes the libraries read their fonts and tables.
void prepare(SheetKind kind, const Language& language) {
    TactileMap map;
    map.title = "A";
    Outline& line = map.outlines.emplace_back();
    line.points = {{-0.02, 0.0}, {0.02, 0.0}};
    line.label = "a 1";
    (void)sheet_for(kind, map, language);
}

std::optional<SheetKind> sheet_kind_in(const std::string& word) {
    const auto kind = number_in(word, 0, sheet_kind_count - 1);
    return kind ? std::optional(static_cast<SheetKind>(*kind)) : std::nullopt;
}

/// No answer says that there is no sheet: a page of a decoder's refusal would be printed.
Result<Bytes> answer(SheetKind kind, std::span<const std::byte> input, const Language& language) {
    auto sheet = map_of(input).and_then([&](TactileMap map) {
        return sheet_for(kind, named_for_paper(std::move(map), language), language);
    });
    return sheet ? std::move(*sheet) : Bytes();
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    using namespace touchline;
    const auto kind = argc == 4 ? sheet_kind_in(argv[1]) : std::nullopt;
    if (!kind) refuse_to_run(argv[0]);
    const Language language = Language::load(argv[3], argv[2]).value_or(Language());
    run_worker_program(
        {WorkerKind::document, [&] { prepare(*kind, language); },
         [&](std::span<const std::byte> input) { return answer(*kind, input, language); }});
}
