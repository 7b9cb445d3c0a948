#include "app/cli/commands.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/sheets/braille_sheet.h"
#include "app/sheets/sheet_drawing.h"
#include "app/sheets/sheet_layout.h"
#include "app/sheets/sheet_words.h"
#include "app/sound/catalogues.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::array<std::pair<std::string_view, SheetFormat>, 5> sheet_endings{
    {{".pdf", SheetFormat::pdf},
     {".svg", SheetFormat::svg},
     {".brf", SheetFormat::brf},
     {".ubrl", SheetFormat::ubrl},
     {".index", SheetFormat::index}}};

/// The map that is printed, and a note for the user.
struct PrintedMap {
    TactileMap map;
    std::string note;
};

Result<PrintedMap> printed_map(const PrintCommandOptions& options, const Language& language) {
    const auto seen = open_view(options.input, options.view, false, {options.language});
    if (!seen) return tl::unexpected(seen.error());
    auto traced = trace_view(*seen, {options.trace});
    if (!traced) return tl::unexpected(traced.error());
    PrintedMap printed{named_for_paper(std::move(traced->map), language),
                       seen->note.empty() ? traced->warning : seen->note};
    const bool is_whole = options.view.kind == ViewChoice::Kind::first ||
                          options.view.kind == ViewChoice::Kind::whole;
    if (printed.map.description.empty() && seen->things && is_whole)
        printed.map.description = words_of(std::span(seen->things->names), language);
    if (printed.map.title.empty())
        printed.map.title = plain_line(std::filesystem::path(options.input).stem().string());
    return printed;
}

std::string note_of(std::size_t lacking, const std::string& language) {
    return fmt::format(
        "question marks stand for {} that the braille of the language {} lacks; choose another "
        "--language or change the words",
        lacking == 1 ? "one sign" : fmt::format("{} signs", lacking), language);
}

/// The file's bytes.
Result<std::vector<std::byte>> sheet_of(const TactileMap& map, const PrintCommandOptions& options,
                                        const Language& language) {
    const BrailleHand hand{options.language, options.grade};
    switch (*sheet_format_of(options.output)) {
        case SheetFormat::pdf:
            return tactile_sheet(map, {options.paper, hand}, language)
                .and_then([&map](const TactileSheet& sheet) { return pdf_of(sheet, map.title); });
        case SheetFormat::svg:
            return tactile_sheet(map, {options.paper, hand}, language)
                .and_then([](const TactileSheet& sheet) { return svg_of(sheet.pages.front()); });
        case SheetFormat::brf:
            return brf_sheet(map, hand, language).map(file_bytes);
        case SheetFormat::ubrl:
            return dots_of(map, graphic_lattice(options.paper)).map([](const DotPicture& dots) {
                return file_bytes(ubrl_of(dots));
            });
        case SheetFormat::index: {
            const auto words = word_pages(map, hand, language);
            if (!words) return tl::unexpected(words.error());
            return dots_of(map, graphic_lattice(options.paper)).map([&](const DotPicture& dots) {
                return file_bytes(index_of(*words, dots));
            });
        }
    }
    return failure("this kind of sheet is not known");
}

}  // namespace

std::optional<SheetFormat> sheet_format_of(const std::string& path) {
    const std::string name = in_small_letters(path);
    for (const auto& [ending, format] : sheet_endings)
        if (name.size() > ending.size() && name.ends_with(ending)) return format;
    return std::nullopt;
}

Result<std::string> run_print(const PrintCommandOptions& options) {
    if (!sheet_format_of(options.output))
        return failure(options.output +
                       ": is no sheet; let its name end in .pdf, .svg, .brf, .ubrl or .index");
    const auto language = Language::load(words_folder().string(), options.language);
    if (!language)
        return failure(
            fmt::format("there are no words in the language {}; 'touchline print' "
                        "writes in en, de, es, fr and it",
                        options.language));
    const auto printed = printed_map(options, *language);
    if (!printed) return tl::unexpected(printed.error());
    const auto lacking = signs_without_braille(printed->map, {options.language, options.grade});
    if (!lacking) return failure(options.input + ": " + lacking.error().line);
    const auto bytes = sheet_of(printed->map, options, *language);
    if (!bytes) return failure(options.input + ": " + bytes.error().line);
    return write_whole_file(options.output, *bytes).map([&] {
        return *lacking > 0 ? note_of(*lacking, options.language) : printed->note;
    });
}

}  // namespace touchline
