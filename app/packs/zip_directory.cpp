#include "app/packs/zip_directory.h"

#include "app/packs/pack_limits.h"
#include "app/packs/plain_names.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

namespace touchline {
namespace {

constexpr std::uint32_t local_mark = 0x04034b50;
constexpr std::uint32_t member_mark = 0x02014b50;
constexpr std::uint32_t end_mark = 0x06054b50;
constexpr std::size_t end_bytes = 22;
constexpr std::size_t member_bytes = 46;
constexpr std::size_t longest_comment = 65535;
constexpr double megabyte = 1 << 20U;

constexpr unsigned made_by_unix = 3;
constexpr unsigned made_by_mac = 19;
constexpr unsigned type_mask = 0170000;
constexpr unsigned regular = 0100000;
constexpr unsigned folder = 0040000;
constexpr unsigned symbolic_link = 0120000;
constexpr std::uint32_t dos_folder = 0x10;

template <class Number>
Number number_at(std::span<const std::byte> bytes, std::size_t at) {
    Number value{};
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
}

struct End {
    std::size_t at = 0;  // where the list begins
    std::size_t bytes = 0;
    std::size_t count = 0;
};

/// The end mark whose comment ends with the file.
std::optional<End> end_in(std::span<const std::byte> zip) {
    if (zip.size() < end_bytes) return std::nullopt;
    const std::size_t last = zip.size() - end_bytes;
    const std::size_t first = last > longest_comment ? last - longest_comment : 0;
    for (std::size_t at = last + 1; at-- > first;) {
        if (number_at<std::uint32_t>(zip, at) != end_mark ||
            at + end_bytes + number_at<std::uint16_t>(zip, at + 20) != zip.size())
            continue;
        const bool is_one_disk =
            number_at<std::uint32_t>(zip, at + 4) == 0 &&
            number_at<std::uint16_t>(zip, at + 8) == number_at<std::uint16_t>(zip, at + 10);
        const End end{number_at<std::uint32_t>(zip, at + 16),
                      number_at<std::uint32_t>(zip, at + 12),
                      number_at<std::uint16_t>(zip, at + 10)};
        if (!is_one_disk || end.at > at || end.bytes != at - end.at) return std::nullopt;
        return end;
    }
    return std::nullopt;
}

struct RawMember {
    std::string name;
    std::uint32_t bytes = 0;
    std::uint32_t packed_bytes = 0;
    std::uint32_t local_at = 0;
    std::uint16_t flags = 0;
    std::uint32_t attributes = 0;
    unsigned made_by = 0;
};

/// Reads the part of the list at `at`, and moves `at` on.
std::optional<RawMember> take_member(std::span<const std::byte> list, std::size_t& at) {
    if (list.size() - at < member_bytes || number_at<std::uint32_t>(list, at) != member_mark)
        return std::nullopt;
    const std::size_t name_bytes = number_at<std::uint16_t>(list, at + 28);
    const std::size_t tail = std::size_t{number_at<std::uint16_t>(list, at + 30)} +
                             number_at<std::uint16_t>(list, at + 32);
    if (list.size() - at - member_bytes < name_bytes + tail) return std::nullopt;
    RawMember member;
    member.made_by = number_at<std::uint16_t>(list, at + 4) >> 8U;
    member.flags = number_at<std::uint16_t>(list, at + 8);
    member.packed_bytes = number_at<std::uint32_t>(list, at + 20);
    member.bytes = number_at<std::uint32_t>(list, at + 24);
    member.attributes = number_at<std::uint32_t>(list, at + 38);
    member.local_at = number_at<std::uint32_t>(list, at + 42);
    const auto name = list.subspan(at + member_bytes, name_bytes);
    member.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
    at += member_bytes + name_bytes + tail;
    return member;
}

bool is_folder(const RawMember& member) {
    return member.name.ends_with('/') || (member.attributes & dos_folder) != 0;
}

/// The member's type by its Unix rights; 0 if it does not say.
unsigned type_of(const RawMember& member) {
    const bool is_of_unix = member.made_by == made_by_unix || member.made_by == made_by_mac;
    return is_of_unix ? (member.attributes >> 16U) & type_mask : 0;
}

std::optional<FindingKind> trouble_with(const RawMember& member) {
    constexpr unsigned locked = 1U | (1U << 6U) | (1U << 13U);  // also strongly, also the list
    if ((member.flags & locked) != 0) return FindingKind::locked;
    const unsigned type = type_of(member);
    if (type == symbolic_link) return FindingKind::link;
    if (type != 0 && type != regular && type != folder) return FindingKind::no_file;
    std::string_view name = member.name;
    if (is_folder(member) && name.ends_with('/')) name.remove_suffix(1);
    if (const auto trouble = trouble_with_name(name)) return trouble;
    if (member.bytes > pack_limits.file_bytes) return FindingKind::file_too_large;
    return std::nullopt;
}

/// The limit that the sentence mentions.
double limit_of(FindingKind kind) {
    switch (kind) {
        case FindingKind::file_too_large:
            return static_cast<double>(pack_limits.file_bytes) / megabyte;
        case FindingKind::all_too_large:
            return static_cast<double>(pack_limits.all_bytes) / megabyte;
        case FindingKind::too_many_files:
            return static_cast<double>(pack_limits.files);
        case FindingKind::name_too_long:
            return static_cast<double>(pack_limits.name_bytes);
        case FindingKind::too_deep:
            return static_cast<double>(pack_limits.folders);
        default:
            return 0.0;
    }
}

tl::unexpected<PackFinding> refused(FindingKind kind, const std::string& name = {}) {
    return refusal({kind, name, 0, "", limit_of(kind)});
}

/// Checks the member's own header, which some programs trust instead of the list.
bool is_told_alike(std::span<const std::byte> zip, const RawMember& member) {
    constexpr std::size_t local_bytes = 30;
    const std::size_t at = member.local_at;
    if (at > zip.size() || zip.size() - at < local_bytes + member.name.size()) return false;
    const auto name = zip.subspan(at + local_bytes, member.name.size());
    return number_at<std::uint32_t>(zip, at) == local_mark &&
           number_at<std::uint16_t>(zip, at + 26) == member.name.size() &&
           std::memcmp(name.data(), member.name.data(), member.name.size()) == 0;
}

}  // namespace

PackResult<std::vector<ZipMember>> zip_members(std::span<const std::byte> zip) {
    if (zip.empty()) return refused(FindingKind::empty);
    const auto end = end_in(zip);
    if (!end) {
        const bool begins_so = zip.size() >= 4 && number_at<std::uint32_t>(zip, 0) == local_mark;
        return refused(begins_so ? FindingKind::damaged_zip : FindingKind::no_zip);
    }
    // Folders and litter count, or they would be a zip bomb of their own.
    if (end->count > 2 * pack_limits.files) return refused(FindingKind::too_many_files);
    const auto list = zip.subspan(end->at, end->bytes);
    std::vector<ZipMember> members;
    std::map<std::string, int> names;
    std::uint64_t all = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < end->count; ++i) {
        const auto member = take_member(list, at);
        if (!member) return refused(FindingKind::damaged_zip);
        if (const auto trouble = trouble_with(*member); trouble && !is_litter(member->name))
            return refused(*trouble, member->name);
        if (!is_told_alike(zip, *member)) return refused(FindingKind::damaged_zip, member->name);
        all += member->bytes;
        if (all > pack_limits.all_bytes) return refused(FindingKind::all_too_large);
        if (is_folder(*member) || is_litter(member->name)) continue;
        if (++names[folded(member->name)] > 1) return refused(FindingKind::twice, member->name);
        members.push_back({member->name, member->bytes});
    }
    if (at != list.size()) return refused(FindingKind::damaged_zip);
    if (members.size() > pack_limits.files) return refused(FindingKind::too_many_files);
    return members;
}

}  // namespace touchline
