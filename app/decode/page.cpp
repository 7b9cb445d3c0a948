#include "app/decode/page.h"

#include "app/decode/answer_parts.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

AnswerHeader header_of(const Picture& picture) {
    AnswerHeader header;
    header.width = static_cast<std::uint32_t>(picture.width);
    header.height = static_cast<std::uint32_t>(picture.height);
    header.reduction = static_cast<int>(std::lround(1.0 / picture.scale));
    return header;
}

}  // namespace

Result<std::vector<std::byte>> answer_of(const Result<Page>& page) {
    if (!page) return decode::refusal(page.error().line);
    AnswerHeader header = header_of(page->picture);
    header.number = page->number;
    header.count = page->count;
    header.dpi = page->dpi;
    return decode::answer_with(header, page->picture.bgr, page->words, page->told);
}

Result<std::vector<std::byte>> answer_of(const Picture& picture) {
    return decode::answer_with(header_of(picture), picture.bgr, {}, {});
}

Result<Page> page_of(std::span<const std::byte> answer) {
    auto parts = decode::parts_of(answer);
    if (!parts) return tl::unexpected(parts.error());
    const AnswerHeader& header = parts->header;
    if (header.kind != AnswerKind::page)
        return failure("the file could not be opened safely; choose another one");
    Page page;
    page.picture.width = static_cast<int>(header.width);
    page.picture.height = static_cast<int>(header.height);
    const auto* const first_pixel = reinterpret_cast<const std::uint8_t*>(parts->pixels.data());
    page.picture.bgr.assign(first_pixel, first_pixel + parts->pixels.size());
    page.picture.scale = 1.0 / header.reduction;
    page.told = std::move(parts->map);
    page.words = std::move(parts->boxes);
    page.number = header.number;
    page.count = header.count;
    page.dpi = header.dpi;
    return page;
}

}  // namespace touchline
