// Zip files, read and written by libarchive; the list at the end of one is read by hand before
// anything is unpacked.
#include "app/documents/decode/one_line.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpack_work.h"
#include "app/isolation/process/descriptor.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

#include <archive.h>
#include <archive_entry.h>

namespace touchline {
namespace {

constexpr std::uint32_t local_mark = 0x04034b50;
constexpr std::uint32_t member_mark = 0x02014b50;
constexpr std::uint32_t end_mark = 0x06054b50;
constexpr std::size_t end_bytes = 22;
constexpr std::size_t member_bytes = 46;
constexpr std::size_t longest_comment = 65535;

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
    member.name = as_text(list.subspan(at + member_bytes, name_bytes));
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

using Archive = Owned<archive, archive_free>;

/// Exactly the bytes that the list claims: one more is a lie, and the beginning of a zip bomb.
PackResult<std::vector<std::byte>> contents(archive* opened, const ZipMember& member) {
    std::vector<std::byte> bytes(member.bytes);
    std::size_t got = 0;
    while (got < bytes.size()) {
        const auto count = archive_read_data(opened, bytes.data() + got, bytes.size() - got);
        if (count <= 0) return refusal({FindingKind::damaged_zip, member.name});
        got += static_cast<std::size_t>(count);
    }
    // The checksum is compared where the bytes end.
    std::byte more{};
    if (archive_read_data(opened, &more, 1) != 0)
        return refusal({FindingKind::damaged_zip, member.name});
    return bytes;
}

/// Removes the names of members that were read from `wanted`.
PackResult<std::vector<PackFile>> read_members(archive* opened,
                                               std::map<std::string, ZipMember>& wanted) {
    std::vector<PackFile> files;
    archive_entry* entry = nullptr;
    for (;;) {
        const int status = archive_read_next_header(opened, &entry);
        if (status == ARCHIVE_EOF) return files;
        if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
            return refusal({FindingKind::damaged_zip});
        const char* const name = archive_entry_pathname(entry);
        const auto found = name == nullptr ? wanted.end() : wanted.find(name);
        if (found == wanted.end()) continue;
        if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_is_encrypted(entry) != 0)
            return refusal({FindingKind::no_file, found->first});
        auto bytes = contents(opened, found->second);
        if (!bytes) return refusal(bytes.error());
        files.push_back({found->first, std::move(*bytes)});
        wanted.erase(found);
    }
}

la_ssize_t append(archive* /*made*/, void* to, const void* from, std::size_t count) {
    auto& zip = *static_cast<std::vector<std::byte>*>(to);
    const auto* const first = static_cast<const std::byte*>(from);
    zip.insert(zip.end(), first, first + count);
    return static_cast<la_ssize_t>(count);
}

bool write_member(archive* made, const PackFile& file) {
    const Owned<archive_entry, archive_entry_free> entry(archive_entry_new());
    if (!entry) return false;
    archive_entry_set_pathname(entry.get(), file.name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.bytes.size()));
    return archive_write_header(made, entry.get()) == ARCHIVE_OK &&
           archive_write_data(made, file.bytes.data(), file.bytes.size()) ==
               static_cast<la_ssize_t>(file.bytes.size());
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
        if (++names[in_small_letters(member->name)] > 1)
            return refused(FindingKind::twice, member->name);
        members.push_back({member->name, member->bytes});
    }
    if (at != list.size()) return refused(FindingKind::damaged_zip);
    if (members.size() > pack_limits.files) return refused(FindingKind::too_many_files);
    return members;
}

PackResult<std::vector<PackFile>> files_in_zip(std::span<const std::byte> zip) {
    const auto members = zip_members(zip);
    if (!members) return refusal(members.error());
    std::map<std::string, ZipMember> wanted;
    for (const ZipMember& member : *members) wanted.emplace(member.name, member);
    const Archive opened(archive_read_new());
    const bool is_open =
        opened != nullptr && archive_read_support_format_zip_seekable(opened.get()) == ARCHIVE_OK &&
        archive_read_open_memory(opened.get(), zip.data(), zip.size()) == ARCHIVE_OK;
    if (!is_open) return refusal({FindingKind::damaged_zip});
    auto files = read_members(opened.get(), wanted);
    if (!files) return files;
    if (!wanted.empty()) return refusal({FindingKind::damaged_zip, wanted.begin()->first});
    for (const PackFile& file : *files)
        if (const auto trouble = trouble_with_file(file.name, file.bytes))
            return refusal({*trouble, file.name});
    std::ranges::sort(*files, {}, &PackFile::name);
    return files;
}

PackResult<std::vector<std::byte>> zip_with(std::span<const PackFile> files) {
    constexpr std::size_t most_header_bytes = 512;  // of a member and in the list, with its name
    std::size_t most = most_header_bytes;
    for (const PackFile& file : files) most += file.bytes.size() + most_header_bytes;
    std::vector<std::byte> zip;
    zip.reserve(most);  // so that nothing is thrown through libarchive
    const Archive made(archive_write_new());
    const bool is_open =
        made != nullptr && archive_write_set_format_zip(made.get()) == ARCHIVE_OK &&
        archive_write_set_format_option(made.get(), "zip", "compression", "store") == ARCHIVE_OK &&
        archive_write_set_bytes_per_block(made.get(), 0) == ARCHIVE_OK &&
        archive_write_open(made.get(), &zip, nullptr, append, nullptr) == ARCHIVE_OK;
    const bool is_whole =
        is_open &&
        std::ranges::all_of(
            files, [&made](const PackFile& file) { return write_member(made.get(), file); }) &&
        archive_write_close(made.get()) == ARCHIVE_OK;
    if (!is_whole) return refusal({FindingKind::no_memory});
    return zip;
}

}  // namespace touchline
