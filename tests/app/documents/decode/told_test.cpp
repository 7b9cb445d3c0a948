// Tests that text written for people who cannot see a picture survives opening it.
#include "app/documents/decode/file_format.h"
#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/opening.h"
#include "app/documents/decode/readers.h"
#include "app/documents/sticks/listing.h"
#include "app/documents/trace/tracing.h"
#include "config/types/utf8.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/files_of_formats.h"
#include "tests/app/documents/decode/pdf_writer.h"
#include "tests/app/documents/decode/with_metadata.h"

#include <filesystem>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

using encoders::Bytes;

TactileMap told_of(const Bytes& bytes) {
    const auto page = decode_page(bytes);
    EXPECT_TRUE(page.has_value()) << page.error().line;
    return page ? page->told : TactileMap{};
}

std::vector<Bytes> pictures() {
    const Picture picture = encoders::test_picture();
    return {encoders::jpeg(picture), encoders::png(picture)};
}

TEST(Told, ExifDescriptionIsTheDescription) {
    for (const Bytes& picture : pictures())
        EXPECT_EQ(told_of(with_metadata(picture,
                                        [](Exiv2::Image& image) {
                                            image.exifData()["Exif.Image.ImageDescription"] =
                                                "A dog on a beach";
                                        }))
                      .description,
                  "A dog on a beach");
}

TEST(Told, WhatACameraWritesByItselfIsNone) {
    EXPECT_EQ(told_of(with_metadata(pictures()[0],
                                    [](Exiv2::Image& image) {
                                        image.exifData()["Exif.Image.ImageDescription"] =
                                            "OLYMPUS DIGITAL CAMERA         ";
                                    }))
                  .description,
              "");
}

TEST(Told, WordsOfMachinesAreNone) {
    for (const char* words :
         {"OLYMPUS DIGITAL CAMERA", "MEDION DIGITAL CAMERA", "_cuva", "oznor", "dav_soft",
          "My beautiful picture", "filter: 0; jpegRotation: 0; filterMask: 0;",
          "Created with Sketch.", "untitled", "Untitled-1", "Microsoft Word - Doc1.docx",
          "PowerPoint Presentation", "Slice 1"})
        EXPECT_TRUE(decode::is_of_a_machine(words)) << words;
    for (const char* words : {"A dog", "dog", "The Olympus", "Plan of the hall: ground floor",
                              "Scan of a letter", "Layers of the earth", "Image of a saint"})
        EXPECT_FALSE(decode::is_of_a_machine(words)) << words;
}

TEST(Told, AltTextOfXmpWinsOverACaption) {
    for (const Bytes& picture : pictures()) {
        const TactileMap told = told_of(with_metadata(picture, [](Exiv2::Image& image) {
            image.exifData()["Exif.Image.ImageDescription"] = "IMG 20";
            image.xmpData()["Xmp.dc.title"] = "lang=\"x-default\" The beach";
            image.xmpData()["Xmp.dc.description"] = "lang=\"x-default\" My holidays";
            // An older libexiv2 does not know the type of this key.
            const auto alt_text = Exiv2::Value::create(Exiv2::langAlt);
            alt_text->read("lang=\"x-default\" A dog that runs to the left");
            image.xmpData().add(Exiv2::XmpKey("Xmp.iptc.AltTextAccessibility"), alt_text.get());
        }));
        EXPECT_EQ(told.title, "The beach");
        EXPECT_EQ(told.description, "A dog that runs to the left");
    }
}

TEST(Told, IptcCaptionIsTheDescription) {
    const TactileMap told = told_of(with_metadata(pictures()[0], [](Exiv2::Image& image) {
        image.iptcData()["Iptc.Application2.Caption"] = "A dog";
        image.iptcData()["Iptc.Application2.ObjectName"] = "Beach";
    }));
    EXPECT_EQ(told.title, "Beach");
    EXPECT_EQ(told.description, "A dog");
}

