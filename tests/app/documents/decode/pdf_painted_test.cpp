// Tests that everything a PDF paints is in the picture, and that what is hidden is neither drawn
// nor told.
#include "app/documents/decode/files.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/pdf_writer.h"
#include "tests/app/documents/decode/reference.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;
using encoders::Bytes;

constexpr int side_px = 64;

/// A black square with 16 white pixels on each side.
bool is_black(int x, int y) {
    return x >= 16 && x < 48 && y >= 16 && y < 48;
}

std::string temporary(const std::string& name) {
    return (fs::temp_directory_path() / fmt::format("touchline-{}-{}", getpid(), name)).string();
}

std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The square, made by ImageMagick.
std::string made_by_convert(const std::string& options, const std::string& ending) {
    const std::string path = temporary("square." + ending);
    EXPECT_TRUE(run_command(
        fmt::format("convert -size 64x64 xc:white -fill black -draw 'rectangle 16,16 47,47' {} {}",
                    options, path)));
    const auto bytes = read_file(path);
    fs::remove(path);
    return bytes ? text_of(*bytes) : std::string();
}

/// The square as fax data, without a frame.
std::string fax() {
    const std::string path = temporary("square.tif");
    TIFF* const file = TIFFOpen(path.c_str(), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, side_px);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, side_px);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 1);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE);
    TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_CCITTFAX4);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, side_px);
    for (int y = 0; y < side_px; ++y) {
        std::vector<std::uint8_t> row(side_px / 8, 0);
        for (int x = 0; x < side_px; ++x)
            if (is_black(x, y))
                row[static_cast<std::size_t>(x) / 8] |= static_cast<std::uint8_t>(0x80 >> (x % 8));
        TIFFWriteScanline(file, row.data(), static_cast<std::uint32_t>(y), 0);
    }
    TIFFClose(file);
    TIFF* const written = TIFFOpen(path.c_str(), "r");
    std::string data(static_cast<std::size_t>(TIFFRawStripSize(written, 0)), '\0');
    TIFFReadRawStrip(written, 0, data.data(), static_cast<tmsize_t>(data.size()));
    TIFFClose(written);
    fs::remove(path);
    return data;
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffU);
    return bytes;
}

std::string segment(std::uint32_t number, char type, const std::string& data) {
    return big_endian(number) + type + '\0' + '\1' +
           big_endian(static_cast<std::uint32_t>(data.size())) + data;
}

/// A page with one region that is coded as a fax.
std::string jbig2() {
    const std::string size = big_endian(side_px) + big_endian(side_px);
    const std::string nothing(8, '\0');
    return segment(0, 48, size + nothing + std::string(3, '\0')) +
           segment(1, 38, size + nothing + '\0' + '\1' + fax());
}

/// The grey, from 0 (black) to 255, of a pixel of the page at 72 dpi; x and y are points from the
/// lower left corner.
int grey_at(const Page& page, int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(page.picture.height - 1 - y) *
                                   static_cast<std::size_t>(page.picture.width) +
                               static_cast<std::size_t>(x));
    return (page.picture.bgr[i] + page.picture.bgr[i + 1] + page.picture.bgr[i + 2]) / 3;
}

struct Painting {
    std::string name;
    std::string content;
    std::vector<std::string> objects;
    std::string resources;
    std::string page = {};
    std::string catalogue = {};
};

const std::string images = "/XObject << /I 5 0 R >>";
/// The image fills (100, 300) to (400, 600), so the square fills (175, 375) to (325, 525).
const std::string place_image = "q 300 0 0 300 100 300 cm /I Do Q";
const std::string square = "175 375 150 150 re f";

std::string image(const std::string& rest, const std::string& data) {
    return stream_of(fmt::format("/Type /XObject /Subtype /Image /Width 64 /Height 64 {}", rest),
                     data);
}

std::string form(const std::string& rest, const std::string& content) {
    return stream_of(fmt::format("/Type /XObject /Subtype /Form /BBox [0 0 600 800] {}", rest),
                     content);
}

std::string widget(const std::string& rest) {
    return "<< /Type /Annot /Subtype /Widget /Rect [0 0 600 800] " + rest + " >>";
}

std::string samples(int channels, int black, int white) {
    std::string data;
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x)
            for (int i = 0; i < channels; ++i)
                data += static_cast<char>(is_black(x, y) ? black : white);
    return data;
}

