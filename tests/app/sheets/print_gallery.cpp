// Every picture of the gallery as a sheet, for people to look at, and what it could not show:
//   print_gallery FOLDER [LANGUAGE [a4|letter]]
#include "app/documents/decode/files.h"
#include "app/sheets/braille_sheet.h"
#include "app/sheets/sheet_drawing.h"
#include "app/sheets/sheet_layout.h"
#include "app/sheets/sheet_words.h"
#include "tests/app/documents/gallery/pictures.h"

#include <cstdio>
#include <ctime>

namespace touchline {
namespace {

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

/// How often a line interrupts a leader.
std::size_t breaks_of(const PaperPage& page) {
    const auto is_piece = [](const SheetStroke& stroke) {
        return stroke.use == StrokeUse::leader && stroke.points.size() > 1;
    };
    std::size_t breaks = 0;
    for (std::size_t i = 1; i < page.strokes.size(); ++i)
        if (is_piece(page.strokes[i]) && is_piece(page.strokes[i - 1]) &&
            page.strokes[i].source == page.strokes[i - 1].source)
            ++breaks;
    return breaks;
}

int print_all(const std::string& folder, const std::string& code, PaperKind paper) {
    const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
    const SheetOrder order{paper, {code, BrailleGrade::uncontracted}};
    for (const ShippedPicture& picture : shipped_pictures({code})) {
        const std::clock_t begin = std::clock();  // other programs do not count
        const TactileSheet sheet = tactile_sheet(picture.map, order, language).value();
        const double took_ms = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        std::printf(
            "%-22s %5.0f ms  scale %.2f  %2zu parts, %zu breaks of leaders, without a name: %s; "
            "left "
            "out: %s\n",
            picture.name.c_str(), took_ms, sheet.scale, named_parts(picture.map).size(),
            breaks_of(sheet.pages.front()), listed(sheet.unlabelled).c_str(),
            listed(sheet.left_out).c_str());
        const std::string name = folder + "/" + picture.name;
        const auto pdf = pdf_of(sheet, picture.map.title).value();
        auto pages = word_pages(picture.map, order.hand, language).value();
        const auto drawing = drawing_pages(picture.map, order.hand).value();
        pages.insert(pages.end(), drawing.begin(), drawing.end());
        if (!write_whole_file(name + ".pdf", pdf) ||
            !write_whole_file(name + ".brf", brf_of(pages)))
            return 1;
    }
    return 0;
}

}  // namespace
}  // namespace touchline

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) return 2;
    const bool is_letter = words.size() > 2 && words[2] == "letter";
    return touchline::print_all(
        words[0], words.size() > 1 ? words[1] : "en",
        is_letter ? touchline::PaperKind::letter : touchline::PaperKind::a4);
}
