#include "app/decode/page.h"

#include "app/decode/answer_parts.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

decode::AnswerHeader header_of(const Picture& picture) {
    decode::AnswerHeader header;
    header.width = static_cast<std::uint32_t>(picture.width);
    header.height = static_cast<std::uint32_t>(picture.height);
    header.reduction = static_cast<std::uint8_t>(std::lround(1.0 / picture.scale));
    return header;
}

/// What the map's bytes hold: the texts of the figures, then its own labels.
TactileMap crossing(const Page& page) {
    TactileMap map = page.told;
    std::vector<Label> texts;
    for (const Figure& figure : page.figures) texts.push_back({figure.text, {}});
    map.labels.insert(map.labels.begin(), texts.begin(), texts.end());
    return map;
}

std::vector<WordBox> all_boxes_of(const Page& page) {
    std::vector<WordBox> boxes = page.words;
    for (const Figure& figure : page.figures) boxes.push_back(figure.box);
    return boxes;
}

/// The boxes of the words come first, then those of the figures.
void take_figures(std::vector<WordBox>& boxes, std::size_t count, Page& page) {
    std::vector<Label>& labels = page.told.labels;
    const std::size_t words = boxes.size() - count;
    for (std::size_t i = 0; i < count; ++i)
        page.figures.push_back({boxes[words + i], std::move(labels[i].text)});
    labels.erase(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(count));
    boxes.resize(words);
}

}  // namespace

Result<std::vector<std::byte>> answer_of(const Result<Page>& page) {
    if (!page) return decode::refusal(page.error().line);
    decode::AnswerHeader header = header_of(page->picture);
    header.number = static_cast<std::uint16_t>(page->number);
    header.count = static_cast<std::uint16_t>(page->count);
    header.dpi = static_cast<std::uint16_t>(page->dpi);
    header.figures = static_cast<std::uint8_t>(page->figures.size());
    return decode::answer_with(header, page->picture.bgr, all_boxes_of(*page), crossing(*page));
}

Result<std::vector<std::byte>> answer_of(const Picture& picture) {
    return decode::answer_with(header_of(picture), picture.bgr, {}, {});
}

Result<Page> page_of(std::span<const std::byte> answer) {
    auto parts = decode::parts_of(answer);
    if (!parts) return tl::unexpected(parts.error());
    const decode::AnswerHeader& header = parts->header;
    if (header.kind != decode::AnswerKind::page || parts->map.labels.size() < header.figures)
        return failure("the file could not be opened safely; choose another one");
    Page page;
    page.picture.width = static_cast<int>(header.width);
    page.picture.height = static_cast<int>(header.height);
    page.picture.bgr = samples_of(parts->pixels);
    page.picture.scale = 1.0 / header.reduction;
    page.told = std::move(parts->map);
    take_figures(parts->boxes, header.figures, page);
    page.words = std::move(parts->boxes);
    page.number = header.number;
    page.count = header.count;
    page.dpi = header.dpi;
    return page;
}

}  // namespace touchline
