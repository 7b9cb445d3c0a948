// Tests untrusted input from a stick: every broken file gives one clear line and never a crash.
#include "app/documents/decode/picture.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>
#include <tiff.h>

/// librsvg 2.54 does not free the source text of an entity that a document declares: each document
/// leaks the length of the entity, until the process that decodes it ends.
extern "C" const char* __lsan_default_suppressions();  // NOLINT: the sanitizer's name

extern "C" const char* __lsan_default_suppressions() {  // NOLINT
    return "leak:xmlParseEntityValue";
}

namespace touchline {
namespace {

using encoders::Bytes;

bool is_one_line(const std::string& line) {
    return !line.empty() && std::none_of(line.begin(), line.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
    });
}

void expect_refused(const Bytes& bytes, const std::string& because) {
    const auto picture = decode_picture(bytes);
    ASSERT_FALSE(picture);
    EXPECT_TRUE(is_one_line(picture.error().line)) << picture.error().line;
    EXPECT_NE(picture.error().line.find(because), std::string::npos) << picture.error().line;
}

struct Sample {
    std::string format;
    Bytes bytes;
};

std::vector<Sample> samples() {
    const Picture picture = encoders::test_picture(64, 48);
    std::vector<std::uint8_t> bgra(std::size_t{4} * 64 * 48);
    for (std::size_t i = 0; i < bgra.size(); ++i) {
        bgra[i] = static_cast<std::uint8_t>(i * i / 7);
    }
    encoders::JpegForm progressive;
    progressive.is_progressive = true;
    progressive.exif_orientation = 6;
    return {{"PNG", encoders::png(picture)},
            {"JPEG", encoders::jpeg(picture)},
            {"JPEG", encoders::jpeg(picture, progressive)},
            {"WebP", encoders::lossy_webp(picture)},
            {"WebP", encoders::lossless_webp(64, 48, bgra)},
            {"TIFF", encoders::tiff(picture)},
            {"SVG", encoders::bytes_of(
                        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 30">
                        <path d="M1 1 C 20 1 30 20 35 25 Z" stroke="red"/></svg>)")}};
}

TEST(PictureReader, NothingAndOneByteAreRefused) {
    expect_refused({}, "is empty");
    for (int byte = 0; byte < 256; ++byte) {
        expect_refused({static_cast<std::byte>(byte)}, "no picture that is known");
    }
}

TEST(PictureReader, OtherFormatsAreNamedUnknown) {
    for (const auto* text : {"fish", "<html><body>", "BM......", "P9 1 1", "    ftypisom"}) {
        expect_refused(encoders::bytes_of(text), "no picture that is known");
    }
}

TEST(PictureReader, AFileCutShortAnywhereIsOneClearLine) {
    for (const Sample& sample : samples()) {
        for (std::size_t part = 1; part < 20; ++part) {
            SCOPED_TRACE(sample.format + " cut at " + std::to_string(part) + "/20");
            const auto size = static_cast<std::ptrdiff_t>(sample.bytes.size() * part / 20);
            const Bytes cut(sample.bytes.begin(), sample.bytes.begin() + size);
            // So little of an SVG is left that it is not recognised as one.
            expect_refused(cut, sample.format == "SVG" && size < 4 ? "no picture" : sample.format);
        }
    }
}

TEST(PictureReader, AMagicNumberAloneIsOneClearLine) {
    using namespace std::string_literals;
    expect_refused(encoders::bytes_of("\x89PNG\r\n\x1a\n"s), "PNG");
    expect_refused(encoders::bytes_of("\xff\xd8\xff"s), "JPEG");
    expect_refused(encoders::bytes_of("RIFF\x04\0\0\0WEBP"s), "WebP");
    expect_refused(encoders::bytes_of("II*\0"s), "TIFF");
    expect_refused(encoders::bytes_of("MM\0*\0\0\0\x08"s), "TIFF");
    expect_refused(encoders::bytes_of("<svg"s), "SVG");
}

void put_big_endian(Bytes& bytes, std::size_t offset, std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i, value >>= 8U) {
        bytes[offset + static_cast<std::size_t>(i)] = static_cast<std::byte>(value & 0xffU);
    }
}

TEST(PictureReader, APngHeaderBeyondTheLimitsIsRefused) {
    const Bytes good = encoders::png(encoders::test_picture());
    for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {0x7fffffff, 0x7fffffff}, {0xffffffff, 0xffffffff}, {12000, 10001}, {80001, 1}}) {
        Bytes bytes = good;
        put_big_endian(bytes, 16, width, 4);
        put_big_endian(bytes, 20, height, 4);
        expect_refused(bytes, "more than 120 megapixels or 80000 on a side");
    }
    Bytes bytes = good;
    put_big_endian(bytes, 16, 0, 4);
    expect_refused(bytes, "no pixels");
}