TEST(Told, SvgTitleAndDescription) {
    const TactileMap told = told_of(encoders::bytes_of(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><title>Fish
           </title><desc>A fish</desc><rect width="5" height="5"/><rect x="1" width="5" height="5"/></svg>)"));
    EXPECT_EQ(told.title, "Fish");
    EXPECT_EQ(told.description, "A fish");
    EXPECT_TRUE(told.outlines.empty());  // one outline covers the other
}

TactileMap told_of_svg(const std::string& title, const std::string& description) {
    return told_of(encoders::bytes_of(fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><title>{}</title>)"
        R"(<desc>{}</desc><rect width="5" height="5"/></svg>)",
        title, description)));
}

/// A page without a heading gets the document's own title.
TactileMap told_of_pdf(const std::string& title) {
    return told_of(written_pdf({{"100 100 300 200 re S"}},
                               {fmt::format("<< /Title ({}) >>", title)}, "", "/Info 5 0 R"));
}

TEST(Told, ATitleThatAProgramWroteIsNone) {
    for (const char* title : {"untitled", "Microsoft Word - x"})
        EXPECT_EQ(told_of_pdf(title).title, "") << title;
    EXPECT_EQ(told_of_pdf("Plan of the hall").title, "Plan of the hall");
    EXPECT_EQ(told_of_svg("Slice 1", "Created with Sketch.").title, "");
    EXPECT_EQ(told_of_svg("Slice 1", "Created with Sketch.").description, "");
    EXPECT_EQ(told_of_svg("A slice of bread", "With butter").title, "A slice of bread");
    EXPECT_EQ(told_of_svg("A slice of bread", "With butter").description, "With butter");
}

TEST(Told, TaggedPdfGivesHeadingFigureAndWordsOfEachPage) {
    const Bytes pdf = tagged_pdf({"Fish", "Bird"}, "A black box");
    for (int number = 1; number <= 2; ++number) {
        const auto page = decode_page(pdf, {number, 72});
        ASSERT_TRUE(page.has_value()) << page.error().line;
        const std::string word = number == 1 ? "Fish" : "Bird";
        EXPECT_EQ(page->number, number);
        EXPECT_EQ(page->count, 2);
        EXPECT_EQ(page->told.title, word);
        EXPECT_EQ(page->told.description, "A black box");
        ASSERT_EQ(page->told.labels.size(), 2U);
        EXPECT_EQ(page->told.labels[0].text, "A black box");
        // Centre (230, 50) points from the bottom left of 300 x 200 points, drawn as large as A5; a
        // pixel is 1e-4 m.
        const double px = page->picture.width / 300.0;
        EXPECT_NEAR(page->told.labels[0].place.x, px * 80e-4, 2e-4);
        EXPECT_NEAR(page->told.labels[0].place.y, px * -50e-4, 2e-4);
        EXPECT_EQ(page->told.labels[1].text, word);
        ASSERT_EQ(page->words.size(), 1U);
        EXPECT_NEAR(page->words[0].left, px * 72, 5);
        EXPECT_NEAR(page->words[0].bottom, px * 50, 10);
    }
    const auto beyond = decode_page(pdf, {3, 72});
    ASSERT_FALSE(beyond.has_value());
    EXPECT_EQ(beyond.error().line, "the document has 2 pages; choose one of them");
}

TEST(Told, PdfIsAsLargeAsAskedFor) {
    const Bytes pdf = tagged_pdf({"Fish"}, "");
    EXPECT_EQ(decode_page(pdf, {1, 72})->picture.width, 8 * 72) << "small pages count as A5";
    EXPECT_EQ(decode_page(pdf, {1, 144})->picture.width, 8 * 144);
    EXPECT_EQ(decode_page(pdf, {1, 144})->dpi, 144);
}

TEST(Told, LabelsLieWhereTheyLieInTheTracedMap) {
    const auto page = decode_page(tagged_pdf({"Fish"}, "A black box"), {1, 150});
    ASSERT_TRUE(page.has_value());
    const auto trace = trace_page(*page, {});
    ASSERT_TRUE(trace.has_value()) << trace.error().line;
    EXPECT_EQ(trace->map.title, "Fish");
    ASSERT_EQ(trace->map.labels.size(), 2U);
    // The figure's outline surrounds its label.
    const Position label = trace->map.labels[0].place;
    double nearest_m = 1.0;
    for (const Outline& outline : trace->map.outlines)
        for (const Position p : outline.points)
            nearest_m = std::min(nearest_m, std::abs(p.x - label.x) + std::abs(p.y - label.y));
    EXPECT_LT(nearest_m, 0.02);
}

