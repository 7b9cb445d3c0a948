#include "app/decode/answer_parts.h"

#include "app/decode/one_line.h"
#include "config/types/map_bytes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace touchline::decode {
namespace {

static_assert(sizeof(WordBox) == box_bytes);

tl::unexpected<Error> unsafe() {
    return failure("the file could not be opened safely; choose another one");
}

/// Fails unless every box is inside the picture and holds a pixel.
Result<std::vector<WordBox>> boxes_in(std::span<const std::byte> bytes,
                                      const AnswerHeader& header) {
    std::vector<WordBox> boxes(all_boxes(header));
    if (!boxes.empty()) std::memcpy(boxes.data(), bytes.data(), bytes.size());
    for (const WordBox& box : boxes) {
        const bool is_inside = box.left < box.right && box.top < box.bottom &&
                               box.right <= header.width && box.bottom <= header.height;
        if (!is_inside) return unsafe();
    }
    return boxes;
}

}  // namespace

void clean_texts(TactileMap& map) {
    constexpr std::size_t longest_name = 200;
    constexpr std::size_t longest_description = 4000;
    map.title = one_spaced(map.title, longest_name);
    map.description = one_spaced(map.description, longest_description);
    for (Label& label : map.labels) label.text = one_spaced(label.text, longest_name);
    for (Outline& outline : map.outlines) outline.label = one_spaced(outline.label, longest_name);
}

Result<std::vector<std::byte>> answer_with(AnswerHeader header,
                                           std::span<const std::uint8_t> pixels,
                                           std::span<const WordBox> boxes, const TactileMap& map) {
    const auto map_bytes = bytes_of(map);
    if (!map_bytes) return map_bytes;
    header.boxes = static_cast<std::uint16_t>(boxes.size() - header.figures);
    header.map_bytes = static_cast<std::uint32_t>(map_bytes->size());
    const AnswerHeaderBytes first = bytes_of(header);
    std::vector<std::byte> answer;
    answer.reserve(first.size() + pixels.size() + boxes.size_bytes() + map_bytes->size());
    const auto append = [&answer](std::span<const std::byte> bytes) {
        answer.insert(answer.end(), bytes.begin(), bytes.end());
    };
    append(first);
    append(std::as_bytes(pixels));
    append(std::as_bytes(boxes));
    append(*map_bytes);
    return answer;
}

Result<std::vector<std::byte>> refusal(const std::string& line) {
    TactileMap map;
    map.description = line;
    return answer_with({.kind = AnswerKind::refusal}, {}, {}, map);
}

Result<AnswerParts> parts_of(std::span<const std::byte> answer) {
    AnswerHeaderBytes first{};
    if (answer.size() < first.size()) return unsafe();
    std::copy_n(answer.begin(), first.size(), first.begin());
    const auto header = verified(Untrusted(first), answer.size());
    if (!header) return tl::unexpected(header.error());
    const auto pixels = answer.subspan(first.size(), pixel_bytes(*header));
    const auto boxes = answer.subspan(first.size() + pixels.size(), box_bytes * all_boxes(*header));
    auto found = boxes_in(boxes, *header);
    auto map = map_of(answer.last(header->map_bytes));
    if (!map || !found) return unsafe();
    if (header->kind == AnswerKind::refusal)
        return failure(map->description.empty() ? "the file cannot be opened"
                                                : one_line(map->description));
    clean_texts(*map);
    return AnswerParts{*header, pixels, std::move(*found), std::move(*map)};
}

}  // namespace touchline::decode
