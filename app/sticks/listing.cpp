#include "app/sticks/listing.h"

#include "config/types/fields.h"

#include <utility>

namespace touchline {
namespace {

// mark u32, not_listed u32, is_whole u8 (every folder was looked into), entries u16; an entry: kind
// u8, folder and name, each as u16 and bytes; last the reasons why it is not whole, u8. All
// little-endian.
constexpr std::uint32_t mark = 0x314c5354;  // "TSL1"

constexpr std::uint8_t deeper_flag = 1;
constexpr std::uint8_t unreadable_flag = 2;
constexpr std::uint8_t cut_short_flag = 4;
constexpr std::uint8_t all_flags = deeper_flag | unreadable_flag | cut_short_flag;

constexpr std::size_t longest_path_bytes = 4095;

template <class Fields, class Entry>
void fields(Fields& f, Entry& entry) {
    f.choice(entry.kind, static_cast<StickFileKind>(stick_file_kind_count - 1));
    f.template text<std::uint16_t>(entry.folder);
    f.template text<std::uint16_t>(entry.name);
}

StickRest rest_of(std::uint32_t not_listed, std::uint8_t flags) {
    return {not_listed, (flags & deeper_flag) != 0, (flags & unreadable_flag) != 0,
            (flags & cut_short_flag) != 0};
}

std::uint8_t flags_of(const StickRest& rest) {
    return static_cast<std::uint8_t>((rest.has_deeper ? deeper_flag : 0) |
                                     (rest.has_unreadable ? unreadable_flag : 0) |
                                     (rest.is_cut_short ? cut_short_flag : 0));
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
    const std::uint8_t flags = flags_of(listing.rest);
    ByteWriter bytes;
    bytes.number(mark);
    bytes.number(listing.rest.not_listed);
    bytes.flag(flags == 0);
    bytes.number(static_cast<std::uint16_t>(listing.entries.size()));
    for (const StickEntry& entry : listing.entries) fields(bytes, entry);
    bytes.number(flags);
    return bytes.take();
}

Result<StickListing> listing_of(std::span<const std::byte> all) {
    const auto wrong = failure("the list of the stick's files cannot be understood");
    ByteReader bytes(all);
    if (bytes.number<std::uint32_t>() != mark) return wrong;
    StickListing listing;
    const auto not_listed = bytes.number<std::uint32_t>();
    bool is_whole = false;
    bytes.flag(is_whole);
    const auto count = bytes.number<std::uint16_t>();
    if (count > most_listed) return wrong;
    for (int i = 0; i < count; ++i) {
        StickEntry entry;
        fields(bytes, entry);
        if (!bytes.is_good() || !is_file_name(entry.name) || !is_folder_path(entry.folder))
            return wrong;
        listing.entries.push_back(std::move(entry));
    }
    const auto flags = bytes.number<std::uint8_t>();
    if (flags > all_flags || is_whole != (flags == 0) || !bytes.is_at_end()) return wrong;
    listing.rest = rest_of(not_listed, flags);
    return listing;
}

}  // namespace touchline
