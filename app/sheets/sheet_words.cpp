#include "app/sheets/sheet_words.h"

#include "audio-cues/cues/guidance.h"
#include "audio-cues/words/part_name.h"
#include "config/types/extent.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

/// The middle of the box around these outlines.
Position middle_of(const TactileMap& map, const std::vector<std::size_t>& outlines) {
    Extent extent;
    for (const std::size_t i : outlines) extent.add(map.outlines[i]);
    return extent.middle();
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

}  // namespace

TactileMap named_for_paper(TactileMap map, const Language& language) {
    std::map<std::string, int> counts;
    for (Outline& outline : map.outlines) {
        const auto traced = traced_name(outline.label);
        if (!traced) {
            outline.label = part_name(outline.label, language);
        } else if (traced->kind == "line" || traced->kind == "closed line") {
            outline.label.clear();
        } else {
            std::string name = language.text("part", traced->kind);
            const int number = ++counts[name];
            if (number > 1) name += fmt::format(" {}", number);
            outline.label = std::move(name);
        }
    }
    return map;
}

std::vector<NamedPart> named_parts(const TactileMap& map) {
    std::vector<NamedPart> parts;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const std::string& name = map.outlines[i].label;
        if (name.empty()) continue;
        const auto known = std::ranges::find(parts, name, &NamedPart::name);
        if (known != parts.end()) {
            known->outlines.push_back(i);
        } else {
            parts.push_back({name, {i}, {}});
        }
    }
    for (NamedPart& part : parts) part.place = middle_of(map, part.outlines);
    const std::size_t lines = parts.size();
    const auto names_a_line = [&](const std::string& text) {
        const auto end = parts.begin() + static_cast<std::ptrdiff_t>(lines);
        return std::ranges::find(parts.begin(), end, text, &NamedPart::name) != end;
    };
    for (const Label& label : map.labels)
        if (!label.text.empty() && !names_a_line(label.text))
            parts.push_back({label.text, {}, label.place});
    if (parts.size() == 1 && !parts.front().outlines.empty() && !map.title.empty()) parts.clear();
    return parts;
}

Result<void> check_parts(const TactileMap& map) {
    const std::size_t count = named_parts(map).size();
    if (count <= most_sheet_parts) return {};
    return failure(
        fmt::format("it has {} parts with a name, and a sheet holds {}; choose a lower detail, or "
                    "another picture",
                    count, most_sheet_parts));
}

Result<std::size_t> signs_without_braille(const TactileMap& map, const BrailleHand& hand) {
    std::string texts = map.title + ' ' + map.description;
    for (const NamedPart& part : named_parts(map)) texts += ' ' + part.name;
    return braille_of(texts, hand.language, hand.grade).map([](const BrailleText& braille) {
        return braille.question_marks;
    });
}

std::string scale_words(double scale, const Language& language) {
    constexpr double bar_cm = 2.0;
    return language.text("sheet", "2 cm are {0} cm at the kiosk.",
                         {language.number(bar_cm / scale, 1)});
}

std::string up_words(const Language& language) {
    return language.text("sheet", "This side up.");
}

std::vector<SheetParagraph> paragraphs_of(const TactileMap& map, const SheetChanges& changes,
                                          const Language& language) {
    std::vector<SheetParagraph> told{{ParagraphKind::title, map.title}};
    const auto tell = [&told](ParagraphKind kind, std::string words) {
        told.push_back({kind, std::move(words)});
    };
    if (!map.description.empty()) tell(ParagraphKind::text, map.description);
    const CueArea area{map.area.width_m / 2.0, map.area.height_m / 2.0};
    const std::vector<NamedPart> parts = named_parts(map);
    if (!parts.empty()) tell(ParagraphKind::text, language.text("sheet", "The parts:"));
    for (const NamedPart& part : parts)
        tell(ParagraphKind::item,
             part.name + ": " + words_of(place_of(part.place, area), language));
    if (!changes.left_out.empty())
        tell(ParagraphKind::text, language.text("sheet", "Left out, at least in places: {0}.",
                                                {listed(changes.left_out)}));
    if (!changes.unlabelled.empty())
        tell(ParagraphKind::text, language.text("sheet", "On the sheet without a name: {0}.",
                                                {listed(changes.unlabelled)}));
    if (changes.scale > 0.0) tell(ParagraphKind::text, scale_words(changes.scale, language));
    std::erase_if(told, [](const SheetParagraph& each) { return each.words.empty(); });
    return told;
}

Result<std::vector<BrailleCells>> braille_lines(const std::vector<SheetParagraph>& paragraphs,
                                                std::size_t width, const BrailleHand& hand) {
    constexpr std::size_t indent = 2;
    std::vector<BrailleCells> lines;
    for (const SheetParagraph& paragraph : paragraphs) {
        const auto cells = cells_of(paragraph.words, hand);
        if (!cells) return tl::unexpected(cells.error());
        const bool is_title = paragraph.kind == ParagraphKind::title;
        const bool is_text = paragraph.kind == ParagraphKind::text;
        auto made = wrapped(*cells, width, is_text ? indent : 0,
                            paragraph.kind == ParagraphKind::item ? indent : 0);
        if (is_title)
            for (BrailleCells& line : made)
                line.insert(line.begin(), (width - line.size()) / 2, std::uint8_t{0});
        std::ranges::move(made, std::back_inserter(lines));
        if (is_title) lines.emplace_back();
    }
    return lines;
}

}  // namespace touchline
