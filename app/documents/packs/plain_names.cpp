#include "app/documents/packs/plain_names.h"

#include "app/documents/decode/one_line.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
           c == '.' || c == '-' || c == '_';
}

bool is_plain_part(std::string_view part) {
    const auto is_open = [](char c) { return c == '.' || c == ' '; };
    return !part.empty() && std::ranges::all_of(part, is_plain) && !is_open(part.front()) &&
           !is_open(part.back());
}

/// True for a Windows drive, too.
bool leads_outside(std::string_view name) {
    if (name.starts_with('/') || name.find('\\') != std::string_view::npos) return true;
    if (name.size() >= 2 && name[1] == ':') return true;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('/', at), name.size());
        if (name.substr(at, end - at) == "..") return true;
        at = end + 1;
    }
    return false;
}

std::string_view ending_of(std::string_view name) {
    const auto dot = name.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : name.substr(dot);
}

bool begins_with(std::span<const std::byte> bytes, std::size_t at, std::string_view mark) {
    return bytes.size() >= at && as_text(bytes).substr(at).starts_with(mark);
}

/// Recognizes zip, gzip, bzip2, xz, zstd, lz4, 7z, RAR, cab, cpio, ar, lzip and tar, under any
/// name.
bool is_archive(std::span<const std::byte> bytes) {
    using namespace std::string_view_literals;
    constexpr auto marks = std::to_array<std::string_view>(
        {"PK\3\4"sv, "PK\5\6"sv, "\x1f\x8b"sv, "BZh"sv, "\xfd\x37zXZ"sv, "\x28\xb5\x2f\xfd"sv,
         "\x04\x22\x4d\x18"sv, "7z\xbc\xaf"sv, "Rar!"sv, "MSCF"sv, "07070"sv, "!<arch>"sv,
         "LZIP"sv});
    return begins_with(bytes, 257, "ustar") ||
           std::ranges::any_of(
               marks, [bytes](std::string_view mark) { return begins_with(bytes, 0, mark); });
}

/// The limit in the unit that the sentence names.
double limit_of(FindingKind kind) {
    constexpr double megabyte = 1 << 20U;
    switch (kind) {
        case FindingKind::zip_too_large:
            return static_cast<double>(pack_limits.zip_bytes) / megabyte;
        case FindingKind::too_many_files:
            return static_cast<double>(pack_limits.files);
        case FindingKind::file_too_large:
            return static_cast<double>(pack_limits.file_bytes) / megabyte;
        case FindingKind::all_too_large:
            return static_cast<double>(pack_limits.all_bytes) / megabyte;
        case FindingKind::name_too_long:
            return static_cast<double>(pack_limits.name_bytes);
        case FindingKind::too_deep:
            return static_cast<double>(pack_limits.folders);
        case FindingKind::sound_long:
            return pack_limits.sound_s;
        default:
            return 0.0;
    }
}

}  // namespace

std::optional<FindingKind> trouble_with_name(std::string_view name) {
    if (leads_outside(name)) return FindingKind::leads_outside;
    std::size_t folders = 0;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('/', at), name.size());
        if (!is_plain_part(name.substr(at, end - at))) return FindingKind::name_not_plain;
        if (end < name.size()) ++folders;
        at = end + 1;
    }
    if (name.size() > pack_limits.name_bytes) return FindingKind::name_too_long;
    if (folders > pack_limits.folders) return FindingKind::too_deep;
    return std::nullopt;
}

tl::unexpected<PackFinding> refused(FindingKind kind, const std::string& file) {
    return refusal({kind, file, 0, "", limit_of(kind)});
}

PackFileKind kind_by_name(std::string_view name) {
    const std::string ending = in_small_letters(ending_of(name));
    if (ending == ".svg") return PackFileKind::picture;
    if (ending == ".wav" || ending == ".ogg" || ending == ".oga" || ending == ".opus" ||
        ending == ".flac")
        return PackFileKind::sound;
    if (ending == ".txt" || ending == ".md") return PackFileKind::text;
    return ending == ".toml" ? PackFileKind::table : PackFileKind::other;
}

std::optional<FindingKind> trouble_with_file(std::string_view name,
                                             std::span<const std::byte> bytes) {
    if (is_archive(bytes)) return FindingKind::nested;
    const std::string_view last = name.substr(name.rfind('/') + 1);  // npos + 1 is 0
    const auto kind = kind_by_name(name);
    const bool is_other_table = kind == PackFileKind::table && last != "pack.toml";
    if (kind == PackFileKind::other || is_other_table) return FindingKind::odd_kind;
    return std::nullopt;
}

bool is_litter(std::string_view name) {
    const std::string_view last = name.substr(name.rfind('/') + 1);  // npos + 1 is 0
    return name.starts_with("__MACOSX/") || last == ".DS_Store" || last == "Thumbs.db" ||
           last == "desktop.ini";
}

}  // namespace touchline