std::vector<Painting> paintings() {
    const std::string grey = "/ColorSpace /DeviceGray /BitsPerComponent 8";
    const std::string black = image(grey + " /SMask 6 0 R", samples(1, 0, 0));
    return {
        {"JPX",
         place_image,
         {image("/Filter /JPXDecode", made_by_convert("-colorspace gray -alpha off", "jp2"))},
         images},
        {"JBIG2",
         place_image,
         {image("/ColorSpace /DeviceGray /BitsPerComponent 1 /Filter /JBIG2Decode", jbig2())},
         images},
        {"CCITT",
         place_image,
         {image("/ColorSpace /DeviceGray /BitsPerComponent 1 /Filter /CCITTFaxDecode /DecodeParms "
                "<< /K "
                "-1 /Columns 64 /Rows 64 >>",
                fax())},
         images},
        {"CMYK",
         place_image,
         {image("/ColorSpace /DeviceCMYK /BitsPerComponent 8", samples(4, 255, 0))},
         images},
        {"CMYK in JPEG",
         place_image,
         {image("/ColorSpace /DeviceCMYK /BitsPerComponent 8 /Filter /DCTDecode /Decode [1 0 1 0 1 "
                "0 1 0]",
                made_by_convert("-colorspace CMYK", "jpg"))},
         images},
        {"soft mask", place_image, {black, image(grey, samples(1, 255, 0))}, images},
        {"stencil",
         place_image,
         {image("/ImageMask true /BitsPerComponent 1 /Decode [1 0] /Filter /CCITTFaxDecode "
                "/DecodeParms << "
                "/K -1 /Columns 64 /Rows 64 /BlackIs1 true >>",
                fax())},
         images},
        {"inline image",
         "q 150 0 0 150 175 375 cm BI /W 1 /H 1 /CS /G /BPC 8 /F /AHx ID 00> EI Q",
         {},
         ""},
        {"form in a form",
         "/I Do",
         {form("/Resources << /XObject << /J 6 0 R >> >>", "/J Do"),
          form("/Matrix [1 0 0 1 5 5]", "170 370 150 150 re f")},
         images},
        {"group that is seen through",
         "/G gs /I Do",
         {form("/Group << /S /Transparency /I true >>", square)},
         images + " /ExtGState << /G << /ca 0.9 >> >>"},
        {"Type 3 letter",
         "BT /T 100 Tf 175 375 Td (a) Tj ET",
         {"<< /Type /Font /Subtype /Type3 /FontBBox [0 0 1500 1500] /FontMatrix [0.001 0 0 0.001 0 "
          "0] "
          "/CharProcs << /a 6 0 R >> /Encoding << /Type /Encoding /Differences [97 /a] >> "
          "/FirstChar 97 "
          "/LastChar 97 /Widths [1500] /Resources << >> >>",
          stream_of("", "1500 0 0 0 1500 1500 d1 0 0 1500 1500 re f")},
         "/Font << /T 5 0 R >>"},
        {"shading",
         "q 175 375 150 150 re W n /S sh Q",
         {"<< /ShadingType 2 /ColorSpace /DeviceGray /Coords [0 0 600 0] /Extend [true true] "
          "/Function << "
          "/FunctionType 2 /Domain [0 1] /C0 [0] /C1 [0.2] /N 1 >> >>"},
         "/Shading << /S 5 0 R >>"},
        {"pattern",
         "/Pattern cs /P scn " + square,
         {stream_of(
             "/Type /Pattern /PatternType 1 /PaintType 1 /TilingType 1 /BBox [0 0 10 10] /XStep 10 "
             "/YStep 10 /Resources << >>",
             "0 0 10 10 re f")},
         "/Pattern << /P 5 0 R >>"},
        {"field with its look",
         "",
         {widget("/FT /Tx /T (a) /F 4 /AP << /N 6 0 R >>"), form("", square)},
         "",
         "/Annots [5 0 R]",
         "/AcroForm << /Fields [5 0 R] >>"},
        {"ticked box",
         "",
         {widget("/FT /Btn /T (a) /F 4 /AS /On /V /On /AP << /N << /On 6 0 R /Off 7 0 R >> >>"),
          form("", square), form("", "")},
         "",
         "/Annots [5 0 R]",
         "/AcroForm << /Fields [5 0 R] >>"},
        {"note with its look",
         "",
         {"<< /Type /Annot /Subtype /Square /Rect [0 0 600 800] /F 4 /AP << /N 6 0 R >> >>",
          form("", square)},
         "",
         "/Annots [5 0 R]"},
        {"note without a look",
         "",
         {"<< /Type /Annot /Subtype /Square /Rect [175 375 325 525] /F 4 /IC [0 0 0] /C [0 0 0] "
          ">>"},
         "",
         "/Annots [5 0 R]"},
        {"layer that is on",
         "/OC /L BDC " + square + " EMC",
         {"<< /Type /OCG /Name (a) >>"},
         "/Properties << /L 5 0 R >>",
         "",
         "/OCProperties << /OCGs [5 0 R] /D << /ON [5 0 R] >> >>"}};
}

Result<Page> page_of(const Painting& painting) {
    const auto pdf = written_pdf(
        {{painting.content, "/MediaBox [0 0 600 800] " + painting.page, painting.resources}},
        painting.objects, painting.catalogue);
    return decode_page(pdf, {1, 72});
}

