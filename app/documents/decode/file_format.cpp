#include "app/documents/decode/file_format.h"

#include "app/documents/decode/one_line.h"
#include "app/documents/decode/page.h"
#include "config/types/utf8.h"

namespace touchline {
namespace {

using Bytes = std::span<const std::byte>;

bool starts_with(Bytes bytes, std::string_view magic, std::size_t offset = 0) {
    return bytes.size() >= offset && as_text(bytes).substr(offset).starts_with(magic);
}

/// The text after declarations, comments and a DOCTYPE; an unclosed one ends the text.
std::string_view after_prologue(std::string_view text) {
    struct Part {
        std::string_view begin;
        std::string_view end;
    };

    constexpr std::array parts{Part{"<?", "?>"}, Part{"<!--", "-->"}, Part{"<!DOCTYPE", ">"}};
    for (;;) {
        const auto first = text.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos) return {};
        text.remove_prefix(first);
        const auto part = std::ranges::find_if(
            parts, [&](const Part& each) { return text.starts_with(each.begin); });
        if (part == parts.end()) return text;
        // A DOCTYPE has its declarations in brackets.
        const auto bracket = text.find('[');
        const bool has_own = part->begin == "<!DOCTYPE" && bracket < text.find('>');
        const auto from = has_own ? text.find(']', bracket) : part->begin.size();
        const auto end = from == std::string_view::npos ? from : text.find(part->end, from);
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + part->end.size());
    }
}

bool begins_an_svg(std::string_view text) {
    text = after_prologue(text);
    if (!text.starts_with('<')) return false;
    const std::string_view name = text.substr(1, text.find_first_of(" \t\r\n/>") - 1);
    return name == "svg" || name.ends_with(":svg");
}

bool is_svg(Bytes bytes) {
    constexpr std::size_t prologue_bytes = std::size_t{1} << 20U;  // with comments
    std::string_view text = as_text(bytes).substr(0, prologue_bytes);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {  // UTF-16
        std::string narrow(text.substr(2));
        std::erase(narrow, '\0');
        return begins_an_svg(narrow);
    }
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return begins_an_svg(text);
}

/// ISO 14496-12: the first box lists the brands of readers that can read the file.
bool is_heif(Bytes bytes) {
    if (!starts_with(bytes, "ftyp", 4)) return false;
    const std::string_view text = as_text(bytes).substr(0, 64);
    for (const std::string_view brand :
         {"heic", "heix", "heim", "heis", "hevc", "mif1", "msf1", "avif", "avis"})
        if (text.find(brand, 8) != std::string_view::npos) return true;
    return false;
}

bool is_pnm(Bytes bytes) {
    return bytes.size() > 2 && bytes[0] == std::byte{'P'} && bytes[1] >= std::byte{'1'} &&
           bytes[1] <= std::byte{'6'} &&
           std::string_view(" \t\r\n").find(static_cast<char>(bytes[2])) != std::string_view::npos;
}

/// The picture's header tells its own length, from 12 to 124 bytes. Nothing else is certain: OS/2
/// writes a pointer's hot spot where others have zeros.
bool is_bmp(Bytes bytes) {
    if (starts_with(bytes, "BA")) return bytes.size() > 14 && is_bmp(bytes.subspan(14));
    const auto begins = [bytes](std::string_view kind) { return starts_with(bytes, kind); };
    constexpr std::array<std::string_view, 5> kinds{"BM", "IC", "PT", "CI", "CP"};
    if (bytes.size() < 18 || std::ranges::none_of(kinds, begins)) return false;
    const auto size = std::to_integer<unsigned>(bytes[14]);
    return size >= 12 && size <= 124 && starts_with(bytes, std::string_view("\0\0\0", 3), 15);
}

/// A mail program may put some bytes before PDF's first line.
bool is_pdf(Bytes bytes) {
    return as_text(bytes).substr(0, 1024).find("%PDF-") != std::string_view::npos;
}

/// A ZIP of an office program lists its own parts first.
FileFormat packed_format(Bytes bytes) {
    const std::string_view text = as_text(bytes).substr(0, 256);
    for (const std::string_view part :
         {"[Content_Types].xml", "_rels/.rels", "mimetypeapplication/vnd.oasis", "docProps/"})
        if (text.find(part) != std::string_view::npos) return FileFormat::office;
    return FileFormat::archive;
}

constexpr int least_dpi = 30;
constexpr int most_dpi = 600;

/// Its signs alone decide, for any text of these is a tag. BCP 47 has none that needs more than 35.
bool is_language_tag(std::string_view text) {
    constexpr std::size_t most_signs = 35;
    return text.size() <= most_signs && std::ranges::all_of(text, [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-';
           });
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
    if (starts_with(bytes, "GIF87a"sv) || starts_with(bytes, "GIF89a"sv)) return FileFormat::gif;
    if (is_heif(bytes)) return FileFormat::heif;
    if (is_pnm(bytes)) return FileFormat::pnm;
    if (is_bmp(bytes)) return FileFormat::bmp;
    if (starts_with(bytes, "PK\3\4"sv)) return packed_format(bytes);
    if (starts_with(bytes, "\xd0\xcf\x11\xe0"sv) || starts_with(bytes, "{\\rtf"sv))
        return FileFormat::office;
    if (starts_with(bytes, "Rar!"sv) || starts_with(bytes, "7z\xbc\xaf"sv))
        return FileFormat::archive;
    // No other format of the kiosk is packed so; the worker looks inside.
    if (starts_with(bytes, "\x1f\x8b"sv)) return FileFormat::svg;
    if (is_pdf(bytes)) return FileFormat::pdf;
    return is_svg(bytes) ? FileFormat::svg : FileFormat::unknown;
}

WorkerKind kind_of(std::span<const std::byte> bytes) {
    const auto* const found =
        std::ranges::find(file_formats, format_of(bytes), &FormatFacts::format);
    return found == file_formats.end() ? WorkerKind::raster : found->worker;
}

std::string program_for(WorkerKind kind) {
    switch (kind) {
        case WorkerKind::document:
            return "touchline-decode-document";
        case WorkerKind::heif:
            return "touchline-decode-heif";
        default:
            return "touchline-decode";
    }
}

std::vector<std::string> arguments_of(const DecodeWork& work) {
    return {std::to_string(static_cast<int>(work.kind)), std::to_string(work.order.page),
            std::to_string(work.order.dpi), work.order.language.text};
}

Result<DecodeWork> work_in(std::span<const std::string> arguments) {
    const auto wrong = failure("not what the kiosk starts it with");
    if (arguments.size() != 4) return wrong;
    const auto kind = number_in(arguments[0], 0, worker_kind_count - 1);
    const auto page = number_in(arguments[1], 1, max_pages);
    const auto dpi = number_in(arguments[2], least_dpi, most_dpi);
    if (!kind || !page || !dpi || !is_language_tag(arguments[3])) return wrong;
    return DecodeWork{static_cast<WorkerKind>(*kind), {*page, *dpi, {arguments[3]}}};
}

}  // namespace touchline
