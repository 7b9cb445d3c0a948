// Tests that a PDF's text is told as a person would read it, and that its letter boxes hold only
// letters.
#include "app/documents/decode/pdf_words.h"

#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/pdf_writer.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

using Texts = std::vector<std::string>;

Page page_with(const std::string& content, const std::vector<std::string>& objects = {},
               const std::string& fonts = {}) {
    const auto page = decode_page(
        written_pdf({{content, "/MediaBox [0 0 600 800]",
                      "/Font << /F 4 0 R " + fonts + " >> /ExtGState << /G << /ca 0.3 >> >>"}},
                    objects));
    EXPECT_TRUE(page.has_value()) << page.error().line;
    return page.value_or(Page{});
}

Texts told(const Page& page) {
    Texts texts;
    for (const Label& label : page.told.labels) texts.push_back(label.text);
    return texts;
}

TEST(PdfWords, WordsOfALineAreOneText) {
    const Page page = page_with(
        "BT /F 20 Tf 100 700 Td (The ) Tj (sea) Tj ET BT /F 20 Tf 300 700 Td (far off) Tj ET "
        "BT /F 20 Tf 100 600 Td [(K) 80 (er) -20 (n)] TJ ET "
        "BT /F 20 Tf 100 500 Td (one) Tj 45 0 Td (two) Tj 0 -24 Td (below) Tj ET");
    EXPECT_EQ(told(page), (Texts{"The sea", "far off", "Kern", "one two", "below"}));
    EXPECT_EQ(page.words.size(), 8U);
}

TEST(PdfWords, AWatermarkIsOneWordOnce) {
    const std::string slanted = "0.7 0.7 -0.7 0.7";
    EXPECT_EQ(told(page_with("/G gs BT /F 90 Tf " + slanted + " 120 200 Tm (DRAFT) Tj ET")),
              Texts{"DRAFT"});
    std::string letters = "0.85 g ";
    for (int i = 0; i < 5; ++i)
        letters += fmt::format("BT /F 70 Tf {} {} {} Tm ({}) Tj ET ", slanted, 100 + 55 * i,
                               200 + 55 * i, "DRAFT"[i]);
    EXPECT_EQ(told(page_with(letters)), Texts{"DRAFT"}) << "letter by letter";
    std::string many = "0.9 g ";
    for (int i = 0; i < 12; ++i)
        many += fmt::format("BT /F 24 Tf 0.9 0.4 -0.4 0.9 {} {} Tm (Not for sale) Tj ET ",
                            40 + 180 * (i % 3), 100 + 170 * (i / 3));
    const Page page = page_with(many);
    EXPECT_EQ(told(page), Texts{"Not for sale"}) << "all over the page";
    EXPECT_GT(page.words.size(), 100U) << "but every letter is painted over";
    std::string apart = "0.85 g ";
    for (int i = 0; i < 9; ++i)
        apart += fmt::format("BT /F 50 Tf {} 400 Td ({}) Tj ET ", 10 + 60 * i, "TOPSECRET"[i]);
    EXPECT_EQ(told(page_with(apart)), Texts{"TOPSECRET"});
    EXPECT_EQ(told(page_with("BT /F 20 Tf 100 400 Td (1 2 3 4) Tj 0 -100 Td (A B C) Tj ET")),
              (Texts{"1 2 3 4", "A B C"}));
}

TEST(PdfWords, ShadowsAreToldOnceAndEqualLabelsEach) {
    EXPECT_EQ(told(page_with("0.6 g BT /F 40 Tf 102 398 Td (Sun) Tj ET 0 g BT /F 40 Tf 100 400 Td "
                             "(Sun) Tj ET")),
              Texts{"Sun"});
    EXPECT_EQ(told(page_with("BT /F 20 Tf 100 400 Td (yes) Tj 0 -100 Td (yes) Tj ET")),
              (Texts{"yes", "yes"}));
}

TEST(PdfWords, WhatDrawsIsNoWord) {
    const std::string dingbats = "<< /Type /Font /Subtype /Type1 /BaseFont /ZapfDingbats >>";
    const std::string wingdings =
        "<< /Type /Font /Subtype /TrueType /BaseFont /ABCDEF+Wingdings-Regular >>";
    const Page page = page_with(
        "BT /D 60 Tf 100 600 Td (nu) Tj ET BT /W 60 Tf 100 400 Td (ab) Tj ET BT /F 30 Tf 100 200 "
        "Td "
        "(________) Tj ET BT /F 30 Tf 100 100 Td (- - -) Tj ET",
        {dingbats, wingdings}, "/D 5 0 R /W 6 0 R");
    EXPECT_EQ(told(page), Texts{});
    EXPECT_TRUE(page.words.empty());
    const Page list =
        page_with("BT /D 20 Tf 100 600 Td (l ) Tj /F 20 Tf (apples) Tj ET", {dingbats}, "/D 5 0 R");
    EXPECT_EQ(told(list), Texts{"apples"});
}

