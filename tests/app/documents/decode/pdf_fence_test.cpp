// Tests documents whose fonts lie in system files; the sandboxed worker draws them.
#include "app/documents/decode/opening.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Script {
    std::string ordering;  // one of Adobe's collections
    std::string map;       // from codes to letters, in poppler's data
    std::string font;      // not embedded in the document
    std::string codes;     // two letters
    std::string text;
};

/// A page with two large letters, written as codes.
encoders::Bytes page_in(const Script& script) {
    return written_pdf(
        {{fmt::format("BT /C 120 Tf 100 400 Td <{}> Tj ET", script.codes),
          "/MediaBox [0 0 600 800]", "/Font << /C 5 0 R >>"}},
        {fmt::format(
             "<< /Type /Font /Subtype /Type0 /BaseFont /{0} /Encoding /{1} /DescendantFonts [6 0 "
             "R] >>",
             script.font, script.map),
         fmt::format(
             "<< /Type /Font /Subtype /CIDFontType0 /BaseFont /{} /CIDSystemInfo << /Registry "
             "(Adobe) /Ordering ({}) /Supplement 2 >> /DW 1000 /FontDescriptor 7 0 R >>",
             script.font, script.ordering),
         fmt::format("<< /Type /FontDescriptor /FontName /{} /Flags 4 /FontBBox [0 -200 1000 900] "
                     "/ItalicAngle 0 /Ascent 880 /Descent -120 /CapHeight 880 /StemV 80 >>",
                     script.font)});
}

TEST(PdfFence, LettersOfEastAsiaAreDrawnAndTold) {
    for (const Script& script :
         {Script{"GB1", "GBK-EUC-H", "STSong-Light", "D6D0B9FA", "\u4e2d\u56fd"},
          Script{"GB1", "UniGB-UCS2-H", "STSong-Light", "4E2D56FD", "\u4e2d\u56fd"},
          Script{"Japan1", "90ms-RKSJ-H", "HeiseiMin-W3", "93FA967B", "\u65e5\u672c"},
          Script{"Japan1", "UniJIS-UTF16-H", "KozMinPro-Regular", "65E5672C", "\u65e5\u672c"},
          Script{"Korea1", "KSCms-UHC-H", "HYSMyeongJo-Medium", "C7D1B1B9", "\ud55c\uad6d"},
          Script{"CNS1", "ETen-B5-H", "MSung-Light", "A578C657", "\u53f0\u7063"}}) {
        const auto page = open_page(page_in(script));
        ASSERT_TRUE(page.has_value()) << script.map << ": " << page.error().line;
        ASSERT_EQ(page->told.labels.size(), 1U) << script.map;
        EXPECT_EQ(page->told.labels[0].text, script.text) << script.map;
        // Both letters have ink, each in its 120 point cell.
        ASSERT_EQ(page->words.size(), 1U) << script.map;
        const WordBox& box = page->words[0];
        EXPECT_GT(box.right - box.left, 1.2 * 250) << script.map;
        EXPECT_LE(box.right - box.left, 2.1 * 250) << script.map;
        EXPECT_GT(box.bottom - box.top, 0.6 * 250) << script.map;
    }
}

TEST(PdfFence, LettersThatNoDocumentBringsAlongAreDrawn) {
    for (const char* font : {"Helvetica", "Times-Roman", "Courier-Bold", "ArialMT",
                             "Frutiger-Light", "Symbol", "ZapfDingbats"}) {
        const auto page = open_page(
            written_pdf({{"BT /N 100 Tf 100 400 Td (anm) Tj ET", "/MediaBox [0 0 600 800]",
                          "/Font << /N 5 0 R >>"}},
                        {fmt::format("<< /Type /Font /Subtype /Type1 /BaseFont /{} >>", font)}));
        ASSERT_TRUE(page.has_value()) << font << ": " << page.error().line;
        const auto dark =
            std::ranges::count_if(page->picture.bgr, [](std::uint8_t value) { return value < 60; });
        EXPECT_GT(dark, 3000) << font;
    }
}

}  // namespace
}  // namespace touchline