TEST(PictureReader, AJpegHeaderBeyondTheLimitsIsRefused) {
    Bytes bytes = encoders::jpeg(encoders::test_picture());
    const std::vector<std::byte> frame{std::byte{0xff}, std::byte{0xc0}};
    const auto found = std::search(bytes.begin(), bytes.end(), frame.begin(), frame.end());
    ASSERT_NE(found, bytes.end());
    const auto offset = static_cast<std::size_t>(found - bytes.begin()) + 5;
    put_big_endian(bytes, offset, 0xffffffffU, 4);
    expect_refused(bytes, "65");  // libjpeg's own limit is 65500
    put_big_endian(bytes, offset, 20000, 2);
    put_big_endian(bytes, offset + 2, 20000, 2);
    expect_refused(bytes, "20000 x 20000 pixels, more than 200 megapixels");
}

TEST(PictureReader, AWebpHeaderBeyondTheLimitsIsRefused) {
    Bytes bytes = encoders::lossless_webp(1, 1, {0, 0, 0, 255});
    constexpr std::size_t sides = 21;  // RIFF 12, chunk 8, signature 1; then 14 + 14 bits
    for (std::size_t i = 0; i < 3; ++i) bytes[sides + i] = std::byte{0xff};
    bytes[sides + 3] = std::byte{0x0f};
    expect_refused(bytes, "16384 x 16384 pixels, more than 120 megapixels");
}

/// One little-endian directory of long numbers: the sides, and one strip at the beginning.
Bytes tiff_header(std::uint32_t width, std::uint32_t height) {
    Bytes bytes = encoders::bytes_of(std::string("II*\0\x08\0\0\0\x04\0", 10));
    for (const auto& [tag, value] :
         std::vector<std::pair<unsigned, std::uint32_t>>{{TIFFTAG_IMAGEWIDTH, width},
                                                         {TIFFTAG_IMAGELENGTH, height},
                                                         {TIFFTAG_STRIPOFFSETS, 8},
                                                         {TIFFTAG_STRIPBYTECOUNTS, 8}}) {
        for (const std::uint32_t number : {tag | (4U << 16U), 1U, value}) {
            for (unsigned i = 0; i < 4; ++i) {
                bytes.push_back(static_cast<std::byte>(number >> (8 * i) & 0xffU));
            }
        }
    }
    bytes.resize(bytes.size() + 4);
    return bytes;
}

TEST(PictureReader, ATiffHeaderBeyondTheLimitsIsRefused) {
    expect_refused(tiff_header(0x7fffffff, 0x7fffffff), "more than 120 megapixels");
    expect_refused(tiff_header(0xffffffff, 0xffffffff), "TIFF");
    expect_refused(tiff_header(80000, 1501), "more than 120 megapixels or 80000 on a side");
    expect_refused(tiff_header(100, 100), "TIFF");
}

TEST(PictureReader, WhatIsNoPictureIsToldWhatToDo) {
    using namespace std::string_literals;
    for (const auto& office :
         {"PK\3\4............................[Content_Types].xml"s,
          "PK\3\4..........................mimetypeapplication/vnd.oasis.opendocument.text"s,
          "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"s, "{\\rtf1\\ansi"s})
        expect_refused(encoders::bytes_of(office), "save it as PDF");
    expect_refused(encoders::bytes_of("PK\3\4............................fish.png"s), "unpack it");
}

TEST(PictureReader, AnXmlBombIsHarmless) {
    std::string bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
    for (char name = 'b'; name < 'm'; ++name) {
        bomb += std::string("<!ENTITY ") + name + " \"";
        for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(name - 1) + ";";
        bomb += "\">";
    }
    bomb += R"(]><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 3"><text>&l;</text></svg>)";
    const auto picture = decode_picture(encoders::bytes_of(bomb));
    if (!picture) {
        EXPECT_TRUE(is_one_line(picture.error().line)) << picture.error().line;
    }
}

/// Seeded, so that a failure repeats; the sanitizers find the errors.
TEST(PictureReader, FlippedBitsNeverCrash) {
    std::mt19937 random(2024);
    for (const Sample& sample : samples()) {
        const int flips = sample.format == "SVG" ? 50 : 1000;  // an SVG is rendered large every
                                                               // time
        for (int i = 0; i < flips; ++i) {
            Bytes bytes = sample.bytes;
            for (unsigned k = 0; k <= random() % 4; ++k) {
                bytes[random() % bytes.size()] ^= static_cast<std::byte>(1U << random() % 8);
            }
            const auto picture = decode_picture(bytes);
            if (picture) {
                ASSERT_EQ(picture->bgr.size(), std::size_t{3} *
                                                   static_cast<std::size_t>(picture->width) *
                                                   static_cast<std::size_t>(picture->height));
            } else {
                ASSERT_TRUE(is_one_line(picture.error().line)) << picture.error().line;
            }
        }
    }
}

TEST(PictureReader, ErrorsOfAFileBeginWithItsPath) {
    const auto missing = read_picture("/nowhere/fish\n.png");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().line,
              "/nowhere/fish .png: cannot be opened: No such file or directory");
    const auto unknown = read_picture(TOUCHLINE_SOURCE_DIR "/CMakeLists.txt");
    ASSERT_FALSE(unknown);
    EXPECT_TRUE(unknown.error().line.starts_with(TOUCHLINE_SOURCE_DIR "/CMakeLists.txt: "));
}

}  // namespace
}  // namespace touchline
