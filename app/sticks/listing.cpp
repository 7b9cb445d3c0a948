#include "app/sticks/listing.h"

#include <algorithm>
#include <optional>

namespace touchline {
namespace {

// mark u32, not_listed u32, is_whole u8, entries u16; an entry: kind u8, folder and name, each as
// u16 and bytes. Little-endian.
constexpr std::uint32_t mark = 0x314c5354;  // "TSL1"

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
    if (!is_file_name(*name) || !(folder->empty() || is_file_name(*folder))) return std::nullopt;
    return StickEntry{static_cast<StickFileKind>(*kind), std::move(*folder), std::move(*name)};
}

}  // namespace

bool is_file_name(std::string_view name) {
    using namespace std::string_view_literals;
    return !name.empty() && name.size() <= longest_name_bytes && name != "." && name != ".." &&
           name.find_first_of("/\0"sv) == std::string_view::npos;
}

std::vector<std::byte> bytes_of(const StickListing& listing) {
    std::vector<std::byte> bytes;
    put(bytes, mark, 4);
    put(bytes, listing.not_listed, 4);
    put(bytes, listing.is_whole ? 1 : 0, 1);
    put(bytes, static_cast<std::uint32_t>(listing.entries.size()), 2);
    for (const StickEntry& entry : listing.entries) {
        put(bytes, static_cast<std::uint32_t>(entry.kind), 1);
        put(bytes, entry.folder);
        put(bytes, entry.name);
    }
    return bytes;
}

Result<StickListing> listing_of(std::span<const std::byte> bytes) {
    const auto wrong = failure("the list of the stick's files cannot be understood");
    Taker taker(bytes);
    if (taker.number(4) != mark) return wrong;
    const auto not_listed = taker.number(4);
    const auto is_whole = taker.number(1);
    const auto count = taker.number(2);
    if (!not_listed || !is_whole || *is_whole > 1 || !count || *count > most_listed) return wrong;
    StickListing listing{{}, *not_listed, *is_whole == 1};
    for (std::uint32_t i = 0; i < *count; ++i) {
        auto entry = take_entry(taker);
        if (!entry) return wrong;
        listing.entries.push_back(std::move(*entry));
    }
    if (!taker.is_at_end()) return wrong;
    return listing;
}

std::string remainder_sentence(const StickListing& listing) {
    const std::string rest = listing.is_whole ? "" : ", and not every folder was looked into";
    if (listing.not_listed > 0) {
        return "Of " + std::to_string(listing.entries.size() + listing.not_listed) +
               " files the first " + std::to_string(listing.entries.size()) + " are listed" + rest +
               "; for another one, bring it on a stick with fewer files";
    }
    if (listing.is_whole) return "";
    return "Not every folder of the stick was looked into; for another file, put it outside of all "
           "folders";
}

std::string nothing_sentence(const StickListing& listing) {
    if (!listing.entries.empty()) return "";
    return "There is no picture or PDF on the stick that can be found; put some outside of all "
           "folders, or in folders that lie in no other";
}

}  // namespace touchline