TEST(SideCar, FirstLineIsTheTitle) {
    TactileMap told;
    tell("\xef\xbb\xbf\n The fish\r\nA fish that\nswims\n", told);
    EXPECT_EQ(told.title, "The fish");
    EXPECT_EQ(told.description, "A fish that swims");
    TactileMap short_one;
    tell("A fish\n", short_one);
    EXPECT_EQ(short_one.title, "");
    EXPECT_EQ(short_one.description, "A fish");
}

/// As Windows' editor saves them: "ANSI", "Unicode", "Unicode big endian"; the latter two also
/// without their byte order mark, and once with the line ends of old Macs.
TEST(SideCar, IsReadInWhateverCodeItWasSaved) {
    const std::string ansi =
        "Schlo\xdf Neuschwanstein\r\nDie T\xfcrme \x96 von S\xfc"
        "den\r\n";
    const std::u16string wide =
        u"Schlo\u00df Neuschwanstein\r\nDie T\u00fcrme \u2013 von S\u00fcden\r\n";
    std::string little = "\xff\xfe";
    std::string big = "\xfe\xff";
    for (const char16_t unit : wide) {
        little += {static_cast<char>(unit & 0xff), static_cast<char>(unit >> 8)};
        big += {static_cast<char>(unit >> 8), static_cast<char>(unit & 0xff)};
    }
    std::string of_old_macs = ansi;
    std::erase(of_old_macs, '\n');
    for (const std::string& text :
         {ansi, little, big, little.substr(2), big.substr(2), of_old_macs}) {
        TactileMap told;
        tell(text, told);
        EXPECT_EQ(told.title, "Schlo\u00df Neuschwanstein");
        EXPECT_EQ(told.description, "Die T\u00fcrme \u2013 von S\u00fcden");
    }
    TactileMap cut;
    tell(little.substr(0, 9), cut);
    EXPECT_EQ(cut.description, "Sch");
}

TEST(SideCar, WhatIsNoTextChangesNothing) {
    TactileMap told;
    told.description = "before";
    tell(std::string("a\0b", 3), told);
    tell(std::string(40, '\0'), told);
    tell("", told);
    tell(" \n ", told);
    tell(std::string(max_side_car_bytes + 1, 'a'), told);
    EXPECT_EQ(told.description, "before");
}

TEST(SideCar, LiesBeside) {
    EXPECT_EQ(side_car_of("/a/fish.png"), "/a/fish.txt");
    EXPECT_EQ(side_car_of("boat.jpg"), "boat.txt");
    EXPECT_EQ(side_car_of("a.b.pdf"), "a.b.txt");
    EXPECT_EQ(side_car_of("boat"), "boat.txt");
}

/// A sample's name is its ending.
TEST(FileFormats, EveryOneHasASampleWhoseEndingTheStickOffers) {
    std::set<FileFormat> seen;
    for (const NamedFile& file : files_of_formats()) {
        const FileFormat format = format_of(file.bytes);
        const FormatFacts* const facts = format_ending_in(in_small_letters(file.name));
        ASSERT_NE(facts, nullptr) << file.name;
        EXPECT_EQ(static_cast<int>(facts->format), static_cast<int>(format)) << file.name;
        EXPECT_EQ(static_cast<int>(facts->worker), static_cast<int>(kind_of(file.bytes)));
        const auto kind = kind_of_name("boat." + file.name);
        EXPECT_TRUE(kind == StickFileKind::picture || kind == StickFileKind::document) << file.name;
        seen.insert(format);
    }
    for (const FormatFacts& facts : file_formats)
        EXPECT_TRUE(seen.contains(facts.format) || facts.format == FileFormat::office)
            << facts.endings[0];
}

TEST(OneSpaced, HidesNothing) {
    EXPECT_EQ(one_spaced("  a\n\tb \x1b[2J c\u202eevil\u200b ", 100), "a b [2J c evil");
    EXPECT_EQ(one_spaced(std::string(50, 'a'), 10), std::string(10, 'a') + "...");
    EXPECT_EQ(one_spaced("", 10), "");
}

}  // namespace
}  // namespace touchline