/// A white page with the square of a drawing, then words that are not painted.
TEST(PdfWords, WordsThatAreNotPaintedHaveNoBoxes) {
    const std::string drawing =
        "2 w 150 350 300 200 re S 200 400 40 40 re S 300 400 m 330 440 l S ";
    for (const std::string& words :
         {std::string("3 Tr BT /F 60 Tf 160 400 Td (Harbour) Tj ET"),
          std::string("3 Tr BT /F 200 Tf 20 400 Td (OK) Tj ET"),
          std::string("3 Tr BT /F 12 Tf 195 410 Td (house number) Tj ET"),
          std::string("1 g BT /F 12 Tf 20 700 Td (Harbour) Tj ET")}) {
        const Page page = page_with(drawing + words);
        EXPECT_TRUE(page.words.empty()) << words;
        EXPECT_EQ(told(page), Texts{}) << words;
    }
    const Page covered =
        page_with("BT /F 60 Tf 160 400 Td (Harbour) Tj ET 1 g 100 300 400 300 re f 0 g " + drawing);
    EXPECT_TRUE(covered.words.empty());
}

/// A scan: letters in its pixels, and the same words over them without ink.
TEST(PdfWords, WordsThatWereReadInAScanAreToldAndPaintedOver) {
    const std::string letters = "BT /F 24 Tf 100 600 Td (A harbour) Tj ET ";
    // The picture has another typeface than the invisible text.
    const std::string courier = "<< /Type /Font /Subtype /Type1 /BaseFont /Courier >>";
    const Page page = page_with(letters +
                                    "3 Tr BT /C 20 Tf 100 600 Td (A harbour) Tj ET "
                                    "0 Tr 2 w 80 500 400 200 re S",
                                {courier}, "/C 5 0 R");
    EXPECT_EQ(told(page), Texts{"A harbour"});
    const auto scan =
        decode_page(written_pdf({{letters, "/MediaBox [0 0 600 800]", "/Font << /F 4 0 R >>"}}));
    ASSERT_TRUE(scan.has_value());
    std::string pixels;
    for (std::size_t i = 0; i < scan->picture.bgr.size(); i += 3)
        pixels += fmt::format("{:02X}", scan->picture.bgr[i]);
    const std::string image = stream_of(
        fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /ColorSpace /DeviceGray "
                    "/BitsPerComponent 8 /Filter /ASCIIHexDecode",
                    scan->picture.width, scan->picture.height),
        pixels);
    const auto scanned = decode_page(
        written_pdf({{"q 600 0 0 800 0 0 cm /I Do Q 3 Tr BT /C 20 Tf 100 600 Td (A harbour) Tj ET",
                      "/MediaBox [0 0 600 800]", "/Font << /C 6 0 R >> /XObject << /I 5 0 R >>"}},
                    {image, courier}));
    ASSERT_TRUE(scanned.has_value());
    EXPECT_EQ(told(*scanned), Texts{"A harbour"});
    EXPECT_EQ(scanned->words.size(), 2U);
}

TEST(PdfWords, LettersThatShowAPatternOrAPictureAreWords) {
    const std::string shade =
        "<< /PatternType 2 /Shading << /ShadingType 2 /ColorSpace /DeviceGray /Coords [0 0 600 0] "
        "/Extend [true true] /Function << /FunctionType 2 /Domain [0 1] /C0 [0] /C1 [0.6] /N 1 >> "
        ">> >>";
    const auto shaded = decode_page(
        written_pdf({{"/Pattern cs /P scn BT /F 60 Tf 100 400 Td (OK) Tj ET",
                      "/MediaBox [0 0 600 800]", "/Font << /F 4 0 R >> /Pattern << /P 5 0 R >>"}},
                    {shade}));
    ASSERT_TRUE(shaded.has_value());
    EXPECT_EQ(told(*shaded), Texts{"OK"});
    EXPECT_EQ(told(page_with("q BT 7 Tr /F 60 Tf 100 400 Td (OK) Tj ET 0.2 0.4 0.6 rg 0 0 600 800 "
                             "re f Q")),
              Texts{"OK"});
    EXPECT_EQ(told(page_with("BT 1 Tr 3 w /F 60 Tf 100 400 Td (OK) Tj ET")), Texts{"OK"});
}

TEST(PdfWords, LinesThroughWordsDoNotHideThem) {
    const Page page = page_with(
        "3 w 100 400 m 500 420 l S 100 430 m 500 400 l S BT /F 40 Tf 150 400 Td (Crossed words) Tj "
        "ET "
        "0.9 g BT /F 120 Tf 0.7 0.7 -0.7 0.7 150 300 Tm (PALE) Tj ET 0 G 5 w 100 500 m 500 500 l S "
        "100 "
        "550 m 500 550 l S 100 600 m 500 600 l S");
    EXPECT_EQ(told(page), (Texts{"Crossed words", "PALE"}));
}

TEST(PdfWords, ALanguageFromTheRightIsReadFromTheRight) {
    using decode::DrawnLetter;
    std::vector<DrawnLetter> letters;
    // Drawn from left to right: "12", a gap, then a word whose first letter is on the right.
    const Texts drawn{"1", "2", " ", "\u05dd", "\u05d5", "\u05dc", "\u05e9"};
    double x = 0.0;
    for (const std::string& sign : drawn) {
        letters.push_back(
            {sign, {x, 50.0}, {x + 10.0, 50.0}, {0.0, -10.0}, {x, 40.0, x + 10.0, 52.0}, false});
        x += 10.0;
    }
    const auto texts = decode::texts_in(letters);
    ASSERT_EQ(texts.size(), 1U);
    EXPECT_EQ(texts[0].text, "\u05e9\u05dc\u05d5\u05dd 12");
}

}  // namespace
}  // namespace touchline
