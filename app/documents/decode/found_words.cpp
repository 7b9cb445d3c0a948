#include "app/documents/decode/found_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

struct Words {
    WrittenLanguage language;
    std::string_view iso;
    std::string_view code;
    std::string_view name;
};

constexpr std::array all{Words{WrittenLanguage::english, "en", "eng", "English"},
                         Words{WrittenLanguage::german, "de", "deu", "German"},
                         Words{WrittenLanguage::french, "fr", "fra", "French"},
                         Words{WrittenLanguage::spanish, "es", "spa", "Spanish"},
                         Words{WrittenLanguage::italian, "it", "ita", "Italian"}};

bool is_within(const Position& place, const Area& area) {
    return std::abs(place.x) <= area.width_m / 2.0 && std::abs(place.y) <= area.height_m / 2.0;
}

bool is_of_words(const TactileMap& map, std::size_t words) {
    return map.outlines.empty() && map.labels.size() <= words &&
           std::ranges::all_of(map.labels, [&map](const Label& label) {
               return is_within(label.place, map.area) && !label.text.empty();
           });
}

}  // namespace

std::string_view name_of(WrittenLanguage language) {
    return all[static_cast<std::size_t>(language)].name;
}

WrittenLanguage written_language(std::string_view code) {
    const auto* const found = std::ranges::find(all, code, &Words::iso);
    return found == all.end() ? WrittenLanguage::english : found->language;
}

std::string_view code_of(WrittenLanguage language) {
    return all[static_cast<std::size_t>(language)].code;
}

std::vector<std::string> arguments_of(const ReadingOrder& order) {
    std::vector<std::string> arguments;
    for (const WrittenLanguage language : order.languages)
        arguments.emplace_back(code_of(language));
    return arguments;
}

Result<ReadingOrder> reading_order_in(std::span<const std::string> arguments) {
    ReadingOrder order{{}};
    for (const std::string& argument : arguments) {
        const auto* const found = std::ranges::find(all, argument, &Words::code);
        if (found == all.end() || std::ranges::count(order.languages, found->language) > 0)
            return failure("not what the kiosk starts it with");
        order.languages.push_back(found->language);
    }
    if (order.languages.empty()) return failure("not what the kiosk starts it with");
    return order;
}

bool needs_reading(const Page& page) {
    return !page.picture.bgr.empty() && page.words.empty() && page.told.outlines.empty();
}

Page with_words(Page page, const FoundWords& found) {
    const bool is_of_this_page =
        found.width == page.picture.width && found.height == page.picture.height;
    if (!needs_reading(page) || !is_of_this_page) return page;
    const double scale_x = page.told.area.width_m / found.area.width_m;
    const double scale_y = page.told.area.height_m / found.area.height_m;
    for (const Label& label : found.labels)
        page.told.labels.push_back(
            {label.text, {scale_x * label.place.x, scale_y * label.place.y}});
    page.words = found.boxes;
    page.answer.reset();
    return page;
}

Result<std::vector<std::byte>> answer_of(const Result<FoundWords>& found) {
    if (!found) return decode::refusal(found.error().line);
    decode::AnswerHeader header;
    header.kind = decode::AnswerKind::words;
    header.width = static_cast<std::uint32_t>(found->width);
    header.height = static_cast<std::uint32_t>(found->height);
    TactileMap map;
    map.area = found->area;
    map.labels = found->labels;
    return decode::answer_with(header, {}, found->boxes, map);
}

Result<FoundWords> words_of(std::span<const std::byte> answer, int width, int height) {
    auto parts = decode::parts_of(answer);
    if (!parts) return tl::unexpected(parts.error());
    const decode::AnswerHeader& header = parts->header;
    const bool is_of_this_picture = header.kind == decode::AnswerKind::words &&
                                    header.width == static_cast<std::uint32_t>(width) &&
                                    header.height == static_cast<std::uint32_t>(height);
    if (!is_of_this_picture || !is_of_words(parts->map, parts->boxes.size()))
        return failure("the words in the picture could not be read safely; it is shown without");
    return FoundWords{width, height, std::move(parts->boxes), parts->map.area,
                      std::move(parts->map.labels)};
}

}  // namespace touchline
