#include "app/decode/signature.h"

#include <algorithm>
#include <string_view>

namespace touchline {
namespace {

using Bytes = std::span<const std::byte>;

bool starts_with(Bytes bytes, std::string_view magic, std::size_t offset = 0) {
    if (bytes.size() < offset + magic.size()) return false;
    return std::equal(magic.begin(), magic.end(), bytes.begin() + static_cast<long>(offset),
                      [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

bool is_svg(Bytes bytes) {
    constexpr std::size_t prologue_bytes = 4096;  // declaration, DOCTYPE, comments
    const auto head = bytes.first(std::min(bytes.size(), prologue_bytes));
    std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '<') return false;
    return text.find("<svg") != std::string_view::npos ||
           text.find(":svg") != std::string_view::npos;
}

}  // namespace

FileFormat format_of(Bytes bytes) {
    using namespace std::string_view_literals;
    if (starts_with(bytes, "\x89PNG\r\n\x1a\n"sv)) return FileFormat::png;
    if (starts_with(bytes, "\xff\xd8\xff"sv)) return FileFormat::jpeg;
    if (starts_with(bytes, "RIFF"sv) && starts_with(bytes, "WEBP"sv, 8)) return FileFormat::webp;
    for (const auto magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (starts_with(bytes, magic)) return FileFormat::tiff;
    }
    return is_svg(bytes) ? FileFormat::svg : FileFormat::unknown;
}

}  // namespace touchline