TEST(PdfPainting, WhateverPaintsIsInThePicture) {
    for (const Painting& painting : paintings()) {
        const auto page = page_of(painting);
        ASSERT_TRUE(page.has_value()) << painting.name << ": " << page.error().line;
        for (const auto& [x, y] :
             {std::pair(180, 380), {320, 380}, {250, 450}, {180, 520}, {320, 520}})
            EXPECT_LT(grey_at(*page, x, y), 60) << painting.name << " at " << x << ", " << y;
        for (const auto& [x, y] :
             {std::pair(168, 450), {332, 450}, {250, 368}, {250, 532}, {50, 50}})
            EXPECT_GT(grey_at(*page, x, y), 230) << painting.name << " at " << x << ", " << y;
    }
}

/// If a document gives a field's content but no appearance, poppler makes one.
TEST(PdfPainting, WhatAFieldHoldsIsPaintedAndTold) {
    const std::string looks = "/DR << /Font << /F 4 0 R >> >> /DA (/F 12 Tf 0 g)";
    for (const std::string& field :
         {std::string("/Subtype /Widget /FT /Tx /T (a) /V (Harbour) /DA (/F 30 Tf 0 g)"),
          std::string("/Subtype /FreeText /Contents (Harbour) /DA (/F 30 Tf 0 g)")}) {
        const auto page =
            page_of({"field",
                     "",
                     {"<< /Type /Annot /Rect [100 500 400 560] /F 4 " + field + " >>"},
                     "/Font << /F 4 0 R >>",
                     "/Annots [5 0 R]",
                     "/AcroForm << /Fields [5 0 R] /NeedAppearances true " + looks + " >>"});
        ASSERT_TRUE(page.has_value()) << page.error().line;
        ASSERT_EQ(page->told.labels.size(), 1U) << field;
        EXPECT_EQ(page->told.labels[0].text, "Harbour") << field;
        EXPECT_EQ(page->words.size(), 1U) << field;
    }
}

std::vector<Painting> hidden() {
    const std::string words = " BT /F 40 Tf 180 420 Td (Hidden words) Tj ET ";
    const std::string font = "/Font << /F 4 0 R >> ";
    const std::string grey = "/ColorSpace /DeviceGray /BitsPerComponent 8";
    const std::string off = "/OCProperties << /OCGs [5 0 R] /D << /OFF [5 0 R] >> >>";
    const std::string layer = "<< /Type /OCG /Name (a) >>";
    return {{"layer that is off",
             "/OC /L BDC " + square + words + "EMC",
             {layer},
             font + "/Properties << /L 5 0 R >>",
             "",
             off},
            {"image of a layer that is off",
             "q 300 0 0 300 100 300 cm /J Do Q",
             {layer, image(grey + " /OC 5 0 R", samples(1, 0, 255))},
             "/XObject << /J 6 0 R >>",
             "",
             off},
            {"form of a layer that is off",
             "/J Do",
             {layer, form("/OC 5 0 R /Resources << /Font << /F 4 0 R >> >>", square + words)},
             "/XObject << /J 6 0 R >>",
             "",
             off},
            {"field that is hidden",
             "",
             {widget("/FT /Tx /T (a) /F 2 /AP << /N 6 0 R >>"),
              form("/Resources << /Font << /F 4 0 R >> >>", square + words)},
             "",
             "/Annots [5 0 R]",
             "/AcroForm << /Fields [5 0 R] >>"},
            {"box that is not ticked",
             "",
             {widget("/FT /Btn /T (a) /F 4 /AS /Off /AP << /N << /On 6 0 R /Off 7 0 R >> >>"),
              form("/Resources << /Font << /F 4 0 R >> >>", square + words), form("", "")},
             "",
             "/Annots [5 0 R]",
             "/AcroForm << /Fields [5 0 R] >>"},
            {"under white", square + words + "1 g 100 300 400 300 re f", {}, font},
            {"white on white", "1 g " + square + words, {}, font},
            {"clipped away", "10 10 20 20 re W n " + square + words, {}, font},
            {"seen through wholly",
             "/G gs " + square + words,
             {},
             font + "/ExtGState << /G << /ca 0 >> >>"},
            {"words without ink", "3 Tr" + words, {}, font},
            {"words as a clip", "7 Tr" + words, {}, font},
            {"beside the page", "1 0 0 1 700 0 cm " + square + words, {}, font}};
}

TEST(PdfPainting, WhatIsHiddenIsNeitherFeltNorTold) {
    for (const Painting& painting : hidden()) {
        const auto page = page_of(painting);
        ASSERT_TRUE(page.has_value()) << painting.name << ": " << page.error().line;
        for (const std::uint8_t value : page->picture.bgr) ASSERT_GT(value, 250) << painting.name;
        EXPECT_TRUE(page->told.labels.empty()) << painting.name;
        EXPECT_TRUE(page->words.empty()) << painting.name;
        EXPECT_TRUE(page->figures.empty()) << painting.name;
    }
}

}  // namespace
}  // namespace touchline
