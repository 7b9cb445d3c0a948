#include "app/sticks/listing.h"

#include <algorithm>
#include <optional>

namespace touchline {
namespace {

// mark u32, not_listed u32, is_whole u8 (every folder was looked into), entries u16; an entry: kind
// u8, folder and name, each as u16 and bytes; last the reasons why it is not whole, u8. All
// little-endian.
constexpr std::uint32_t mark = 0x314c5354;  // "TSL1"

constexpr std::uint32_t deeper_flag = 1;
constexpr std::uint32_t unreadable_flag = 2;
constexpr std::uint32_t cut_short_flag = 4;
constexpr std::uint32_t all_flags = deeper_flag | unreadable_flag | cut_short_flag;

constexpr std::size_t longest_path_bytes = 4095;

void put(std::vector<std::byte>& bytes, std::uint32_t value, int width) {
    for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
}

void put(std::vector<std::byte>& bytes, std::string_view text) {
    put(bytes, static_cast<std::uint32_t>(text.size()), 2);
    const auto raw = std::as_bytes(std::span(text));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// Takes from the front; nothing once there is too little.
class Taker {
  public:
    explicit Taker(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::optional<std::uint32_t> number(std::size_t width) {
        if (bytes_.size() < width) return std::nullopt;
        std::uint32_t value = 0;
        for (std::size_t i = width; i-- > 0;)
            value = (value << 8U) | std::to_integer<std::uint32_t>(bytes_[i]);
        bytes_ = bytes_.subspan(width);
        return value;
    }

    std::optional<std::string> text() {
        const auto size = number(2);
        if (!size || *size > bytes_.size()) return std::nullopt;
        std::string value(reinterpret_cast<const char*>(bytes_.data()), *size);
        bytes_ = bytes_.subspan(*size);
        return value;
    }

    [[nodiscard]] bool is_at_end() const { return bytes_.empty(); }

  private:
    std::span<const std::byte> bytes_;
};

std::optional<StickEntry> take_entry(Taker& taker) {
    const auto kind = taker.number(1);
    auto folder = taker.text();
    auto name = taker.text();
    if (!kind || *kind >= stick_file_kind_count || !folder || !name) return std::nullopt;
    if (!is_file_name(*name) || !is_folder_path(*folder)) return std::nullopt;
    return StickEntry{static_cast<StickFileKind>(*kind), std::move(*folder), std::move(*name)};
}

StickRest rest_of(std::uint32_t not_listed, std::uint32_t flags) {
    return {not_listed, (flags & deeper_flag) != 0, (flags & unreadable_flag) != 0,
            (flags & cut_short_flag) != 0};
}

std::uint32_t flags_of(const StickRest& rest) {
    return (rest.has_deeper ? deeper_flag : 0) | (rest.has_unreadable ? unreadable_flag : 0) |
           (rest.is_cut_short ? cut_short_flag : 0);
}

}  // namespace

bool is_file_name(std::string_view name) {
    using namespace std::string_view_literals;
    return !name.empty() && name.size() <= longest_name_bytes && name != "." && name != ".." &&
           name.find_first_of("/\0"sv) == std::string_view::npos;
}

bool is_folder_path(std::string_view path) {
    if (path.empty()) return true;
    if (path.size() > longest_path_bytes) return false;
    for (std::size_t depth = 1; depth <= deepest_folder; ++depth) {
        const std::size_t end = path.find('/');
        if (!is_file_name(path.substr(0, end))) return false;
        if (end == std::string_view::npos) return true;
        path.remove_prefix(end + 1);
    }
    return false;
}

std::vector<std::byte> bytes_of(const StickListing& listing) {
    const std::uint32_t flags = flags_of(listing.rest);
    std::vector<std::byte> bytes;
    put(bytes, mark, 4);
    put(bytes, listing.rest.not_listed, 4);
    put(bytes, flags == 0 ? 1 : 0, 1);
    put(bytes, static_cast<std::uint32_t>(listing.entries.size()), 2);
    for (const StickEntry& entry : listing.entries) {
        put(bytes, static_cast<std::uint32_t>(entry.kind), 1);
        put(bytes, entry.folder);
        put(bytes, entry.name);
    }
    put(bytes, flags, 1);
    return bytes;
}

Result<StickListing> listing_of(std::span<const std::byte> bytes) {
    const auto wrong = failure("the list of the stick's files cannot be understood");
    Taker taker(bytes);
    if (taker.number(4) != mark) return wrong;
    const auto not_listed = taker.number(4);
    const auto is_whole = taker.number(1);
    const auto count = taker.number(2);
    if (!not_listed || !is_whole || !count || *count > most_listed) return wrong;
    StickListing listing;
    for (std::uint32_t i = 0; i < *count; ++i) {
        auto entry = take_entry(taker);
        if (!entry) return wrong;
        listing.entries.push_back(std::move(*entry));
    }
    const auto flags = taker.number(1);
    if (!flags || *flags > all_flags || *is_whole != (*flags == 0 ? 1U : 0U)) return wrong;
    if (!taker.is_at_end()) return wrong;
    listing.rest = rest_of(*not_listed, *flags);
    return listing;
}

}  // namespace touchline
