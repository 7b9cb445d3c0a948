#include "app/decode/svg_source.h"

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include <glib.h>
#include <zlib.h>

namespace touchline::decode {
namespace {

constexpr std::size_t most_text_bytes = std::size_t{64} << 20U;

struct Release {
    void operator()(gchar* text) const { g_free(text); }

    void operator()(z_stream* stream) const { inflateEnd(stream); }
};

bool is_packed(Bytes bytes) {
    return bytes.size() > 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

Result<std::string> unpacked(Bytes bytes) {
    constexpr int gzip = 15 + 16;  // zlib's word for its largest window and that wrapping
    z_stream stream{};
    if (inflateInit2(&stream, gzip) != Z_OK) return damaged("SVG", "it cannot be unpacked");
    const std::unique_ptr<z_stream, Release> ends(&stream);
    // zlib does not write to what it reads.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    std::array<char, 65536> part{};
    for (int status = Z_OK; status != Z_STREAM_END;) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = part.size();
        status = inflate(&stream, Z_NO_FLUSH);
        if (status != Z_OK && status != Z_STREAM_END)
            return damaged("SVG", "it cannot be unpacked");
        text.append(part.data(), part.size() - stream.avail_out);
        if (text.size() > most_text_bytes)
            return failure("the SVG picture is too large when unpacked; save it as PNG");
    }
    return text;
}

/// Without what declares its code, which is another one now.
Result<std::string> narrowed(std::string_view text) {
    const std::size_t low = text.starts_with("\xfe\xff") ? 1 : 0;
    std::vector<gunichar2> units;
    for (std::size_t i = 2; i + 1 < text.size(); i += 2)
        units.push_back(
            static_cast<gunichar2>(static_cast<unsigned char>(text[i + low]) |
                                   static_cast<unsigned char>(text[i + 1 - low]) << 8U));
    glong length = 0;
    const std::unique_ptr<gchar, Release> utf8(
        g_utf16_to_utf8(units.data(), static_cast<glong>(units.size()), nullptr, &length, nullptr));
    if (utf8 == nullptr) return damaged("SVG", "its letters cannot be read");
    const std::string_view all(utf8.get(), static_cast<std::size_t>(length));
    const auto end = all.starts_with("<?xml") ? all.find("?>") : std::string_view::npos;
    return std::string(end == std::string_view::npos ? all : all.substr(end + 2));
}

}  // namespace

Result<std::string> svg_text(Bytes bytes) {
    Result<std::string> text =
        is_packed(bytes) ? unpacked(bytes)
                         : Result<std::string>(std::string(
                               reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    if (!text) return text;
    const Bytes unpacked_bytes = std::as_bytes(std::span(*text));
    if (is_packed(unpacked_bytes) || format_of(unpacked_bytes) != FileFormat::svg)
        return not_a_picture(FileFormat::archive);
    if (text->starts_with("\xff\xfe") || text->starts_with("\xfe\xff")) return narrowed(*text);
    return text;
}

}  // namespace touchline::decode
