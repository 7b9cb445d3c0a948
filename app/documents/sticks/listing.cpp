#include "app/documents/sticks/listing.h"

#include "app/documents/decode/file_format.h"
#include "config/types/fields.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

bool is_same(std::string_view a, std::string_view b) {
    return in_small_letters(a) == in_small_letters(b);
}

/// The folders of Windows, macOS, Linux and Android.
constexpr auto folders_of_systems = std::to_array<std::string_view>(
    {"System Volume Information", "$RECYCLE.BIN", "RECYCLER", "RECYCLED", "lost+found", "__MACOSX",
     "LOST.DIR", "FOUND.000"});

/// Without its dot; empty if there is none.
std::string_view ending_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    const bool has_ending = dot != std::string_view::npos && dot > 0;
    return has_ending ? name.substr(dot + 1) : std::string_view();
}

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

/// The rest of a sentence that begins with the file or the stick.
std::string_view why(StickRefusal refusal) {
    switch (refusal) {
        case StickRefusal::gone:
            return " cannot be read because the stick was pulled out; put it in again";
        case StickRefusal::no_such_file:
            return " is no longer on the stick; choose another file";
        case StickRefusal::no_file:
            return " is only a link or a device; choose the picture itself";
        case StickRefusal::too_large:
            return " is too large; save it smaller and bring it again";
        case StickRefusal::empty:
            return " is empty; copy it to the stick again";
        case StickRefusal::unreadable:
            return " cannot be read because the stick was pulled out or is damaged; put it in "
                   "again or try another stick";
        case StickRefusal::locked:
            return " is locked for the user who saved it; copy it to a stick formatted as FAT or "
                   "exFAT";
        case StickRefusal::out_of_time:
            return " takes too long to read; put the stick in again or try another one";
        case StickRefusal::not_started:
            return " cannot be read because a part of Touchline is missing; please tell the "
                   "operator";
        case StickRefusal::out_of_memory:
            return " needs too much memory; save it smaller and bring it again";
    }
    return " cannot be read; choose another one";
}

}  // namespace

std::optional<StickFileKind> kind_of_name(std::string_view name) {
    const FormatFacts* const facts = format_ending_in(in_small_letters(ending_of(name)));
    if (facts == nullptr) return std::nullopt;
    if (facts->format == FileFormat::office) return StickFileKind::office;
    return facts->worker == WorkerKind::document ? StickFileKind::document : StickFileKind::picture;
}

std::optional<StickFileKind> operator_kind_of_name(std::string_view name) {
    const std::string_view ending = ending_of(name);
    if (is_same(ending, "zip")) return StickFileKind::pack;
    if (is_same(ending, "onnx")) return StickFileKind::network;
    if (is_same(ending, "touchline-bundle")) return StickFileKind::bundle;
    if (is_same(ending, "touchline-key")) return StickFileKind::house_key;
    return std::nullopt;
}

bool is_left_out(std::string_view name) {
    // "~$letter.docx": a program's mark that it has the letter open.
    return name.empty() || name.starts_with('.') || name.starts_with("~$") ||
           std::ranges::any_of(folders_of_systems,
                               [name](std::string_view folder) { return is_same(name, folder); });
}

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
        StickEntry& entry = listing.entries.emplace_back();
        const bool is_read = read_checked(bytes, entry, [](auto& f, auto& e) { fields(f, e); });
        if (!is_read || !is_file_name(entry.name) || !is_folder_path(entry.folder)) return wrong;
    }
    const auto flags = bytes.number<std::uint8_t>();
    if (flags > all_flags || is_whole != (flags == 0) || !bytes.is_at_end()) return wrong;
    listing.rest = rest_of(not_listed, flags);
    return listing;
}

std::string sentence_of(StickRefusal refusal, std::string_view name) {
    return (name.empty() ? "The stick" : std::string(name)).append(why(refusal));
}

}  // namespace touchline
